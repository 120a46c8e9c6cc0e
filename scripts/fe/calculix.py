"""The same contact by CalculiX: true radii, surface to surface by penalty."""
import os
import subprocess

import numpy as np

from contact import Contact

DECK = """*NODE, NSET=ALL
{nodes}
*MATERIAL, NAME=INNER
*ELASTIC
{inner[0]!r}, {inner[1]!r}
*DENSITY
{density:.13g}
{elements}
*NSET, NSET=MIDDLE
{middle}
*NSET, NSET=OUT
{out}
*SURFACE, NAME=INSIDE
{inside}
*SURFACE, NAME=OUTSIDE
{outside}
*BOUNDARY
MIDDLE, 1, 1
{held}, 2, 2
*SURFACE INTERACTION, NAME=CONTACT
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
{penalty!r}
*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE
OUTSIDE, INSIDE
*STEP, INC=100
*STATIC, DIRECT
1., 1.
*DLOAD
BALL, GRAV, 1., 0., 1., 0.
{loads}
*NODE PRINT, NSET=ALL
U
*END STEP
"""


def lines(numbers):
    return "\n".join(f"{n}," for n in numbers)


def elements(body, name, kind, first_node, first, rows, material):
    """Some rows of elements, a set of one material."""
    text = [f"*ELEMENT, TYPE={kind}, ELSET={name}"]
    for k in range(len(body.elements)):
        if rows[0] <= k % body.rows < rows[1]:
            nodes = ", ".join(str(n + first_node) for n in body.elements[k])
            text.append(f"{first + k}, {nodes}")
    text.append(f"*SOLID SECTION, ELSET={name}, MATERIAL={material}")
    return "\n".join(text + ([] if kind == "CAX8" else ["1."]))


def deck(contact, load, shift, penalty):
    joint, inner, outer = contact.joint, contact.inner, contact.outer
    kind = "CAX8" if joint.round else "CPE8"
    after = len(inner.x) + 1  # the outer body's first node
    there = len(inner.elements) + 1  # and element
    place = [f"{k + 1}, {x:.13g}, {y + shift:.13g}" for k, (x, y) in
             enumerate(zip(inner.x.tolist(), inner.y.tolist()))]
    place += [f"{k + after}, {x:.13g}, {y:.13g}" for k, (x, y) in
              enumerate(zip(outer.x.tolist(), outer.y.tolist()))]
    text = [elements(inner, "BALL", kind, 1, 1, (0, inner.rows), "INNER")]
    row = 0
    for k, (e, nu) in enumerate(contact.materials):
        count = contact.material_rows[k]
        text.append(f"*MATERIAL, NAME=LAYER{k}\n*ELASTIC\n{e!r}, {nu!r}\n*DENSITY\n1e-12")
        text.append(elements(outer, f"SEAT{k}", kind, after, there,
                             (row, row + count), f"LAYER{k}"))
        row += count
    near = [k for k in range(inner.columns)
            if contact.t[2 * k] < 1.35 * contact.half_angle]
    out = outer.circle(True)
    fixed, share = contact.held_nodes()
    loads = []
    if share is not None:
        loads = ["*CLOAD"]
        for node, t, part in zip(out, contact.t, share * load):
            if outer.x[node] > 0:
                loads.append(f"{node + after}, 1, {-part * np.sin(t):.12g}")
            loads.append(f"{node + after}, 2, {-part * np.cos(t):.12g}")
    held = str(out[-1] + after)
    if share is None:
        held = "OUT, 1, 1\nOUT"
    middle = np.append(np.where(inner.x == 0)[0] + 1,
                       np.where(outer.x == 0)[0] + after)
    return DECK.format(
        nodes="\n".join(place), inner=joint.inner, penalty=penalty,
        density=float(load / inner.volume.sum()), elements="\n".join(text),
        middle=lines(middle), out=lines(out + after), held=held,
        inside=lines(f"{(k + 1) * inner.rows}, S3" for k in near),
        outside=lines(f"{there + k * outer.rows}, S1" for k in near),
        loads="\n".join(loads))


def run(joint, half_angle, n, load, shift, folder):
    """Pressures along t, by the forces that its displacements ask of the inner
    body, and the shift of the centres. The deck stays in the folder."""
    contact = Contact(joint, half_angle, n, joint.clearance)
    load = load if joint.round else load / 2 / joint.length
    # Overlaps stay at 1e-5 to 1e-3 of the displacements.
    softest = min([joint.inner[0]] + [e for _, e, _ in joint.layers])
    penalty = 1e4 * softest / joint.radius
    path = os.path.join(folder, "deck")
    with open(path + ".inp", "w") as file:
        file.write(deck(contact, load, shift, penalty))
    done = subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True,
                          text=True, env=dict(os.environ, OMP_NUM_THREADS="1"))
    if "Job finished" not in done.stdout:
        raise SystemExit(f"CalculiX: {path}.inp: {done.stdout[-400:]}")
    inner, outer = contact.inner, contact.outer
    u = np.zeros((len(inner.x) + len(outer.x), 2))
    with open(path + ".dat") as file:
        for words in map(str.split, file):
            if len(words) == 4 and words[0].isdigit():
                u[int(words[0]) - 1] = words[1], words[2]
    of_inner, of_outer = u[:len(inner.x)], u[len(inner.x):].ravel()
    force = inner.forces(of_inner.ravel())
    force[1::2] -= inner.volume * load / inner.volume.sum()
    at, t = inner.circle(True), contact.t
    pressing = -(force[2 * at] * np.sin(t) + force[2 * at + 1] * np.cos(t))
    # Nodes inside alone: at the contact's end penalties leave small forces.
    inside = np.cumsum(pressing[::-1] > 1e-4 * pressing.max())[::-1] > 0
    p = contact.pressures(pressing[contact.nodes], inside[contact.nodes])
    shift += inner.volume @ of_inner[:, 1] / inner.volume.sum()
    if joint.backing != "rigid":
        shift -= contact.outer_shift(of_outer)
    return t, p, shift
