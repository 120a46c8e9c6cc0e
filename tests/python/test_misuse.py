"""What no program does that is right: it ends with an exception, not with the
process."""

import textwrap
import unittest

from support import python, source

# Objects of all classes by __new__() alone, and what can be asked of them.
uninitialised = """
import libcontact
from libcontact import _core

def refused(call, *arguments):
    try:
        call(*arguments)
    except TypeError as error:
        return str(error) == "__init__() of an argument has not been called"
    raise AssertionError(call)

classes = [of for module in (libcontact, _core) for of in vars(module).values()
           if type(of).__name__ == "pybind11_type"]
said = 0
for of in classes:
    made = of.__new__(of)
    for name, member in vars(getattr(_core, of.__name__)).items():
        if isinstance(member, property):
            assert refused(getattr, made, name), name
        elif callable(member) and name != "__init__":
            said += refused(getattr(made, name))
case, joint = (of.__new__(of) for of in (libcontact.Case, libcontact.Joint))
solution = _core.Solution.__new__(_core.Solution)
for call, *arguments in (
    (repr, joint), (repr, case), (repr, solution), (len, solution),
    (libcontact.Run, case), (libcontact.Case.run, case),
    (libcontact.Joint.solve, joint, [0, 0, 1], [0, 0, 1]), (joint._same, joint),
    (hip._same, joint),
    (libcontact.identify, joint, np.ones((9, 3)), np.ones((9, 3)), np.ones(9)),
    (libcontact.Run.advance_to, libcontact.Run.__new__(libcontact.Run), 1),
):
    assert refused(call, *arguments), call

class Early(libcontact.Joint):
    def __init__(self):
        assert refused(repr, self)
        metal = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
        super().__init__(kind="ball", radius_mm=14, radial_clearance_um=100,
                         inner=metal, outer=metal)

print(len(classes), said, Early().kind)
"""

# Threads that are in C++ when the interpreter ends: with its lock and without.
work = {
    "rows": "hip.solve(np.ones((5000, 3)), [1, 0, 1])",
    "fit": """libcontact.identify(
        hip, np.arange(30, 300).reshape(90, 3), [1, 0, 1], np.ones(90))""",
    "joint": "hip.replace({'name': 'x'})",
    "run": "libcontact.Run(stages).advance_to(2)",
    "told": "libcontact.Run(stages).advance_to(2, progress=print)",
}
endless = """
stages = libcontact.Case.from_file("data/cases/two_stage_turn.toml")

def work():
    while True:
        {}

for _ in range(3):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.4)
"""


def process(code):
    start = textwrap.dedent("""
        import pickle, threading, time
        import libcontact
        import numpy as np
        hip = libcontact.Joint.from_file("data/joints/hip_cocr_uhmwpe.toml")
        """)
    return python(start + code, cwd=source)


class OwnProcess(unittest.TestCase):
    def test_uninitialised_objects_are_refused(self):
        done = process(uninitialised)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        classes, said, early = done.stdout.split()
        self.assertGreater(int(classes), 10)
        self.assertGreater(int(said), 10)
        self.assertEqual(early, "ball")

    def test_ends_while_daemons_work(self):
        for kind, line in work.items():
            for _ in range(3):
                done = process(endless.format(line))
                self.assertEqual((done.returncode, done.stderr), (0, ""), kind)


if __name__ == "__main__":
    unittest.main()
