"""Joints with play: the numbers of hinge-angle, and identities."""

import math
import unittest

import libcontact
import numpy as np
from support import hip_file, pin_file, table

hip = libcontact.Joint.from_file(hip_file)


class ForceLaws(unittest.TestCase):
    def test_are_those_of_the_program(self):
        rows = table("hinge-angle", "--force-law", "--joint", hip_file)
        self.assertEqual(len(rows), 400)

        def column(name):
            return np.array([float(row[name]) for row in rows])

        play = libcontact.Play(hip)
        s = play.force_law(column("penetration_m"))
        for mine, theirs in [
            (s.force, "force_N"),
            (s.slope, "stiffness_N_per_m"),
            (s.energy, "energy_J"),
            (np.degrees(s.half_angle), "theta0_deg"),
            (s.force_ratio, "force_ratio"),
        ]:
            np.testing.assert_allclose(mine, column(theirs), rtol=1e-14)
        self.assertEqual(play.largest_penetration, column("penetration_m")[-1])
        beyond = play.force_law(1.01 * play.largest_penetration)
        self.assertTrue(math.isnan(beyond.force))

    def test_impacts_are_those_of_the_program(self):
        row = table(
            "hinge-angle", "--impact", "--joint", hip_file, "--mass", "5",
            "--speed", "0.05", "--restitution", "0.6",
            "--reference-speed", "0.1")[0]  # fmt: skip
        a = libcontact.damping_of_restitution(0.6, 0.1)
        impact = libcontact.Play(hip, a).impact(5, [0.05, 0.1])
        self.assertEqual(a, float(row["damping_s_per_m"]))
        self.assertEqual(impact.penetration[0], float(row["penetration_m"]))
        self.assertEqual(impact.peak_force[0], float(row["peak_force_N"]))
        self.assertEqual(
            impact.compression_time[0], float(row["compression_s"]))
        self.assertAlmostEqual(impact.restitution[1], 0.6, 14)


class Forces(unittest.TestCase):
    def test_have_their_derivatives(self):
        play = libcontact.Play(hip, 0.4, 0.05)
        at = [[4e-5, -1.1e-4, 3e-5], [0.01, -0.03, 0.002], [1.0, 2.0, -3.0]]
        d = play.derivatives(*at)
        self.assertEqual(d.shape, (6, 9))
        self.assertEqual(play.derivatives(*at, axis=np.eye(3)).shape, (3, 6, 9))
        for k, step in enumerate([1e-10, 1e-6, 1e-4]):
            ends = []
            for sign in [1, -1]:
                moved = [np.array(x) for x in at]
                moved[k] = moved[k] + sign * step * np.eye(3)
                f = play.force(*moved)
                ends.append(np.hstack([f.force, f.moment]).T)
            slopes = (ends[0] - ends[1]) / (2 * step)
            mine = d[:, 3 * k : 3 * k + 3]
            for part in [slice(0, 3), slice(3, 6)]:
                size = np.abs(slopes[part]).max()
                np.testing.assert_allclose(
                    mine[part] / size, slopes[part] / size, atol=1e-5)

    def test_say_where_the_model_ends(self):
        play = libcontact.Play(hip)
        still = [0.0, 0.0, 0.0]
        self.assertEqual(play.notes([1e-5, 0, 0], still, still), [])
        self.assertIn("beyond the force law",
                      play.notes([1.0, 0, 0], still, still)[0])
        self.assertTrue(math.isnan(
            play.force([1.0, 0, 0], still, still).normal_force))
        self.assertIn("exceeds the energy", play.impact_notes(1e6, 10)[0])

    def test_refuse_joints_that_have_none(self):
        pin = libcontact.Joint.from_file(pin_file)
        with self.assertRaisesRegex(libcontact.Error, "the displacement has no limit"):
            libcontact.Play(pin)
        with self.assertRaisesRegex(libcontact.Error, "restitution = 0 must"):
            libcontact.damping_of_restitution(0, 1)


if __name__ == "__main__":
    unittest.main()
