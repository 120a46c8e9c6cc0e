"""The contacts of data/reference/finite_elements/book.csv by finite elements,
beside the programs:

    scripts/fe/check.py BUILD_DIR [--elements N,2N] [--calculix] [CASE...]

prints a table and fails where the two differ by more than the numbers of the two
meshes do, and 1e-4. --calculix asks CalculiX
(ccx), whose answers with true radii differ by twice the relative clearance and
1e-3 more. CASE is a name of the book.
"""
import argparse
import csv
import math
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(__file__))
import calculix  # noqa: E402
from contact import Contact, Joint, middle_of  # noqa: E402

BOOK = os.path.join(os.path.dirname(__file__),
                    "../../data/reference/finite_elements")


def ours(build, joint, path, load):
    """p(0), MPa, and the shift of the centres, mm."""
    def row(*options):
        done = subprocess.run(
            [os.path.join(build, "bin/hinge-pressure"), "--joint", path,
             "--load", repr(load), "--law", "exact", "--pressure", "exact",
             *options], check=True, capture_output=True, text=True)
        return next(csv.DictReader(done.stdout.split("\n")))
    of = row("--summary")
    shift = float(of["approach_m"]) * 1e3 + joint.clearance \
        if of["approach_m"] else float(of.get("shift_m") or "nan") * 1e3
    return float(row("--points", "3")["p_exact_Pa"]) / 1e6, shift


def contacts(names):
    """(case, half-angle, joint file, load) of the book."""
    with open(os.path.join(BOOK, "book.csv")) as file:
        found = {(row["case"], float(row["theta0_deg"]), row["joint_file"],
                  float(row["load_N"])) for row in csv.DictReader(file)}
    return sorted(one for one in found if not names or one[0] in names)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build")
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--elements", default="20,40")
    parser.add_argument("--calculix", action="store_true")
    given = parser.parse_intermixed_args()
    counts = [int(n) for n in given.elements.split(",")]
    print("| case | theta0, deg | quantity | ours | "
          + " | ".join(f"n = {n}" for n in counts)
          + " | extrapolated | difference |\n" + "|---" * (6 + len(counts)) + "|")
    is_good = True
    for case, degrees, file, load in contacts(given.cases):
        path, half_angle = os.path.join(BOOK, file), math.radians(degrees)
        joint = Joint(path)
        expected = ours(given.build, joint, path, load)
        found = []
        for n in counts:
            if given.calculix:
                with tempfile.TemporaryDirectory() as folder:
                    t, p, shift = calculix.run(joint, half_angle, n, load,
                                               expected[1], folder)
            else:
                contact = Contact(joint, half_angle, n)
                t, (p, shift) = contact.t, contact.solve(load)
            # The axis of CalculiX' round contacts is wrong.
            middle = math.nan if given.calculix and joint.round else \
                middle_of(t, p, half_angle)
            found.append((middle, shift))
        for k, name in enumerate(["p(0), MPa", "shift, mm"]):
            values = [one[k] for one in found]
            end = values[-1]
            if len(values) > 1 and not given.calculix:
                end += (values[-1] - values[-2]) / 3
            if math.isnan(end + expected[k]):
                continue
            bar = abs(values[-1] - values[0]) / abs(end) + 1e-4
            if given.calculix:
                bar = 1e-3 + 2 * abs(joint.clearance) / joint.radius
            off = end / expected[k] - 1
            is_good = is_good and abs(off) < bar
            print(f"| {case} | {degrees:g} | {name} | {expected[k]:.7g} | "
                  + " | ".join(f"{v:.7g}" for v in values)
                  + f" | {end:.7g} | {off:+.1e}{'' if abs(off) < bar else ' !'} |",
                  flush=True)
    sys.exit(0 if is_good else 1)


main()
