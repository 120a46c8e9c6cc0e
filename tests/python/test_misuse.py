"""Misuse, which no right program does: it ends with an exception, not with the
process."""

import inspect
import pickle
import tempfile
import textwrap
import unittest
from pathlib import Path

import libcontact
import numpy as np
from support import hip_file, python, random_rows, source

hip = libcontact.Joint.from_file(hip_file)
answers = {
    "Solution": hip.solve(*random_rows(4)),
    "RestSolution": hip.at_rest(*random_rows(4)),
    "Rating": hip.pv(*random_rows(4)),
    "Coefficients": libcontact.friction_coefficients(
        np.full(4, 0.5), np.full(4, 0.1)),
}  # fmt: skip


def names_of(type_of_answers):
    return [
        name
        for name, of in inspect.getmembers(type_of_answers)
        if isinstance(of, property) and name not in ("shape", "slip")
    ]


class Pickled(unittest.TestCase):
    """Answers, as named arrays."""

    def test_say_the_same(self):
        for name, one in answers.items():
            state = one.__getstate__()
            self.assertEqual(sorted(state), names_of(type(one)))
            again = pickle.loads(pickle.dumps(one))
            self.assertEqual(type(again).__name__, name)
            self.assertEqual(again.shape, (4,))
            self.assertEqual(len(again), 4)
            self.assertEqual(repr(again), repr(one))
            for key, array in state.items():
                np.testing.assert_array_equal(array, getattr(one, key))
                np.testing.assert_array_equal(array, getattr(again, key))
            columns = one.to_dict()
            self.assertEqual(list(again.to_dict()), list(columns))
            for key, column in again.to_dict().items():
                np.testing.assert_array_equal(column, columns[key])

    def test_of_every_shape(self):
        for shape in (), (0,), (2, 3), (2, 0, 3):
            reaction = np.ones((*shape, 3))
            one = hip.solve(reaction, [1, 0, 1])
            again = pickle.loads(pickle.dumps(one))
            self.assertEqual(again.shape, shape)
            np.testing.assert_array_equal(again.normal, one.normal)
            np.testing.assert_array_equal(again.power, one.power)
            self.assertEqual(type(again.power), type(one.power))

    def test_equal_ones_have_equal_bytes(self):
        rows = random_rows(50)
        bytes_of = {pickle.dumps(hip.solve(*rows)) for _ in range(5)}
        again = pickle.loads(next(iter(bytes_of)))
        bytes_of.add(pickle.dumps(again))
        self.assertEqual(len(bytes_of), 1)

    def test_nobody_writes_into_them(self):
        again = pickle.loads(pickle.dumps(answers["Solution"]))
        for one in again, answers["Solution"], answers["Solution"][1:]:
            with self.assertRaisesRegex(ValueError, "read-only"):
                one.power[:] = 7
            self.assertIs(one.power, one.power)

    def test_that_do_not_fit_are_refused(self):
        state = answers["Solution"].__getstate__()

        def refusal(**changed):
            made = type(answers["Solution"]).__new__(type(answers["Solution"]))
            with self.assertRaises(libcontact.Error) as caught:
                made.__setstate__({**state, **changed})
            with self.assertRaises(TypeError):
                made.power  # it is none yet
            return str(caught.exception)

        of_four = "the pickle's power must be an array of float64 of shape (4,)"
        for power in (
            np.zeros(3), np.zeros(10**6), np.zeros((4, 1)), np.float64(0),
            np.zeros(4, "float32"), np.zeros(4, ">f8"), np.zeros(4, int),
            np.zeros(4, complex), [0.0] * 4, None, "1234",
        ):  # fmt: skip
            self.assertEqual(refusal(power=power), of_four)
        self.assertEqual(
            refusal(normal=np.zeros(4)),
            "the pickle's normal must be an array of float64 of shape (4, 3)")
        self.assertEqual(
            refusal(status=np.zeros(4)),
            "the pickle's status must be an array of int32")
        self.assertRegex(
            refusal(status=np.zeros(3, "i4")), "of shape \\(3,\\)$")
        self.assertRegex(
            refusal(colour=np.zeros(4)), "^the pickle's names must be status, ")
        del state["power"]
        self.assertEqual(refusal(), of_four)

    def test_of_old_protocols_are_read(self):
        for protocol in 0, 1:
            again = pickle.loads(pickle.dumps(answers["Solution"], protocol))
            np.testing.assert_array_equal(again.power, answers["Solution"].power)

    def test_by_any_protocol_or_not_at_all(self):
        done = process(by_protocols)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "")

    def test_in_any_order_of_memory_are_taken(self):
        state = answers["Solution"].__getstate__()
        state["normal"] = np.asfortranarray(state["normal"])
        state["power"] = np.repeat(state["power"], 2)[::2]
        again = type(answers["Solution"]).__new__(type(answers["Solution"]))
        again.__setstate__(state)
        np.testing.assert_array_equal(again.normal, answers["Solution"].normal)
        np.testing.assert_array_equal(again.power, answers["Solution"].power)


# An object of every class of _core: all protocols do the same, and so does
# __reduce__(). An early protocol of pybind11's own ends the process.
by_protocols = """
from libcontact import _core

cup = libcontact.Joint.from_file("data/joints/hip_cup.toml")
bush = libcontact.Joint.from_file("data/joints/relieved_bush.toml")
rows = [[0, 0, 2e3]] * 4, [[1, 0, 1]] * 4
solution = hip.solve(*rows)
case = libcontact.Case.from_file("data/cases/two_stage_turn.toml")
made = [
    hip, hip.vary({"geometry.radius_mm": [14, 15]}), solution,
    hip.at_rest(*rows), hip.pv(*rows),
    libcontact.friction_coefficients([0.5], [0.1]),
    hip.step(*rows, rows[0], np.eye(3)), case, libcontact.Run(case),
    cup, cup.without_seat(),
    libcontact.Play(hip), bush, bush.without_relief(), libcontact.WornSeat(),
    hip.moment_set(solution),
]

def outcome(dump, *arguments):
    try:
        dump(*arguments)
    except TypeError as error:
        return str(error).replace("'_core.", "'").replace("'libcontact.", "'")
    return "pickled"

kept = {"Run", "Play", "WornSeat", "MomentSet"}
for one in made:
    outcomes = {outcome(pickle.dumps, one, k) for k in range(6)}
    outcomes.add(outcome(one.__reduce__))
    name = type(one).__name__
    told = {f"cannot pickle '{name}' object"} if name in kept else {"pickled"}
    if outcomes != told:
        print(name, outcomes)
for name, of in vars(_core).items():
    if type(of).__name__ == "pybind11_type":
        for call in *((of.__new__(of).__reduce_ex__, k) for k in range(6)), \\
                (of.__new__(of).__reduce__,):
            if outcome(*call) == "pickled":
                print(name, call)
"""

# Objects of all classes by __new__() alone, and their attributes.
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
    (libcontact.Joint.solve, joint, [0, 0, 1], [0, 0, 1]),
    (libcontact.Joint.__eq__, joint, hip), (libcontact.Joint.__eq__, hip, joint),
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


class Messages(unittest.TestCase):
    def test_have_no_control_characters(self):
        text = (source / "data/cases/slosh.toml").read_text()
        text = text.replace('name = "fuel"', r'name = "\u001b[2J"')
        text = text.replace('body = "tank"', 'body = "tanks"')
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "case.toml"
            file.write_text(text)
            with self.assertRaises(libcontact.Error) as caught:
                libcontact.Case.from_file(file)
        self.assertIn(r"(tank, \x1b[2J", str(caught.exception))
        self.assertNotIn("\x1b", str(caught.exception))


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
