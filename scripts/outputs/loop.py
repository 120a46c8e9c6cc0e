#!/usr/bin/python3
"""Numbers of the Python package with all digits: loop.py JOINT..."""
import sys
import warnings

import libcontact
import numpy as np

warnings.simplefilter("ignore")
angles = np.linspace(0, np.pi, 7)
# On a ball, and across a pin's axis.
forces = np.array([[1e3 * np.sin(b), 2e2 * np.cos(3 * b), 1e3 * np.cos(b)]
                   for b in angles])
rates = np.array([[0.1, 0.2 * np.cos(b), 0.5] for b in angles])
z = np.array([0, 0, 1])


def show(name, solution, keys):
    for key in keys:
        numbers = np.ravel(np.asarray(getattr(solution, key), dtype=float))
        print(name, key, *("%.17g" % number for number in numbers))


for file in sys.argv[1:]:
    joint = libcontact.Joint.from_file(file)
    axis = z if joint.kind == "pin" else None
    rate = rates * z if joint.kind == "pin" else rates
    keys = ("status", "friction_moment", "friction_force", "peak_pressure",
            "half_angle", "contact_area", "power")
    show(file, joint.solve(forces, rate, axis=axis), keys)
    rest = joint.at_rest(forces, 0.1 * rate, axis=axis)
    show(file + " rest", rest, ("utilisation", "direction"))
