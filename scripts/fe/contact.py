"""The contact of a joint file by finite elements, of first order in its clearance.

Node to node on one radius, without friction, exact complementarity: what the
library assumes, by none of its formulas.
"""
import tomllib

import numpy as np

from body import Body


class Joint:
    """A joint file with plain keys in mm and MPa."""

    def __init__(self, path):
        with open(path, "rb") as file:
            keys = tomllib.load(file)
        geometry = keys["geometry"]
        self.round = keys["kind"] == "ball"
        self.radius = geometry["radius_mm"]
        self.clearance = geometry["radial_clearance_mm"]
        self.length = geometry.get("length_mm", 1)

        def material(of):
            return of["youngs_modulus_MPa"], of["poissons_ratio"]
        self.inner = material(keys["materials"]["inner"])
        wall = keys.get("wall", {"backing": "held", "layer": [
            dict(keys["materials"]["outer"], thickness_mm=59 * self.radius)]})
        self.layers = [(layer["thickness_mm"],) + material(layer)
                       for layer in wall["layer"]]
        self.backing = wall["backing"]


def graded(start, end, size, largest, growth=1.3):
    """Places from a fine size at the start on; sizes follow the radius inwards."""
    places, way = [start], np.sign(end - start)
    while (end - places[-1]) * way > 1e-12:
        here = abs(places[-1])
        limit = .35 * here if way < 0 else largest * max(1, here / start)
        places.append(places[-1] + way * min(size, limit, largest * 1e9))
        size = min(size * growth, limit)
    places = np.array(places)
    if end < .1 * start:
        return np.append(places[places > 1.3 * end], end)
    return start + (places - start) * (end - start) / (places[-1] - start)


def angles(half_angle, n):
    """n elements in the contact, finer at its end, to 180 deg."""
    if half_angle > 3:
        return np.linspace(0, np.pi, n + 1)
    even, edge = half_angle / n, half_angle / n / 5
    largest = .12 * 20 / max(n, 20)
    places = [0.]
    while places[-1] < np.pi - 1e-9:
        size = 0
        for _ in range(2):  # the size of its middle
            middle = places[-1] + size / 2
            size = min(edge + .35 * abs(middle - half_angle),
                       even if middle < half_angle else largest)
        places.append(places[-1] + size)
    return np.append(np.array(places[:-1]) * np.pi / places[-1], np.pi)


class Contact:
    """@param n      elements in the contact
    @param clearance  by which the hole's radius is larger, 0 in first order"""

    def __init__(self, joint, half_angle, n, clearance=0):
        self.joint, self.half_angle = joint, half_angle
        rho = joint.radius
        t = angles(half_angle, n)
        size = .6 * half_angle / n * rho
        largest = .12 * 20 / max(n, 20) * rho
        radii = graded(rho, .001 * rho, size, largest)[::-1]
        self.inner = Body(radii, t, [joint.inner] * (len(radii) - 1), joint.round)
        radii, self.material_rows = [rho + clearance], []
        self.materials = [material for _, *material in joint.layers]
        for thickness, *_ in joint.layers:
            size = min(size, thickness / 4)
            part = graded(radii[-1], radii[-1] + thickness, size, largest)
            radii += list(part[1:])
            self.material_rows.append(len(part) - 1)
            size = part[-1] - part[-2]
        rows = [material for material, count in
                zip(self.materials, self.material_rows) for _ in range(count)]
        self.outer = Body(np.array(radii), t, rows, joint.round)
        self.t = self.inner.t
        self.mass = self.inner.circle_matrix(True)
        # Without the nodes on the axis, which carry nothing in the round.
        weight = self.mass.sum(1)
        self.nodes = np.where(weight > 1e-9 * weight.max())[0]

    def held_nodes(self):
        """The outer body's degrees of freedom that do not move, and the shares of
        a traction like cos t on its outer circle that carries 1."""
        out = self.outer.circle(True)
        across = 2 * np.where(self.outer.x == 0)[0]
        if self.joint.backing == "rigid":
            return np.concatenate([across, 2 * out, 2 * out + 1]), None
        share = self.outer.circle_matrix(True).sum(1) * np.cos(self.t)
        return np.append(across, 2 * out[-1] + 1), share / (
            share @ np.cos(self.t))

    def outer_shift(self, u):
        """How far the outer circle has moved along the load, as cos t."""
        out = self.outer.circle(True)
        weight = self.outer.circle_matrix(True).sum(1) * np.cos(self.t)
        radial = (u[2 * out].T * np.sin(self.t) + u[2 * out + 1].T *
                  np.cos(self.t)).T
        return weight @ radial / (weight @ np.cos(self.t))

    def compliance(self):
        """Approach of the two circles under radial forces on their nodes."""
        t = self.t[self.nodes]
        sine, cosine, columns = np.sin(t), np.cos(t), np.arange(len(t))

        def radial(body, circle):
            forces = np.zeros((2 * len(body.x), len(t)))
            at = body.circle(circle)[self.nodes]
            forces[2 * at, columns], forces[2 * at + 1, columns] = sine, cosine
            return forces, at
        # The ball or pin: pressed inwards, held by a uniform force in it, and
        # where it is by the mean of its volume.
        body = self.inner
        forces, at = radial(body, True)
        volume = body.volume / body.volume.sum()
        forces = -forces
        forces[1::2] += np.outer(volume, cosine)
        u = body.solve(forces, np.append(2 * np.where(body.x == 0)[0],
                                         2 * body.number[0, 0] + 1))
        u[1::2] -= volume @ u[1::2]
        of_inner = -(u[2 * at].T * sine + u[2 * at + 1].T * cosine).T
        forces, at = radial(self.outer, False)
        fixed, share = self.held_nodes()
        if share is not None:
            out = self.outer.circle(True)
            forces[2 * out] -= np.outer(share * np.sin(self.t), cosine)
            forces[2 * out + 1] -= np.outer(share * np.cos(self.t), cosine)
        u = self.outer.solve(forces, fixed)
        if share is not None:
            u[1::2] -= self.outer_shift(u)
        return of_inner + (u[2 * at].T * sine + u[2 * at + 1].T * cosine).T

    def solve(self, load):
        """Pressures along t, and the shift of the centres, mm."""
        c, t = self.compliance(), self.t[self.nodes]
        load = load if self.joint.round else load / 2 / self.joint.length
        eps = self.joint.clearance
        contact = t < .8
        for _ in range(200):
            k = contact.sum()
            matrix = np.zeros((k + 1, k + 1))
            matrix[:k, :k] = c[np.ix_(contact, contact)]
            matrix[:k, k], matrix[k, :k] = -np.cos(t[contact]), np.cos(t[contact])
            found = np.linalg.solve(matrix, np.append(-eps * np.ones(k), load))
            force, shift = np.zeros(len(t)), found[k]
            force[contact] = found[:k]
            gap = c @ force + eps - shift * np.cos(t)
            better = np.where(contact, force > 0, gap < -1e-14)
            if (better == contact).all():
                break
            contact = better
        return self.pressures(force, contact), shift

    def pressures(self, force, contact):
        """Pressures whose consistent forces on the nodes are these."""
        there = self.nodes[contact]
        if self.joint.round:
            there = np.union1d(0, there)
        whole, p = np.zeros(len(self.t)), np.zeros(len(self.t))
        whole[self.nodes] = force
        p[there] = np.linalg.solve(self.mass[np.ix_(there, there)], whole[there])
        return p


def middle_of(t, p, half_angle):
    """p(0) by a polynomial in cos t over half the contact."""
    near = (t > 0) & (t < half_angle / 2)
    return np.polyval(np.polyfit(np.cos(t[near]), p[near], 4), 1)
