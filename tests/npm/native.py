"""The library's own numbers for states.json of package_test.js, through Python,
whose results are bit-identical to the C++ library."""

import json
import sys

import libcontact
import numpy as np

answers = {}
for file, s in json.load(sys.stdin).items():
    joint = libcontact.Joint.from_file(file)
    if s["without_seat"]:
        joint = joint.without_seat()
    axis = s["axis"]
    slip = joint.solve(s["reactions"], s["rates"], axis=axis)
    rest = joint.at_rest(s["reactions"], s["moments"], axis=axis)
    answers[file] = answer = {
        key: np.asarray(getattr(slip, key)).tolist() for key in s["keys"]
    }
    answer["status"] = slip.status.tolist()
    answer["utilisation"] = rest.utilisation.tolist()
    # Steps that begin from nothing, as the first of a simulation.
    inertia = np.reshape(s["inertia"], (3, 3))
    steps = [
        joint.step(r, w, f, inertia, axis=axis)
        for r, w, f in zip(s["reactions"][:5], s["rates"], s["free"])
    ]
    answer["step_holds"] = [bool(step.holds) for step in steps]
    answer["step_moment"] = [step.moment.tolist() for step in steps]
    answer["step_rate"] = [step.angular_velocity.tolist() for step in steps]
json.dump(answers, sys.stdout)
