"""Interrupted runs: bit-identical to the whole run, and to C."""

import copy
import ctypes
import itertools
import pickle
import signal
import struct
import threading
import unittest
import warnings
import zlib

import libcontact
import numpy as np
from support import build, source

cases = source / "data/cases"
stages = libcontact.Case.from_file(cases / "two_stage_turn.toml")
slosh = libcontact.Case.from_file(cases / "slosh.toml")
# Bodies on bodies, which leave.
fairing = libcontact.Case.from_file(cases / "fairing_on_stage.toml")
# A second.
slow = stages.replace({
    "run.integrator": "rk4", "run.step_s": 1e-4, "run.end_time_s": 2.0})
# "failed" of the motion: velocities that overflow.
fails = libcontact.Case.from_file(cases / "flywheels.toml").replace(
    {"body[1].start.rate_rpm": 1e300})


class RunOfC:
    """The same from libcontact_c."""

    def __init__(self, path):
        self.c = ctypes.CDLL(build / "lib/libcontact_runs_c.so")
        self.c.contact_run_time.restype = ctypes.c_double
        self.c.contact_run_column_count.restype = ctypes.c_size_t
        self.run = ctypes.c_void_p()
        self.must(self.c.contact_run_open(
            bytes(path), None, ctypes.c_size_t(0), ctypes.byref(self.run)))

    def must(self, status):
        if status != 0:
            raise RuntimeError(status)

    def values_at(self, time):
        self.must(self.c.contact_run_advance(self.run, ctypes.c_double(time)))
        values = np.empty(self.c.contact_run_column_count(self.run))
        self.must(self.c.contact_run_values(
            self.run, values.ctypes.data_as(ctypes.c_void_p),
            ctypes.c_size_t(len(values))))
        return self.c.contact_run_time(self.run), values

    def set_inputs(self, values):
        self.must(self.c.contact_run_set_inputs(
            self.run, (ctypes.c_double * len(values))(*values),
            ctypes.c_size_t(len(values))))

    def close(self):
        self.c.contact_run_free(self.run)


def message_of(call, *arguments):
    try:
        call(*arguments)
    except libcontact.Error as error:
        return str(error)


class Test(unittest.TestCase):
    def assert_same(self, one, other, restored=False):
        """restored: steps are counted from there."""
        self.assertEqual(list(one.history), list(other.history))
        for name, column in one.history.items():
            np.testing.assert_array_equal(column, other.history[name], name)
        self.assertEqual(one.events, other.events)
        if restored:
            one.summary["counts"] = other.summary["counts"]
        self.assertEqual(one.summary, other.summary)
        self.assertEqual(one.failure, other.failure)


class Stepped(Test):
    def test_comes_to_what_the_whole_run_is(self):
        for case in stages, slosh, fairing:
            run = libcontact.Run(case)
            self.assertEqual(run.time, 0)
            self.assertEqual(run.end_time, case["run.end_time_s"])
            times = []
            while run.advance_to(run.time + 0.0137 * run.end_time) == "running":
                times.append(run.time)
                run.values()
            self.assertEqual(len(times), 72)
            self.assertEqual((run.status, run.message), ("finished", ""))
            self.assertEqual(run.time, run.end_time)
            whole = case.run()
            self.assert_same(run.outcome(), whole)
            self.assertEqual(run.events, whole.events)

    def test_is_that_of_c(self):
        for name in "two_stage_turn", "slosh", "fairing_on_stage":
            run = libcontact.Run(
                libcontact.Case.from_file(cases / f"{name}.toml"))
            of_c = RunOfC(cases / f"{name}.toml")
            for part in 0, 0.1234, 0.9, 1:
                run.advance_to(part * run.end_time)
                time, values = of_c.values_at(part * run.end_time)
                self.assertEqual(run.time, time)
                np.testing.assert_array_equal(run.values(), values)
            of_c.close()

    def test_has_its_columns_by_name(self):
        run = libcontact.Run(stages)
        self.assertEqual(run["stage.mode"], "sliding")
        run.advance_to(1.0)
        history = stages.run().history
        self.assertEqual(run.columns, list(history))
        (row,) = np.flatnonzero(history["time_s"] == 1.0)
        for name, column in history.items():
            np.testing.assert_array_equal(run[name], column[row])
        reaction = run[[f"stage.reaction_{i}_N" for i in "xyz"]]
        self.assertEqual(
            list(reaction), [run[f"stage.reaction_{i}_N"] for i in "xyz"])
        self.assertAlmostEqual(
            np.linalg.norm(reaction) / run["stage.reaction_N"], 1, delta=1e-12)
        run.advance_to(2.0)
        self.assertNotEqual(reaction[0], run["stage.reaction_x_N"])
        run.advance_to(2.5)
        self.assertEqual(run["stage.mode"], "released")

    def test_without_distances(self):
        run = libcontact.Run(stages, clearance=False)
        self.assertNotIn("clearance.carrier.stage_m", run.columns)
        run.advance_to(run.end_time)
        self.assert_same(run.outcome(), stages.run(clearance=False))

    def test_that_fails_says_why(self):
        run = libcontact.Run(fails)
        for _ in range(2):  # it stays so
            with self.assertWarnsRegex(RuntimeWarning, "not a finite number"):
                self.assertEqual(run.advance_to(1), "failed")
        self.assertEqual(run.status, "failed")
        self.assertEqual(run.outcome().failure, run.message)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(fails.run().failure, run.message)

    def test_refuses(self):
        run = libcontact.Run(stages)
        run.advance_to(1)
        for time in 0.5, float("nan"):
            self.assertEqual(
                message_of(run.advance_to, time),
                f"time = {time} must be 1 s or later")
        self.assertEqual(
            message_of(lambda: run["stage.angle_dg"]),
            'unknown column "stage.angle_dg": did you mean "stage.angle_deg"?')
        for call in (
            lambda: libcontact.Run("case.toml"),
            lambda: run.restore("text"),
            lambda: pickle.dumps(run),
        ):
            self.assertRaises(TypeError, call)


class Controlled(Test):
    def test_steps_a_hinge_as_its_closed_form(self):
        case = libcontact.Case({
            "name": "boom",
            "run": {"end_time_s": 20, "relative_tolerance": 1e-13,
                    "absolute_tolerance": 1e-13},
            "carrier": {"name": "ground", "fixed": True},
            "body": [{
                "name": "boom", "mass_kg": 20, "com_m": [1.5, 0, 0],
                "principal_inertia_kg_m2": [1, 5, 5],
                "hinge": {"kind": "axis", "axis": [0, 0, 1]}}]})
        run = libcontact.Run(case)
        moment = "boom.applied_hinge_moment_N_m"
        self.assertEqual(run.inputs[moment], 0)
        h, wanted, inertia, p, d = 0.05, 0.4, 5 + 20 * 1.5**2, 60.0, 80.0
        for _ in range(200):
            angle, rate = np.radians(
                run["boom.angle_deg", "boom.rate_deg_per_s"])
            run.set_inputs({moment: p * (wanted - angle) - d * rate})
            run.advance_to(run.time + h)
        # x -> A x + b, of angle and rate, with the moment held over h.
        by = np.array([h**2 / 2, h]) / inertia
        a = np.array([[1, h], [0, 1]]) - np.outer(by, [p, d])
        b = by * p * wanted
        rest = np.linalg.solve(np.eye(2) - a, b)
        x = rest - np.linalg.matrix_power(a, 200) @ rest
        np.testing.assert_allclose(
            np.radians(run["boom.angle_deg", "boom.rate_deg_per_s"]), x,
            rtol=0, atol=1e-10)
        self.assertEqual(
            message_of(run.set_inputs, {moment[:-1]: 1}),
            f'unknown input "{moment[:-1]}": did you mean "{moment}"?')
        self.assertEqual(
            message_of(run.set_inputs, {moment: float("inf")}),
            f"{moment} = inf must be finite")

    def test_is_that_of_c(self):
        file = cases / "flywheels.toml"
        run = libcontact.Run(libcontact.Case.from_file(file))
        of_c = RunOfC(file)
        names = list(run.inputs)
        for step in range(10):
            run.advance_to(0.37 * step)
            time, values = of_c.values_at(0.37 * step)
            np.testing.assert_array_equal(run.values(), values)
            load = -1e-4 * run["wheel_x.rate_deg_per_s"]
            run.set_inputs({"wheel_x.applied_hinge_moment_N_m": load})
            of_c.set_inputs([
                load if name.startswith("wheel_x.applied_hinge") else 0
                for name in names])
        of_c.close()
        other = libcontact.Run(libcontact.Case.from_file(file))
        other.restore(run.save())
        self.assertEqual(other.inputs, run.inputs)
        for each in run, other:
            each.advance_to(10)
        self.assertNotEqual(load, 0)
        np.testing.assert_array_equal(run.values(), other.values())


class Interrupted(Test):
    def test_goes_on_after_ctrl_c(self):
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.15)
        run = libcontact.Run(slow)
        with self.assertRaises(KeyboardInterrupt):
            run.advance_to(run.end_time)
        self.assertEqual(run.status, "stopped")
        self.assertLess(run.time, run.end_time)
        saved = run.save()
        other = libcontact.Run(slow)
        other.restore(saved)
        self.assertEqual(other.time, run.time)
        for each in run, other:
            self.assertEqual(each.advance_to(2.0), "finished")
        self.assert_same(other.outcome(), run.outcome(), restored=True)

    def test_changes_nothing(self):
        run = libcontact.Run(slow)
        stops = itertools.count()

        def complain(time, end):
            if next(stops) == 1:
                raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            run.advance_to(run.end_time, progress=complain)
        self.assertRegex(
            run.message, "^t = [0-9.]+ s: stopped by an exception after ")
        stopped = run.time
        times = []
        status = run.advance_to(
            run.end_time, progress=lambda *at: times.append(at))
        self.assertEqual(status, "finished")
        self.assertEqual(times[0], (stopped, run.end_time))
        self.assert_same(run.outcome(), slow.run())

    def test_leaves_other_threads_their_time_but_is_not_theirs(self):
        run = libcontact.Run(slow)
        seen = []
        on_its_way = threading.Event()

        def look(time, end):
            on_its_way.set()
            seen.append(message_of(lambda: run.time))

        thread = threading.Thread(
            target=run.advance_to, args=(2.0,), kwargs={"progress": look})
        thread.start()
        on_its_way.wait()
        for call in run.values, run.save, run.outcome, lambda: run.time:
            seen.append(message_of(call))
        thread.join()
        self.assertEqual(set(seen), {
            "a run that moves on must be left alone until advance_to() returns"
        })
        self.assertEqual(run.status, "finished")


class Copied(Test):
    def test_goes_on_as_the_original(self):
        for case in stages, slosh:
            run = libcontact.Run(case)
            run.advance_to(0.4321 * run.end_time)
            other = copy.copy(run)
            self.assertIs(type(other), libcontact.Run)
            self.assertEqual(other.time, run.time)
            np.testing.assert_array_equal(other.values(), run.values())
            other.advance_to(other.end_time)
            self.assertLess(run.time, run.end_time)
            run.advance_to(run.end_time)
            self.assert_same(other.outcome(), run.outcome(), restored=True)
            self.assertEqual(copy.copy(run).status, "finished")

    def test_tells_its_own_listener_how_far_it_is(self):
        run = libcontact.Run(slow)
        other = copy.copy(run)
        times = []
        other.advance_to(other.end_time, progress=lambda *at: times.append(at))
        self.assertGreater(len(times), 0)
        self.assertEqual(run.time, 0)


class Saved(Test):
    def test_goes_on_there_and_back(self):
        for case in stages, slosh:
            run = libcontact.Run(case)
            other = libcontact.Run(case)
            # Between two output times.
            run.advance_to(0.4321 * run.end_time)
            saved = run.save()
            values = run.values()
            self.assertIsInstance(saved, bytes)
            run.advance_to(run.end_time)
            other.restore(saved)
            np.testing.assert_array_equal(other.values(), values)
            other.advance_to(other.end_time)
            ahead = run.outcome()
            self.assert_same(other.outcome(), ahead, restored=True)
            run.restore(saved)
            self.assertEqual(run.status, "running")
            np.testing.assert_array_equal(run.values(), values)
            run.advance_to(run.end_time)
            self.assert_same(run.outcome(), ahead, restored=True)

    def test_is_of_one_case_and_whole(self):
        run = libcontact.Run(stages)
        run.advance_to(1)
        saved = run.save()
        strange = ("the saved state: the checkpoint must be one of this case file, these joints and these options")
        friction = "body[1].hinge.joint[1].friction.coefficient"
        for other in (
            libcontact.Run(stages, clearance=False),
            libcontact.Run(stages.replace({friction: 0.5})),
            libcontact.Run(slosh),
        ):
            self.assertEqual(message_of(other.restore, saved), strange)
            self.assertEqual(other.time, 0)
        self.assertEqual(
            message_of(run.restore, b""),
            "the saved state: the file must be a checkpoint of hinge-separation")
        damaged = saved[:1000] + bytes([saved[1000] ^ 1]) + saved[1001:]
        self.assertRegex(
            message_of(run.restore, damaged), "^the saved state: damaged: ")
        # With a check sum that is right.
        first, _, _ = saved.partition(b"\n")
        forged = first + b"\n" + 300_000 * b"\x81"
        self.assertEqual(
            message_of(run.restore, forged + b"%08x" % zlib.crc32(forged)),
            "the saved state: the file must be a checkpoint of hinge-separation")
        time, later = (b"dtime\xfa" + struct.pack(">f", t) for t in (1, 99))
        self.assertIn(time, saved)
        forged = saved[:-8].replace(time, later)
        self.assertEqual(
            message_of(run.restore, forged + b"%08x" % zlib.crc32(forged)),
            "state.time = 99 must be 0 to 2.6 s")
        self.assertEqual(run.time, 1)

    def test_goes_on_failing_where_it_failed(self):
        run = libcontact.Run(fails)
        with self.assertWarns(RuntimeWarning):
            run.advance_to(1)
        other = libcontact.Run(fails)
        other.restore(run.save())
        self.assertEqual(other.time, run.time)
        with self.assertWarns(RuntimeWarning):
            self.assertEqual(other.advance_to(1), "failed")
        self.assertEqual(other.message, run.message)


if __name__ == "__main__":
    unittest.main()
