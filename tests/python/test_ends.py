"""Joints whose contact ends, in seats and as pins: the numbers of hinge-joint."""

import csv
import math
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import libcontact
import numpy as np
from support import columns, source, table

ring_file = source / "data/joints/spherical_plain_bearing_ge50.toml"
cup_file = source / "data/joints/hip_cup.toml"
bush_file = source / "data/joints/relieved_bush.toml"
ring = libcontact.Joint.from_file(ring_file)


def number(row, name):
    return float(row[name])


# The program finds every contact anew, which leaves 5e-9.
def same(a, b):
    return abs(a - b) <= 1e-7 * abs(b)


class Seats(unittest.TestCase):
    def test_are_those_of_the_program(self):
        rows = table(
            "hinge-joint", "--joint", ring_file,
            "--reaction", "1kN,300kN", "--beta", "90", "--rate", "0.5",
        )  # fmt: skip
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            s = libcontact.Seat(ring).solve(
                [[1e3, 0, 0], [3e5, 0, 0]], [0, 0, 0.5])
        self.assertEqual(
            [libcontact.SeatStatus(x) for x in s.status], [0, 0])
        for i, row in enumerate(rows):
            self.assertTrue(same(
                s.peak_pressure[i], number(row, "p_peak_Pa")))
            self.assertTrue(same(
                s.friction_moment[i, 2], number(row, "M_t_z_N_m")))
            self.assertTrue(same(
                s.lower_intensity[i], number(row, "K_low")))
            self.assertTrue(same(
                s.upper_rim_gap[i], number(row, "upper_gap_m")))
            self.assertEqual(s.free[i], number(row, "free"))
        texts = [str(w.message) for w in said]
        self.assertTrue(all(
            w.category is libcontact.ContactWarning for w in said))
        self.assertTrue(any(
            "is at its lower rim" in text and "9 to 16 %" in text
            for text in texts), texts)  # fmt: skip

    def test_have_pressures_and_notes(self):
        seat = libcontact.Seat(ring)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = seat.solve([[3e5, 0, 0], [0, 0, 0]], [0, 0, 0.5])
        at = np.radians([0, 10, 20, -20])
        places = np.stack([np.cos(at), 0 * at, np.sin(at)], axis=-1)
        p = seat.pressure(s[0], places)
        self.assertEqual(p.shape, (4,))
        self.assertAlmostEqual(p[0] / s.pressure_at_load[0], 1, 2)
        self.assertAlmostEqual(p[2] / p[3], 1, 3)
        self.assertEqual(seat.pressure(s[0], [-1, 0, 0]), 0)
        rated = seat.pv(s[0], [[0, 0, 0.5], [0, 0, 1]])
        np.testing.assert_allclose(rated.pv_max[1], 2 * rated.pv_max[0])
        # Dry friction: its power is f0 times the integral of p v.
        self.assertAlmostEqual(
            -s.power[0] / (0.06 * rated.pv_total[0]), 1, delta=1e-3)
        self.assertEqual(len(seat.notes(s[0])), 2)
        self.assertEqual(seat.notes(s[1]), ["the seat has no load"])
        self.assertEqual(s.status[1], libcontact.SeatStatus.NO_LOAD)
        self.assertTrue(math.isnan(s.peak_pressure[1]))
        again = pickle.loads(pickle.dumps(s))
        np.testing.assert_array_equal(again.shift, s.shift)
        with self.assertRaisesRegex(libcontact.Error, "a single row"):
            seat.notes(s)
        self.assertIn("NO_LOAD", repr(s))

    def test_rest_as_in_the_program(self):
        row = table(
            "hinge-joint", "--joint", cup_file,
            "--reaction-xyz", "0,-1000,1000", "--moment-xyz", "0.3,0.5,0",
        )[0]  # fmt: skip
        cup = libcontact.Joint.from_file(cup_file)
        rest = libcontact.Seat(cup).at_rest([0, -1000, 1000], [0.3, 0.5, 0])
        self.assertTrue(same(
            rest.utilisation, number(row, "utilisation")))
        self.assertTrue(same(
            rest.direction[1], number(row, "u_y")))
        self.assertTrue(same(
            rest.peak_pressure, number(row, "p_peak_Pa")))

    def test_out_of_the_seat_there_is_no_contact(self):
        seat = libcontact.Seat(libcontact.Joint.from_file(cup_file))
        s = seat.solve([0, 1000, -1000], [1, 0, 0])
        self.assertEqual(s.status, libcontact.SeatStatus.OUT_OF_SEAT)
        self.assertIn("points 180 deg from the seat's axis", seat.notes(s)[0])

    def test_cycle_is_that_of_hinge_duty(self):
        with tempfile.TemporaryDirectory() as folder:
            states = Path(folder) / "states.csv"
            said = {row["quantity"]: row for row in table(
                "hinge-duty", "--joint", cup_file,
                "--cycle", source / "data/duty/hip_cycle.csv",
                "--euler", "zxy", "--states", states,
                "--map", Path(folder) / "map.csv", "--grid", "500",
            )}  # fmt: skip
            with open(states) as lines:
                rows = list(csv.DictReader(lines))
        hip = columns(source / "data/duty/hip_cycle.csv")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            cycle = libcontact.Joint.from_file(cup_file).cycle(
                hip["time_s"],
                np.stack([hip[f"R_{x}_N"] for x in "xyz"], -1),
                angles=np.radians(np.stack(
                    [hip[x] for x in hip if x.endswith("_deg")], -1)),
                sequence="zxy",
            )  # fmt: skip
        for value, name in (
            (cycle.energy, "energy_J"),
            (cycle.rim_share, "rim_share"),
            (cycle.pv_integral, "pv_integral_J"),
            (cycle.largest_pv, "largest_pv_max_W_per_m2"),
            (cycle.largest("peak_pressure")[0], "largest_p_peak_Pa"),
            (cycle.wear("body", 500).deepest_pv_integral,
             "largest_pv_integral_body_Pa_m"),
        ):
            self.assertAlmostEqual(
                value / float(said[name]["value"]), 1, delta=1e-12)
        np.testing.assert_allclose(
            cycle.rating.pv_max,
            [number(row, "pv_max_W_per_m2") for row in rows], rtol=1e-12)
        np.testing.assert_allclose(
            cycle.solution.peak_pressure,
            [number(row, "p_peak_Pa") for row in rows], rtol=1e-12)
        self.assertIn("rim_share", repr(cycle))
        self.assertIsNone(cycle.table)
        self.assertTrue(np.isnan(cycle.contact_spread))
        self.assertTrue(np.isnan(cycle.largest("half_angle")[0]))
        with self.assertRaisesRegex(libcontact.Error, "at the rims"):
            cycle.wear_in(1e-15, 10)

    def test_tables_are_kept(self):
        made = libcontact.Seat(ring, (2.9e5, 3e5))
        self.assertLessEqual(made.table_error, 1e-3)
        kept = libcontact.Seat(ring, table=made.table)
        load = [2.95e5, 0, 3e4], [0, 0, 0.5]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            a, b = made.solve(*load), kept.solve(*load)
            exact = libcontact.Seat(ring).solve(*load)
        np.testing.assert_array_equal(a.friction_moment, b.friction_moment)
        np.testing.assert_allclose(
            a.friction_moment[2], exact.friction_moment[2], rtol=2e-3)
        self.assertNotEqual(a.peak_pressure, exact.peak_pressure)
        cup = libcontact.Joint.from_file(cup_file)
        with self.assertRaisesRegex(libcontact.Error, "of another joint"):
            libcontact.Seat(cup, table=made.table)
        self.assertIsNone(libcontact.Seat(ring).table)

    def test_refuse_joints_that_have_none(self):
        hip = libcontact.Joint.from_file(
            source / "data/joints/hip_cocr_uhmwpe.toml")
        with self.assertRaisesRegex(libcontact.Error, r"requires \[seat\]"):
            libcontact.Seat(hip)


class Pins(unittest.TestCase):
    def test_are_those_of_the_program(self):
        bush = libcontact.FinitePin(libcontact.Joint.from_file(bush_file))
        for option, values, keywords in [
            ("--tilt", "0.01,0.02",
             {"tilt": np.radians([[0.01, 0], [0.02, 0]])}),
            ("--load-at", "1mm,2mm", {"place": [1e-3, 2e-3]}),
        ]:  # fmt: skip
            rows = table("hinge-joint", "--joint", bush_file,
                         "--reaction", "1e4", option, values)
            s = bush.solve([1e4, 0], 1, **keywords)
            self.assertEqual(s.shape, (2,))
            for i, row in enumerate(rows):
                self.assertEqual(s.status[i], libcontact.Status.OK)
                for mine, name in [
                    (s.peak_pressure, "p_peak_Pa"),
                    (s.low, "z_low_m"),
                    (s.moment[:, 2], "M_z_N_m"),
                    (s.tilting_moment_x, "G_x_N_m"),
                ]:
                    np.testing.assert_allclose(
                        mine[i], number(row, name), rtol=1e-12)

    def test_pressures_are_those_of_the_program(self):
        bush = libcontact.FinitePin(libcontact.Joint.from_file(bush_file))
        # Without a rate there is no friction: the reaction is the load.
        s = bush.solve([1e5, 0], 0, tilt=np.radians([0.05, 0.02]))
        rows = table("hinge-pressure", "--joint", bush_file, "--load", "1e5",
                     "--tilt", "0.05", "--twist", "0.02", "--points", "5")
        p = bush.pressure(
            s,
            [number(row, "z_m") for row in rows],
            np.radians([number(row, "theta_deg") for row in rows]))
        np.testing.assert_allclose(
            p, [number(row, "p_Pa") for row in rows], rtol=1e-9, atol=1)
        self.assertEqual(bush.pressure(s, [[0], [0.01]], [0, 0.1]).shape, (2, 2))

    def test_slides_along_its_axis(self):
        bush = libcontact.FinitePin(libcontact.Joint.from_file(bush_file))
        s = bush.solve([1e5, 0], 0, axial_velocity=[0.1, 0, -0.1])
        self.assertLess(s.axial_friction_force[0], -1e4)
        self.assertEqual(s.axial_friction_force[1], 0)
        self.assertEqual(
            s.axial_friction_force[2], -s.axial_friction_force[0])

    def test_refuse_what_does_not_fit(self):
        bush = libcontact.FinitePin(libcontact.Joint.from_file(bush_file))
        with self.assertRaisesRegex(libcontact.Error, "left out beside place"):
            bush.solve([1e4, 0], 1, tilt=[0, 0], place=0)
        with self.assertRaisesRegex(libcontact.Error, "shape"):
            bush.solve([1e4, 0, 0], 1)
        with self.assertRaisesRegex(libcontact.Error, "requires"):
            libcontact.FinitePin(ring)


if __name__ == "__main__":
    unittest.main()
