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
cup = libcontact.Joint.from_file(cup_file)
bush = libcontact.Joint.from_file(bush_file)


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
            s = ring.solve([[1e3, 0, 0], [3e5, 0, 0]], [0, 0, 0.5])
        np.testing.assert_array_equal(s.status, libcontact.Status.OK)
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
            "is at both its rims" in text and "in nine of ten cups of all sizes" in text
            for text in texts), texts)  # fmt: skip

    def test_have_pressures_and_notes(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = ring.solve([[3e5, 0, 0], [0, 0, 0]], [0, 0, 0.5])
            rated = ring.pv([3e5, 0, 0], [[0, 0, 0.5], [0, 0, 1]])
        at = np.radians([0, 10, 20, -20])
        places = np.stack([np.cos(at), 0 * at, np.sin(at)], axis=-1)
        p = ring.pressures(s[0], places)
        self.assertEqual(p.shape, (4,))
        self.assertAlmostEqual(p[0] / s.pressure_at_load[0], 1, 2)
        self.assertAlmostEqual(p[2] / p[3], 1, 3)
        self.assertEqual(ring.pressures(s[0], [-1, 0, 0]), 0)
        np.testing.assert_allclose(
            rated.pv_max[1], 2 * rated.pv_max[0], rtol=1e-7)
        # Dry friction: its power is f0 times the integral of p v.
        self.assertAlmostEqual(
            -s.power[0] / (0.06 * rated.pv_total[0]), 1, delta=1e-3)
        np.testing.assert_allclose(rated.heat[0], -s.power[0], rtol=1e-7)
        of_rims = [n for n in ring.notes(solution=s[0]) if " both its rims. " in n]
        self.assertEqual(len(of_rims), 1)
        self.assertEqual(ring.notes(solution=s[1]), [])
        self.assertEqual(s.state[1], libcontact.State.UNLOADED)
        self.assertTrue(math.isnan(s.lower_intensity[1]))
        # Numbers about an axis of symmetry.
        for about in "half_angle", "slip_axis_angle", "load_parameter":
            self.assertTrue(math.isnan(getattr(s, about)[0]), about)
        again = pickle.loads(pickle.dumps(s))
        np.testing.assert_array_equal(again.shift, s.shift)
        with self.assertRaisesRegex(libcontact.Error, "a single row"):
            ring.pressures(s, places)
        with self.assertRaisesRegex(libcontact.Error, "not unpickled"):
            ring.notes(solution=again)
        self.assertIn("lower_intensity", repr(s))

    def test_have_p_v_at_places(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = ring.solve([3e5, 0, 0], [0, 0, 0.5])
            at = ring.pv_at([3e5, 0, 0], [0, 0, 0.5], [[1, 0, 0], [0, 1, 0]])
        speed = ring.radius * 0.5
        np.testing.assert_allclose(
            at["pv"], at["pressure"] * speed, rtol=1e-12)
        np.testing.assert_allclose(
            at["pressure"], ring.pressures(s, [[1, 0, 0], [0, 1, 0]]), rtol=1e-7)
        np.testing.assert_allclose(
            at["heat_flux"], 0.06 * at["pv"], rtol=1e-12)
        self.assertEqual(at["pv"][1], 0)

    def test_rest_as_in_the_program(self):
        row = table(
            "hinge-joint", "--joint", cup_file,
            "--reaction-xyz", "0,-1000,1000", "--moment-xyz", "0.3,0.5,0",
        )[0]  # fmt: skip
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rest = cup.at_rest([0, -1000, 1000], [0.3, 0.5, 0])
        self.assertTrue(same(
            rest.utilisation, number(row, "utilisation")))
        self.assertTrue(same(
            rest.direction[1], number(row, "u_y")))
        self.assertTrue(same(
            rest.slip.peak_pressure, number(row, "p_peak_Pa")))
        self.assertTrue(same(
            rest.slip.upper_intensity, number(row, "K_high")))

    def test_answer_in_all_digits_of_the_program(self):
        for reaction in [0, 1000, 3000], [0, 0, 2000]:
            row = table(
                "hinge-joint", "--joint", cup_file, "--reaction-xyz",
                ",".join(map(str, reaction)), "--rate-xyz", "1,0,0",
            )[0]  # fmt: skip
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                s = cup.solve(reaction, [1, 0, 0])
            self.assertEqual(f"{s.peak_pressure:.9g}",
                             f"{number(row, 'p_peak_Pa'):.9g}")
            self.assertEqual(s.free, number(row, "free"))

    def test_out_of_the_seat_there_is_no_contact(self):
        for reaction in [0, 2000, 0], [0, 1000, -1000]:
            s = cup.solve(reaction, [1, 0, 0])
            self.assertEqual(s.status, libcontact.Status.OUT_OF_SEAT)
            self.assertTrue(math.isnan(s.peak_pressure))
            self.assertTrue(np.isnan(s.seat_force).all())
        self.assertIn("points 180 deg from the seat's axis",
                      cup.notes(solution=s)[0])
        self.assertIn("OUT_OF_SEAT", repr(s))

    def test_small_loads_have_no_peak_of_nothing(self):
        beta = np.radians(np.arange(10, 90, 8))
        reaction = 100 * np.stack(
            [np.sin(beta), 0 * beta, np.cos(beta)], axis=-1)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = ring.solve(reaction, [0, 0, 0.5])
        mean = s.force_ratio * 100 / s.contact_area
        is_ok = s.status == libcontact.Status.OK
        self.assertGreater(np.count_nonzero(is_ok), 5)
        # NaN where the reported distance leaves next to nothing.
        self.assertFalse((s.peak_pressure[is_ok] < 0.99 * mean[is_ok]).any())

    def test_may_lie_in_any_frame(self):
        z = np.array([1, 2, -2]) / 3
        y = np.array([2, 1, 2]) / 3
        turn = np.stack([np.cross(y, z), y, z], axis=-1)
        for joint, reaction in (cup, [0, 1000, 3000]), (cup, [0, 0, 2e3]), (
                ring, [5e4, 0, 1e4]):  # fmt: skip
            rate = np.array([0.3, 0.1, 0.5])
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                s = joint.solve(reaction, rate)
                t = joint.solve(turn @ reaction, turn @ rate, from_seat=turn)
                rated = joint.pv(turn @ reaction, turn @ rate, from_seat=turn)
                here = joint.pv(reaction, rate)
            for name in "friction_moment", "normal", "seat_force", "shift":
                np.testing.assert_allclose(
                    getattr(t, name), turn @ getattr(s, name), rtol=1e-12,
                    atol=1e-12 * np.linalg.norm(getattr(s, name)),
                    err_msg=name)
            for name in "peak_pressure", "lower_intensity", "upper_rim_gap":
                np.testing.assert_allclose(
                    getattr(t, name), getattr(s, name), rtol=1e-12)
            np.testing.assert_allclose(rated.pv_max, here.pv_max, rtol=1e-10)

    def test_each_row_may_have_its_frame(self):
        turn = np.stack([np.eye(3), np.diag([1, -1, -1])])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = cup.solve([[0, 0, 2e3], [0, 0, -2e3]], [1, 0, 0],
                          from_seat=turn)
            held = cup.at_rest([0, 0, -2e3], [0.1, 0, 0], from_seat=turn[1])
        np.testing.assert_array_equal(s.status, libcontact.Status.OK)
        np.testing.assert_allclose(
            s.peak_pressure[1], s.peak_pressure[0], rtol=1e-7)
        self.assertEqual(held.status, libcontact.Status.OK)
        turn[1, 0, 0] = -1
        with self.assertRaisesRegex(
                libcontact.Error,
                "from_seat of row 1 must be a rotation matrix"):
            cup.solve([0, 0, 2e3], [1, 0, 0], from_seat=turn)

    def test_let_the_contact_go_on_without_their_seats(self):
        row = table(
            "hinge-joint", "--joint", cup_file, "--reaction-xyz", "0,2000,0",
            "--rate-xyz", "1,0,0", "--without-seat",
        )[0]  # fmt: skip
        endless = cup.without_seat()
        with self.assertWarnsRegex(libcontact.ContactWarning, "rim"):
            s = endless.solve([0, 2000, 0], [1, 0, 0])
        np.testing.assert_allclose(
            s.peak_pressure, number(row, "p_peak_Pa"), rtol=1e-12)
        self.assertTrue(math.isnan(s.free))
        self.assertNotEqual(endless, cup)
        for other in (
            pickle.loads(pickle.dumps(endless)),
            endless.replace({"friction.coefficient": 0.1}),
            endless.vary({"friction.coefficient": 0.1}),
        ):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.assertEqual(
                    other.solve([0, 2000, 0], [1, 0, 0]).status,
                    libcontact.Status.OK)

    def test_that_differ_are_each_in_its_own(self):
        some = cup.vary({"friction.coefficient": [0.05, 0.1]})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = some.solve([0, 1000, 3000], [1, 0, 0])
            for i, joint in enumerate(some):
                one = joint.solve([0, 1000, 3000], [1, 0, 0])
                np.testing.assert_allclose(
                    s.friction_moment[i], one.friction_moment, rtol=1e-7,
                    atol=1e-9)

    def test_are_the_same_on_threads(self):
        angle = np.linspace(-0.6, 0.6, 40)
        reaction = 2e3 * np.stack(
            [0 * angle, np.sin(angle), np.cos(angle)], axis=-1)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            one = cup.solve(reaction, [1, 0, 0])
            two = cup.solve(reaction, [1, 0, 0], threads=2)
        self.assertIn(0, one.free)
        self.assertIn(1, one.free)
        np.testing.assert_allclose(
            one.friction_moment, two.friction_moment, rtol=1e-6, atol=1e-6)
        free = one.free == 1
        np.testing.assert_array_equal(
            one.friction_moment[free], two.friction_moment[free])

    def test_have_steps_and_moment_sets(self):
        load = [0, 1000, 3000], [1, 0, 0]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = cup.solve(*load)
            step = cup.step(*load, load[1], np.eye(3))
            (together,), _ = libcontact.step(
                [cup], [load[0]], [load[1]], [load[1]], np.eye(3))
        moments = cup.moment_set(s)
        # Harmonics of the contact leave 1e-3 beside a rim.
        np.testing.assert_allclose(
            moments.moment(load[1]), s.friction_moment, rtol=1e-5, atol=1e-5)
        for each in step, together:
            self.assertEqual(each.status, libcontact.Status.OK)
            self.assertTrue(same(
                each.solution.peak_pressure, s.peak_pressure))
            self.assertTrue(same(
                each.solution.upper_intensity, s.upper_intensity))
            np.testing.assert_allclose(
                each.moment, each.angular_velocity - load[1], rtol=1e-9)

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
        made = ring.tabulated((2.9e5, 3e5))
        self.assertLessEqual(made.table_error, 1e-3)
        kept = ring.tabulated(table=made.table)
        unpickled = pickle.loads(pickle.dumps(made))
        load = [2.95e5, 0, 3e4], [0, 0, 0.5]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            a, b = made.solve(*load), kept.solve(*load)
            c = unpickled.solve(*load)
            exact = ring.solve(*load)
        np.testing.assert_array_equal(a.friction_moment, b.friction_moment)
        np.testing.assert_array_equal(a.friction_moment, c.friction_moment)
        np.testing.assert_allclose(
            a.friction_moment[2], exact.friction_moment[2], rtol=2e-3)
        self.assertNotEqual(a.peak_pressure, exact.peak_pressure)
        self.assertEqual(made, ring)
        with self.assertRaisesRegex(libcontact.Error, "of another joint"):
            cup.tabulated(table=made.table)
        with self.assertRaisesRegex(libcontact.Error, "requires loads or"):
            ring.tabulated()
        self.assertIsNone(ring.table)
        self.assertIsNone(made.without_seat().table)

    def test_need_a_seat_for_tables(self):
        hip = libcontact.Joint.from_file(
            source / "data/joints/hip_cocr_uhmwpe.toml")
        for joint in hip, cup.without_seat():
            with self.assertRaisesRegex(
                    libcontact.Error, r"requires a joint with a \[seat\]"):
                joint.tabulated((1e3, 2e3))

    def test_refuse_what_has_no_answer_in_them(self):
        load = [0, 0, 2000], [1, 0, 0]
        body = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
        odd = libcontact.Joint(
            kind="ball", radius_mm=14, radial_clearance_um=100,
            coefficient=0.1, inner=body, outer=body, half_angle="tanh",
            seat={"lower_rim_deg": 0, "upper_rim_deg": 90},
        )  # fmt: skip
        self.assertGreater(odd.peak_pressure(2000), 0)
        for ask in odd.solve, odd.pv, odd.at_rest:
            with self.assertRaisesRegex(libcontact.Error, "or without_seat"):
                ask(*load)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(
                odd.without_seat().solve(*load).status, libcontact.Status.OK)
        with self.assertRaisesRegex(libcontact.Error, "or without_seat"):
            cup.kernel()

    def test_say_what_takes_the_place_of_names_that_are_gone(self):
        with self.assertRaisesRegex(
                AttributeError, "Seat is gone: a Joint with a"):
            libcontact.Seat
        with self.assertRaisesRegex(AttributeError, "write Joint.solve"):
            libcontact.FinitePin
        with self.assertRaisesRegex(AttributeError, "no attribute 'Seta'"):
            libcontact.Seta


class Pins(unittest.TestCase):
    def test_are_those_of_the_program(self):
        for option, values, keywords in [
            ("--tilt", "0.01,0.02",
             {"tilt": np.radians([[0.01, 0, 0], [0.02, 0, 0]])}),
            ("--load-at", "1mm,2mm", {"place": [1e-3, 2e-3]}),
        ]:  # fmt: skip
            rows = table("hinge-joint", "--joint", bush_file,
                         "--reaction", "1e4", option, values)
            s = bush.solve([1e4, 0, 0], [0, 0, 1], **keywords)
            self.assertEqual(s.shape, (2,))
            for i, row in enumerate(rows):
                self.assertEqual(s.status[i], libcontact.Status.OK)
                for mine, name in [
                    (s.peak_pressure, "p_peak_Pa"),
                    (s.low, "z_low_m"),
                    (s.friction_moment[:, 2], "M_t_z_N_m"),
                    (s.tilting_moment[:, 0], "G_x_N_m"),
                ]:
                    np.testing.assert_allclose(
                        mine[i], number(row, name), rtol=1e-12)

    def test_are_the_same_in_any_frame(self):
        z = np.array([1, 2, -2]) / 3
        x = np.array([2, 1, 2]) / 3
        s = bush.solve([1e4, 0, 0], [0, 0, 1], tilt=[2e-4, 1e-4, 0])
        y = np.cross(z, x)
        t = bush.solve(1e4 * x, z, tilt=2e-4 * x + 1e-4 * y)
        turn = np.stack([x, y, z], axis=-1)
        for name in "tilting_moment", "moment", "friction_force", "tilt":
            np.testing.assert_allclose(
                getattr(t, name), turn @ getattr(s, name), rtol=1e-9,
                atol=1e-9 * np.linalg.norm(getattr(s, name)), err_msg=name)
        again = pickle.loads(pickle.dumps(s))
        self.assertEqual(again.low_pressure, s.low_pressure)
        self.assertTrue(math.isnan(s.half_angle))
        self.assertGreater(s.largest_half_angle, 0)

    def test_pressures_are_those_of_the_program(self):
        # Without a rate there is no friction: the reaction is the load.
        s = bush.solve([1e5, 0, 0], [0, 0, 0], axis=[0, 0, 1],
                       tilt=np.radians([0.05, 0.02, 0]))
        rows = table("hinge-pressure", "--joint", bush_file, "--load", "1e5",
                     "--tilt", "0.05", "--twist", "0.02", "--points", "5")
        theta = np.radians([number(row, "theta_deg") for row in rows])
        at = np.stack(
            [bush.radius * np.cos(theta), bush.radius * np.sin(theta),
             [number(row, "z_m") for row in rows]], axis=-1)
        at /= np.linalg.norm(at, axis=-1, keepdims=True)
        np.testing.assert_allclose(
            bush.pressures(s, at), [number(row, "p_Pa") for row in rows],
            rtol=1e-7, atol=1)

    def test_have_their_relief_unless_they_are_without(self):
        load = [1e5, 0, 0], [0, 0, 1]
        s = bush.solve(*load)
        straight = bush.without_relief()
        t = straight.solve(*load)
        self.assertGreater(s.peak_pressure, 1.01 * t.peak_pressure)
        self.assertGreater(s.pieces, 0)
        self.assertTrue(math.isnan(t.low))
        self.assertGreater(t.half_angle, 0)
        self.assertNotEqual(straight, bush)
        self.assertEqual(pickle.loads(pickle.dumps(straight)), straight)

    def test_slide_along_their_axes(self):
        s = bush.solve([1e5, 0, 0], [0, 0, 0], axis=[0, 0, 1],
                       axial_velocity=[0.1, 0, -0.1])
        self.assertLess(s.axial_friction_force[0], -1e4)
        self.assertEqual(s.axial_friction_force[1], 0)
        self.assertEqual(
            s.axial_friction_force[2], -s.axial_friction_force[0])

    def test_rest_and_are_rated_as_they_lie(self):
        tilt = [3e-4, 0, 0]
        load = [1e4, 0, 0], [0, 0, 1]
        s = bush.solve(*load, tilt=tilt)
        rest = bush.at_rest(load[0], [0, 0, 1], tilt=tilt)
        np.testing.assert_allclose(
            rest.utilisation, 1 / abs(s.friction_moment[2]), rtol=1e-12)
        self.assertEqual(rest.slip.low_pressure, s.low_pressure)
        (row,) = table("hinge-joint", "--joint", bush_file, "--reaction",
                       "1e4", "--tilt", repr(math.degrees(3e-4)), "--pv")
        rated = bush.pv(*load, tilt=tilt)
        np.testing.assert_allclose(
            rated.pv_max, number(row, "pv_max_W_per_m2"), rtol=1e-9)
        self.assertEqual(rated.heat, -s.power)

    def test_refuse_what_does_not_fit(self):
        load = [1e4, 0, 0], [0, 0, 1]
        with self.assertRaisesRegex(libcontact.Error, "left out beside place"):
            bush.solve(*load, tilt=[0, 0, 0], place=0)
        with self.assertRaisesRegex(libcontact.Error, "shape"):
            bush.solve(*load, tilt=[0, 0])
        with self.assertRaisesRegex(libcontact.Error, "those of a pin"):
            ring.solve(*load, place=0)
        s = bush.solve(*load, place=[math.nan, 0])
        np.testing.assert_array_equal(
            s.status, [libcontact.Status.OUT_OF_RANGE, libcontact.Status.OK])


if __name__ == "__main__":
    unittest.main()
