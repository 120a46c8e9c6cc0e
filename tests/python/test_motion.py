"""Steps, moment sets and derivatives for other simulators."""

import pickle
import unittest

import libcontact
import numpy as np
from support import hip_file, pin_file

hip = libcontact.Joint.from_file(hip_file)
pin = libcontact.Joint.from_file(pin_file)
inertia = np.array([[20, 1, 0], [1, 30, 0], [0, 0, 10.0]])


def random_start(n, seed=3):
    random = np.random.default_rng(seed)
    return random.normal(size=(3, n, 3)) * np.array([1e3, 1, 1])[:, None, None]


class Step(unittest.TestCase):
    def test_satisfies_its_equation(self):
        reaction, rate, free = random_start(500)
        s = hip.step(reaction, rate, free, inertia)
        wanted = (s.angular_velocity - free) @ inertia
        # joint/step_test.cpp: 1e-12 of |W free|.
        np.testing.assert_allclose(
            s.moment, wanted, rtol=0, atol=1e-12 * np.abs(free @ inertia).max())
        self.assertTrue((s.angular_velocity[s.holds] == 0).all())
        np.testing.assert_array_equal(
            s.solution.normal_force, hip.solve(reaction, rate).normal_force)

    def test_holds_and_lets_go(self):
        held = hip.at_rest([0, 0, 2000], [-1e-3, 0, -1e-3]).utilisation
        size = np.array([0.5, 0.999, 1.001, 5]) / held
        free = np.linalg.solve(inertia, [1e-3, 0, 1e-3]) * size[:, None]
        s = hip.step([0, 0, 2000], [0, 0, 0], free, inertia)
        self.assertEqual(s.holds.tolist(), [True, True, False, False])
        np.testing.assert_allclose(s.rest.utilisation, size * held, rtol=1e-10)

    def test_broadcasts_and_goes_on_from_the_last(self):
        reaction, rate, free = random_start(6)
        weights = inertia * np.arange(1, 5)[:, None, None, None]
        s = hip.step(reaction, rate, free, weights, threads=2)
        self.assertEqual(s.shape, (4, 6))
        one = hip.step(reaction[2], rate[2], free[2], weights[3, 0])
        np.testing.assert_array_equal(s[3, 2].moment, one.moment)
        again = hip.step(reaction, rate, free, weights, last=s)
        np.testing.assert_allclose(again.moment, s.moment, rtol=1e-10)
        self.assertLess(again.solution.evaluations.sum(), s.solution.evaluations.sum())
        out = {"moment": np.empty((4, 6, 3))}
        hip.step(reaction, rate, free, weights, out=out)
        np.testing.assert_array_equal(out["moment"], s.moment)
        with self.assertRaisesRegex(libcontact.Error, r"\(\.\.\., 3, 3\)"):
            hip.step(reaction, rate, free, [1, 2, 3])
        unpickled = pickle.loads(pickle.dumps(s))
        np.testing.assert_array_equal(unpickled.moment, s.moment)
        with self.assertRaisesRegex(libcontact.Error, "before it is pickled"):
            unpickled.solution

    def test_of_a_pin_is_about_its_axis(self):
        s = pin.step([2e4, 0, 0], [0, 0, 1], [0, 0, 0.1], np.eye(3) * 100, axis=[0, 0, 1])
        self.assertTrue(s.holds)
        self.assertAlmostEqual(s.moment[2], -10)


    def test_refuses_what_is_no_inertia(self):
        start = [2e4, 0, 0], [0, 0, 1], [0, 0, 0.1]
        for wrong in np.zeros((3, 3)), -np.eye(3), np.eye(3) + [[0, 1, 0]], np.eye(3) * np.nan:
            with self.assertRaisesRegex(
                libcontact.Error, "inertia of row 1 must be symmetric and positive"
            ):
                hip.step(*start, [np.eye(3), wrong])
        with self.assertRaisesRegex(libcontact.Error, "inertia of row 0 must be"):
            pin.step(*start, np.diag([1, 1, 0]), axis=[0, 0, 1])
        self.assertTrue(np.isfinite(pin.step(*start, np.diag([0, 0, 1])).moment).all())


class Together(unittest.TestCase):
    def test_satisfy_their_equation(self):
        axis = [[0, 0, 0], [0, 0, 1]]
        reaction, rate, free = random_start(2)
        rate[1, :2] = free[1, :2] = 0
        mass = np.array(
            [[20, 1, 0, 3], [1, 30, 0, 2], [0, 0, 10, 1], [3, 2, 1, 50.0]])
        s, fit = libcontact.step([hip, pin], reaction, rate, free, mass, axis=axis)
        self.assertEqual(fit["status"], libcontact.Status.OK)
        self.assertLess(fit["residual"], 1e-12)

        def joined(v):
            return np.append(v[0], v[1, 2])

        np.testing.assert_allclose(
            joined(s.moment), mass @ joined(s.angular_velocity - free), rtol=0,
            atol=1e-11 * np.abs(mass @ joined(free)).max())  # fmt: skip
        _, again = libcontact.step(
            [hip, pin], reaction, rate, free, mass, axis=axis, last=s)
        self.assertEqual(again["sweeps"], fit["sweeps"])
        # The step of one joint alone is its own.
        alone, _ = libcontact.step([hip], reaction[:1], rate[:1], free[:1], inertia)
        own = hip.step(reaction[0], rate[0], free[0], inertia)
        np.testing.assert_array_equal(alone.moment[0], own.moment)

    def test_say_what_is_wrong(self):
        rows = np.ones((2, 3))
        for joints, arguments, said in (
            ([hip], (rows, rows, rows, inertia), "a row for each joint"),
            ([None], (rows[:1], rows[:1], rows[:1], inertia), "must be all of Joint"),
            ([hip, pin], (rows, rows, rows, np.eye(4)), "pin 1 requires axis"),
            ([hip, hip], (rows, rows, rows, np.eye(4)), "must be 6 by 6"),
            ([hip, hip], (rows, rows, rows, 1), "inertia must be a matrix"),
            ([hip, hip], (rows, rows, rows, np.tri(6)), "inertia must be finite and symm"),
            ([hip, hip], (rows, rows, rows, np.zeros((6, 6))), "inertia of joint 0 must be"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, said):
                libcontact.step(joints, *arguments)


class MomentSet(unittest.TestCase):
    def test_has_the_moment_of_its_solution(self):
        reaction, rate, _ = random_start(50)
        solution = hip.solve(reaction, rate)
        of = hip.moment_set(solution)
        np.testing.assert_allclose(of.moment(rate), solution.friction_moment, atol=1e-12)
        np.testing.assert_allclose(of.support(rate), -solution.power, rtol=1e-10)
        np.testing.assert_allclose(of.utilisation(0.5 * of.moment(rate)), 0.5, rtol=1e-10)
        np.testing.assert_allclose(of.project(3 * of.moment(rate)).shape, (50, 3))

    def test_prox_satisfies_its_equation(self):
        reaction, rate, free = random_start(50)
        of = hip.moment_set(hip.solve(reaction, rate))
        p = of.prox(inertia, free)
        np.testing.assert_allclose(
            p.moment, (p.angular_velocity - free) @ inertia, rtol=0,
            atol=1e-12 * np.abs(free @ inertia).max())  # fmt: skip
        small = of.prox(inertia, 1e-9 * free)
        self.assertTrue((small.angular_velocity == 0).all())
        self.assertEqual(list(of.prox(inertia, free, fields=["moment"])), ["moment"])

    def test_is_that_of_a_ball_s_solution(self):
        with self.assertRaisesRegex(libcontact.Error, "a ball"):
            pin.moment_set(pin.solve([2e4, 0, 0], [0, 0, 1]))
        unpickled = pickle.loads(pickle.dumps(hip.solve([0, 0, 9], [1, 0, 0])))
        with self.assertRaisesRegex(libcontact.Error, "not unpickled"):
            hip.moment_set(unpickled)


class Derivatives(unittest.TestCase):
    def test_are_those_of_solve(self):
        reaction, rate, _ = random_start(20)
        d = hip.derivatives(reaction, rate, threads=2)
        self.assertEqual(d["over_rate"].shape, (20, 3, 3))
        for name, step in ("over_rate", 1e-4), ("over_reaction", 1e-1):
            for k in range(3):
                h = step * np.eye(3)[k]
                there, back = (
                    hip.solve(reaction + s * h * (name != "over_rate"),
                              rate + s * h * (name == "over_rate")).friction_moment
                    for s in (1, -1)
                )  # fmt: skip
                difference = (there - back) / (2 * step)
                size = np.abs(d[name]).max(axis=(1, 2))
                error = np.abs(d[name][..., k] - difference).max(axis=1) / size
                # Differences of second order, steps of 1e-4 of Dw and R.
                self.assertLess(error.max(), 1e-4)

    def test_at_the_contact_are_symmetric(self):
        reaction, rate, _ = random_start(20)
        d = hip.derivatives(reaction, rate)["at_contact"]
        np.testing.assert_allclose(
            d, d.swapaxes(-1, -2), atol=1e-9 * np.abs(d).max())
        self.assertTrue(np.isnan(hip.derivatives([0, 0, 9], [0, 0, 0])["over_rate"]).all())


if __name__ == "__main__":
    unittest.main()
