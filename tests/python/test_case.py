"""Cases: what hinge-separation says of them."""

import copy
import csv
import json
import pickle
import signal
import tempfile
import unittest
import warnings
from pathlib import Path

import libcontact
import numpy as np
from support import program, source

file = source / "data/cases/two_stage_turn.toml"
stages = libcontact.Case.from_file(file)


class Run(unittest.TestCase):
    def test_comes_to_what_hinge_separation_says(self):
        times = []
        outcome = stages.run(progress=lambda *at: times.append(at))
        with tempfile.TemporaryDirectory() as folder:
            history = Path(folder) / "history.csv"
            said, _ = program(
                "hinge-separation", file, "--history", history)  # fmt: skip
            with open(history) as lines:
                rows = list(csv.DictReader(lines))
        self.assertEqual(outcome.summary, json.loads(said))
        self.assertEqual(list(outcome.history), list(rows[0]))
        for name, column in outcome.history.items():
            if name.endswith(".mode"):
                self.assertEqual(list(column), [row[name] for row in rows])
            else:
                of_program = [float(row[name] or "nan") for row in rows]
                np.testing.assert_array_equal(column, of_program)
        (release,) = outcome.events
        self.assertEqual(release.body, "stage")
        self.assertEqual(
            release.time,
            outcome.summary["bodies"][0]["at_release"]["time_s"])
        self.assertEqual(outcome.failure, "")
        self.assertEqual(times[0], (0.0, stages["run.end_time_s"]))

    def test_warns_of_contacts_beyond_the_theory(self):
        steel = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3}
        joint = {
            "name": "tiny", "kind": "pin", "friction": {"coefficient": 0.1},
            "geometry": {"radius_mm": 1, "radial_clearance_um": 1,
                         "length_mm": 1},
            "materials": {"inner": steel,
                          "outer": steel | {"limit_pressure_MPa": 40}},
        }  # fmt: skip
        case = libcontact.Case({
            "name": "wheel", "gravity_m_per_s2": [0, 0, -10],
            "run": {"end_time_s": 0.1, "output_step_s": 0.1},
            "carrier": {"name": "ground", "fixed": True},
            "body": [{
                "name": "wheel", "mass_kg": 20,
                "principal_inertia_kg_m2": [2, 3, 3],
                "start": {"rate_deg_per_s": 200},
                "hinge": {"kind": "axis", "axis": [0, 1, 0],
                          "joint": [joint]},
            }],
        })  # fmt: skip
        said = (r"joint tiny: peak pressure \d+\.?\d* MPa is above 40 MPa, the "
                "limit pressure of the outer body")
        with self.assertWarnsRegex(libcontact.ContactWarning, said) as caught:
            case.run()
        self.assertEqual(caught.filename, __file__)
        run = libcontact.Run(case)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run.advance_to(0.05)
        with self.assertWarnsRegex(libcontact.ContactWarning, said) as caught:
            run.advance_to(1)
        self.assertEqual(caught.filename, __file__)

    def test_leaves_distances_out(self):
        case = libcontact.Case.from_file(source / "data/cases/soyuz.toml")
        case = case.replace({"run.end_time_s": 0.1})
        self.assertTrue(case.run().summary["clearance"])
        self.assertFalse(case.run(clearance=False).summary["clearance"])

    def test_ends_by_ctrl_c_and_by_who_listens(self):
        slow = stages.replace({
            "run.integrator": "rk4", "run.step_s": 1e-6, "run.end_time_s": 2.0})
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        with self.assertRaises(KeyboardInterrupt):
            slow.run()

        def complain(time, end):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            slow.run(progress=complain)


class Files(unittest.TestCase):
    def test_have_keys_also_of_their_joints(self):
        self.assertEqual(stages["run.end_time_s"], 2.6)
        friction = "hinge.joint[1].friction.coefficient"
        self.assertEqual(stages["body[stage]." + friction], 0.25)
        other = stages.replace({"body[1]." + friction: 0.5})
        self.assertEqual(other["body[stage]." + friction], 0.5)
        ideal = stages.replace({"run.friction": "ideal"})
        rate = lambda case: case.run().history["stage.rate_deg_per_s"][-1]
        self.assertLess(rate(other), rate(stages))
        self.assertLess(rate(stages), rate(ideal))

    def test_may_be_dicts(self):
        case = libcontact.Case(stages.to_dict(), folder=file.parent)
        self.assertEqual(case, stages)
        with self.assertRaises(libcontact.Error) as caught:
            libcontact.Case(stages.to_dict() | {"run": {"end_time_s": -1}})
        self.assertEqual(
            str(caught.exception), "run.end_time_s = -1 must be above 0")

    def test_pickle_copy_and_compare(self):
        other = stages.replace(
            {"body[1].hinge.joint[1].friction.coefficient": 0.5})
        for case in stages, other:
            again = pickle.loads(pickle.dumps(case))
            self.assertEqual(again, case)
            self.assertEqual(hash(again), hash(case))
            self.assertIs(copy.copy(case), case)
        self.assertNotEqual(stages, other)

    def test_have_the_messages_of_the_program(self):
        setting = "body[stage].hinge.joint[1].friction.coefficient"
        _, said = program("hinge-separation", file, "--set", setting + "=-1")
        with self.assertRaises(libcontact.Error) as caught:
            stages.replace({setting: -1})
        message = str(caught.exception).replace(f"{source}/", "")
        self.assertEqual(
            said.replace(f"{source}/", ""), f"hinge-separation: {message}\n")


if __name__ == "__main__":
    unittest.main()
