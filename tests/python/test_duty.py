"""Duty cycles, wear and identification: the numbers of the programs."""

import pickle
import tempfile
import unittest
import warnings

import libcontact
import numpy as np
from support import columns, hip_file, program, random_rows, source, table

folder = source / "data/reference/duty"


def force(c):
    return np.stack([c["R_x_N"], c["R_y_N"], c["R_z_N"]], axis=1)


def hip_cycle():
    c = columns(folder / "cycle_hip_in.csv")
    angles = np.radians(
        [c["flexion_deg"], c["adduction_deg"], c["internal_rotation_deg"]]).T
    joint = libcontact.Joint.from_file(folder / "cycle_hip.toml")
    return joint.cycle(c["time_s"], force(c), angles=angles, sequence="zxy")


def summary(name, *arguments):
    rows = table(
        "hinge-duty", "--joint", folder / f"{name}.toml", "--cycle",
        folder / f"{name}_in.csv", *arguments)  # fmt: skip
    return {row["quantity"]: row for row in rows}


class Ratings(unittest.TestCase):
    def test_are_those_of_hinge_joint(self):
        (row,) = table(
            "hinge-joint", "--joint", hip_file, "--reaction", 2000, "--beta",
            30, "--rate", 2, "--pv")  # fmt: skip
        hip = libcontact.Joint.from_file(hip_file)
        rate = [float(row[f"w_{x}_rad_per_s"]) for x in "xyz"]
        reaction = [float(row[f"R_{x}_N"]) for x in "xyz"]
        pv = hip.pv(reaction, rate)
        self.assertAlmostEqual(
            np.degrees(pv.pv_max_theta), float(row["pv_max_theta_deg"]))
        for value, name in (
            (pv.pv_max, "pv_max"), (pv.pv_mean, "pv_mean"),
            (pv.pv_nominal, "pv_nominal"), (pv.heat_flux_max, "q_max"),
        ):  # fmt: skip
            self.assertAlmostEqual(
                value / float(row[name + "_W_per_m2"]), 1, delta=1e-13)
        at_peak = hip.pv_at(reaction, rate, pv.pv_max_place)
        self.assertAlmostEqual(at_peak["pv"] / pv.pv_max, 1, delta=1e-9)

    def test_heat_is_the_power_lost(self):
        hip = libcontact.Joint.from_file(hip_file)
        rows = random_rows(20)
        np.testing.assert_allclose(
            hip.pv(*rows).heat, -hip.solve(*rows).power, rtol=1e-12)


class Cycles(unittest.TestCase):
    def test_of_a_hip_are_those_of_hinge_duty(self):
        said = summary(
            "cycle_hip", "--euler", "zxy", "--wear-seat", 1, "--grid", 500)
        cycle = hip_cycle()
        for value, name in (
            (cycle.energy, "energy_J"),
            (cycle.mean_heat, "mean_heat_W"),
            (cycle.sliding_path, "sliding_path_m"),
            (cycle.effective_sliding_distance,
             "effective_sliding_distance_m"),
            (np.degrees(cycle.contact_spread), "contact_spread_deg"),
            (cycle.pv_integral, "pv_integral_J"),
        ):
            self.assertAlmostEqual(
                value / float(said[name]["value"]), 1, delta=1e-13)
        for quantity, name in (
            ("friction_moment", "largest_M_t_N_m"),
            ("peak_pressure", "largest_p_peak_Pa"),
            ("pv_max", "largest_pv_max_W_per_m2"),
        ):
            value, time = cycle.largest(quantity)
            self.assertAlmostEqual(
                value / float(said[name]["value"]), 1, delta=1e-12)
            # A flat maximum: its place is half as exact.
            self.assertAlmostEqual(
                time, float(said[name]["at_time_s"]), delta=1e-6)
        for body in "body", "carrier":
            wear = cycle.wear(body, points=500)
            of_program = said[f"largest_pv_integral_{body}_Pa_m"]
            self.assertAlmostEqual(
                wear.deepest_pv_integral / float(of_program["value"]), 1,
                delta=1e-9)  # fmt: skip
            total = wear.pv_integral.sum() * wear.cell_area
            self.assertAlmostEqual(
                total / cycle.pv_integral - 1, wear.volume_defect)
            self.assertEqual(wear.points.shape, (500, 3))

    def test_of_columns_in_degrees_are_those_of_radians(self):
        c = columns(source / "data/duty/hip_cycle.csv")
        names = [n for n in c if n.endswith("_deg")]
        force = np.stack([c[f"R_{k}_N"] for k in "xyz"], axis=1)
        degrees = np.stack([c[n] for n in names], axis=1)

        class Frame:  # like pandas'
            columns = names

            def __array__(self, dtype=None, copy=None):
                return degrees

        hip = libcontact.Joint.from_file(
            source / "data/joints/hip_cocr_uhmwpe.toml")
        energy = [
            hip.cycle(c["time_s"], force, angles=a, sequence="zxy").energy
            for a in (Frame(), np.radians(degrees))
        ]  # fmt: skip
        self.assertEqual(*energy)
        with self.assertWarnsRegex(
            libcontact.ContactWarning, "degrees read as radians"
        ):
            hip.cycle(c["time_s"], force, angles=degrees, sequence="zxy")

        class Turned(Frame):  # numpy.radians keeps the names of pandas' columns
            def __array__(self, dtype=None, copy=None):
                return np.radians(degrees)

        with self.assertWarnsRegex(
            libcontact.ContactWarning, "reach .* deg: radians read as degrees"
        ):
            hip.cycle(c["time_s"], force, angles=Turned(), sequence="zxy")

        class Kilonewtons:
            columns = [f"R_{k}_kN" for k in "xyz"]

            def __array__(self, dtype=None, copy=None):
                return force / 1e3

        cycle = hip.cycle(
            c["time_s"], Kilonewtons(), angles=Frame(), sequence="zxy")  # fmt: skip
        self.assertAlmostEqual(cycle.energy / energy[0], 1, delta=1e-12)

    def test_at_the_rows_are_those_of_the_reference(self):
        states = columns(folder / "cycle_hip_states.csv")
        cycle = hip_cycle()
        np.testing.assert_allclose(
            np.degrees(cycle.solution.half_angle), states["theta0_deg"],
            rtol=1e-9)  # fmt: skip
        np.testing.assert_array_equal(cycle.time, states["time_s"])
        self.assertEqual(cycle.rating.shape, cycle.solution.shape)
        self.assertEqual(cycle.largest_pv, cycle.largest("pv_max")[0])
        self.assertTrue(np.isnan(cycle.rim_share))
        self.assertIsNone(cycle.table)

    def test_pickle(self):
        cycle = hip_cycle()
        again = pickle.loads(pickle.dumps(cycle))
        self.assertEqual(again.energy, cycle.energy)
        np.testing.assert_array_equal(
            again.rating.pv_max, cycle.rating.pv_max)

    def test_of_a_pin_take_one_angle(self):
        c = columns(folder / "cycle_pin_in.csv")
        (angle,) = (c[name] for name in c if name.endswith("_deg"))
        joint = libcontact.Joint.from_file(folder / "cycle_pin.toml")
        cycle = joint.cycle(c["time_s"], force(c), angles=np.radians(angle))
        energy = summary("cycle_pin")["energy_J"]["value"]
        self.assertAlmostEqual(cycle.energy / float(energy), 1, delta=1e-12)

    def test_of_a_pin_that_ends_are_those_of_hinge_duty(self):
        bush = source / "data/joints/relieved_bush.toml"
        c = columns(source / "data/duty/pin_cycle.csv")
        joint = libcontact.Joint.from_file(bush)
        rows = c["time_s"], force(c)
        angles = np.radians(c["angle_deg"])
        for lie, option in (
            ({}, ()), ({"place": 2e-3}, ("--load-at", "2mm")),
            ({"place": np.full(len(angles), 2e-3)}, ("--load-at", "2mm")),
        ):
            cycle = joint.cycle(*rows, angles=angles, **lie)
            said = {r["quantity"]: r["value"] for r in table(
                "hinge-duty", "--joint", bush, "--cycle",
                source / "data/duty/pin_cycle.csv", *option)}
            for value, name in (
                (cycle.energy, "energy_J"), (cycle.pv_integral, "pv_integral_J"),
                (cycle.largest_pv, "largest_pv_max_W_per_m2"),
                (np.degrees(cycle.largest("half_angle")[0]),
                 "largest_theta0_deg"),
            ):
                # Splines through equal places: to rounding.
                self.assertAlmostEqual(value / float(said[name]), 1, delta=1e-9)
            self.assertTrue(np.isnan(cycle.contact_spread))
            np.testing.assert_array_equal(
                cycle.solution.largest_half_angle > 0, True)
        tilted = joint.cycle(*rows, angles=angles, tilt=[0, 5e-4, 0])
        np.testing.assert_allclose(
            tilted.solution.tilt, np.tile([0, 5e-4, 0], (len(angles), 1)),
            atol=1e-15)
        with self.assertRaisesRegex(libcontact.Error, "as many as there are"):
            joint.cycle(*rows, angles=angles, place=[0, 1e-3])
        with self.assertRaisesRegex(libcontact.Error, "left out beside place"):
            joint.cycle(*rows, angles=angles, place=0, tilt=[0, 0, 0])

    def test_of_a_hip_that_wears_are_those_of_hinge_duty(self):
        with tempfile.TemporaryDirectory() as work:
            blocks = work + "/blocks.csv"
            said = summary(
                "cycle_hip", "--euler", "zxy", "--wear-seat", "1e-6",
                "--grid", 10, "--cycles", "5e6", "--blocks", blocks)
            of_program = columns(blocks)
        worn = hip_cycle().wear_in(1e-15, 5e6)
        for values, name in (
            (worn.cycles, "cycles"), (worn.wear_number, "wear_number"),
            (worn.volume * 1e9, "volume_seat_mm3"),
            (worn.penetration * 1e3, "penetration_mm"),
            (np.degrees(worn.half_angle), "theta0_deg"),
            (worn.peak_pressure, "p_peak_Pa"),
            (worn.pv_max, "pv_max_W_per_m2"), (worn.energy, "energy_J"),
            (worn.mean_moment, "mean_M_t_N_m"),
        ):
            np.testing.assert_allclose(
                values, of_program[name], rtol=1e-12, err_msg=name)
            end = "worn_" + name
            self.assertAlmostEqual(
                values[-1] / float(said[end]["value"]), 1, delta=1e-12)
        self.assertGreater(len(worn), 10)

    def test_of_wear_in_tells_its_progress_and_ends_with_an_exception(self):
        told = []
        worn = hip_cycle().wear_in(
            1e-15, 1e6, progress=lambda *done: told.append(done))  # fmt: skip
        self.assertEqual(told, [(c, 1e6) for c in worn.cycles])

        def enough(done, cycles):
            if done > 0:
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            hip_cycle().wear_in(1e-15, 1e6, progress=enough)

    def test_with_a_row_that_repeats_the_first_leave_it_out(self):
        c = columns(folder / "cycle_pin_in.csv")
        (angle,) = (c[name] for name in c if name.endswith("_deg"))
        joint = libcontact.Joint.from_file(folder / "cycle_pin.toml")
        rows = c["time_s"], force(c), np.radians(angle)
        once = joint.cycle(*rows[:2], angles=rows[2])
        again = [np.concatenate([row, row[:1]]) for row in rows]
        again[0][-1] = once.period
        with self.assertWarnsRegex(RuntimeWarning, "repeats the first") as at:
            twice = joint.cycle(*again[:2], angles=again[2])
        self.assertEqual(at.filename, __file__)
        self.assertEqual(twice.period, once.period)
        self.assertAlmostEqual(twice.energy / once.energy, 1, delta=1e-14)

    def test_wear_on_from_file_to_file(self):
        pin_file = source / "data/joints/pin_joint.toml"
        cycle_file = source / "data/duty/pin_cycle.csv"
        c = columns(cycle_file)
        pin = libcontact.Joint.from_file(pin_file)
        cycle = pin.cycle(
            c["time_s"], force(c), angles=np.radians(c["angle_deg"]))
        seat = libcontact.WornSeat()
        with self.assertRaisesRegex(libcontact.Error, "requires a seat that"):
            seat.to_toml()
        with tempfile.TemporaryDirectory() as work, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            first, second = work + "/first.toml", work + "/second.toml"
            wear = ["hinge-duty", "--joint", pin_file, "--cycle", cycle_file,
                    "--wear-seat", "2e-7", "--cycles", "1000"]
            program(*wear, "--worn-out", first)
            program(*wear, "--worn", first, "--worn-out", second)
            cycle.wear_in(2e-16, 1000, seat=seat)
            begun = libcontact.WornSeat.from_file(first, pin)
            ended = libcontact.WornSeat.from_file(second, pin)
            np.testing.assert_allclose(
                seat.depths, begun.depths, rtol=1e-6, atol=1e-15)
            self.assertEqual((seat.cycles, ended.cycles), (1000, 2000))
            cycle.wear_in(2e-16, 1000, seat=begun)
            np.testing.assert_allclose(
                begun.depths, ended.depths, rtol=1e-6, atol=1e-15)
            with open(second) as file:
                self.assertEqual(ended.to_toml(), file.read())
            with self.assertRaisesRegex(libcontact.Error, "radius"):
                libcontact.WornSeat.from_file(
                    first, pin.replace({"geometry.radius_mm": 30}))

    def test_that_wear_warn_of_what_is_not_known(self):
        c = columns(source / "data/duty/pin_cycle.csv")
        joint = libcontact.Joint.from_file(
            source / "data/joints/pin_joint.toml")
        cycle = joint.cycle(
            c["time_s"], force(c), angles=np.radians(c["angle_deg"]))
        with self.assertWarnsRegex(RuntimeWarning, "worn step by step") as at:
            cycle.wear_in(2e-16, 1000)
        self.assertEqual(at.filename, __file__)
        with self.assertRaisesRegex(libcontact.Error, "at most 20 mm.*coefficient 1 mm"):
            cycle.wear_in(1e-9, 1e15)
        with self.assertWarnsRegex(RuntimeWarning, "coefficient 1 mm"):
            cycle.wear_in(1e-9, 0)

    def test_of_one_row_are_a_steady_turn(self):
        pin = libcontact.Joint.from_file(source / "data/joints/pin_joint.toml")
        cycle = pin.cycle([0], [[0, -5e3, 0]], rates=[[0, 0, 2]], period=3)
        power = pin.solve([0, -5e3, 0], [0, 0, 2]).power
        self.assertAlmostEqual(cycle.energy / (-3 * power), 1, delta=1e-12)
        with self.assertRaisesRegex(libcontact.Error, "one row requires period"):
            pin.cycle([0], [[0, -5e3, 0]], rates=[[0, 0, 2]])

    def test_of_bad_input_are_refused(self):
        c = columns(folder / "cycle_hip_in.csv")
        joint = libcontact.Joint.from_file(folder / "cycle_hip.toml")
        time, angles = c["time_s"], np.zeros((len(c["time_s"]), 3))
        uneven = time**2
        for cycle, message in (
            ((time, {}), "requires angles or rates"),
            ((time, {"angles": angles}), "angles requires sequence"),
            ((time, {"angles": angles, "sequence": "zxq"}), "sequence"),
            ((time, {"rates": angles, "sequence": "zxy"}), "requires angles"),
            ((time, {"rates": angles, "force_on": "air"}),
             'force_on = "air" must be "carrier" or "body"'),
            ((uneven, {"rates": angles}), "uneven time steps requires period"),
            ((time[::-1], {"rates": angles, "period": 1.0}), "must be"),
            ((time, {"rates": angles, "period": 0.5}), "must be"),
            ((time, {"rates": angles[:, :2]}), r"rates of shape"),
            ((time[:4], {"rates": angles}), "must be"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, message):
                joint.cycle(cycle[0], force(c), **cycle[1])
        tight = joint.replace(
            {"half_angle.limit_half_angle_deg": 120,
             "geometry.radial_clearance_um": 0.1})
        wide = tight.cycle(time, force(c), angles=angles + 1, sequence="zxy")
        with self.assertRaisesRegex(libcontact.Error, "at most 90 deg"):
            wide.wear()
        with self.assertRaisesRegex(libcontact.Error, "at most 90 deg"):
            wide.wear_in(1e-15, 1e6)
        with self.assertRaisesRegex(libcontact.Error, "coefficient = -1 must"):
            hip_cycle().wear_in(-1, 1e6)
        with self.assertRaisesRegex(libcontact.Error, "points = 3 must be"):
            hip_cycle().wear(points=3)
        with self.assertRaisesRegex(libcontact.Error, "quantity = "):
            hip_cycle().largest("colour")


class Identification(unittest.TestCase):
    rig = source / "data/duty/torque_rig.toml"
    data = source / "data/duty/torque_rig.csv"

    def arguments(self):
        c = columns(self.data)
        zero = 0 * c["R_N"]
        b = np.radians(c["b_deg"])
        joint = libcontact.Joint.from_file(self.rig)
        reaction = np.stack([zero, zero, c["R_N"]], axis=1)
        rate = np.stack([np.sin(b), zero, np.cos(b)], axis=1)
        return joint, reaction, rate, c["torque_N_m"], c["sigma_N_m"]

    def test_is_that_of_hinge_identify(self):
        *arguments, sigma = self.arguments()
        fit = libcontact.identify(*arguments, sigma=sigma)
        rows = table("hinge-identify", "--joint", self.rig, "--data", self.data)
        said = {row["quantity"]: row for row in rows}
        self.assertTrue(fit.converged)
        for estimate, name in (
            (fit["coefficient"], "f0"), (fit["adhesion"], "A_Pa"),
            (fit.effective_coefficient, "f0_effective"),
            (fit.load_trend, "load_trend"),
        ):  # fmt: skip
            self.assertAlmostEqual(
                estimate.value / float(said[name]["value"]), 1, delta=1e-7)
            self.assertAlmostEqual(
                estimate.interval[1] / float(said[name]["high"]), 1,
                delta=1e-7)  # fmt: skip
        self.assertEqual(fit.correlation.shape, (2, 2))
        self.assertEqual(fit.residual.shape, sigma.shape)
        moment, error = fit.predict(*arguments[1:3])
        np.testing.assert_allclose(moment, fit.moment, rtol=1e-12)
        np.testing.assert_allclose(error, fit.moment_error, rtol=1e-9)

    def test_pickles_as_what_was_measured(self):
        *arguments, sigma = self.arguments()
        fit = libcontact.identify(*arguments, sigma=sigma, huber=True)
        moment = fit.moment
        arguments[3][:] = 0  # the array belongs to the caller
        again = pickle.loads(pickle.dumps(fit))
        np.testing.assert_array_equal(again.moment, moment)
        np.testing.assert_array_equal(again.covariance, fit.covariance)

    def test_of_vectors_gives_back_what_made_them(self):
        joint, reaction, rate, _, _ = self.arguments()
        joint = joint.replace(
            {"friction.coefficient": 0.2, "friction.adhesion_MPa": 1})
        moment = joint.solve(reaction, rate).friction_moment
        fit = libcontact.identify(joint, reaction, rate, moment)
        self.assertAlmostEqual(
            fit["coefficient"].value / joint["friction.coefficient"], 1,
            delta=1e-8)  # fmt: skip
        self.assertEqual(fit.residual.shape, (3 * len(rate),))

    def test_with_a_drag_and_an_offset_gives_back_what_made_them(self):
        joint, reaction, rate, _, _ = self.arguments()
        truth = joint.replace(
            {"friction.coefficient": 0.2, "friction.adhesion_MPa": 1})
        solution = truth.solve(reaction, rate)
        size = np.linalg.norm(rate, axis=1)
        torque = -np.sum(solution.friction_moment * rate, axis=1) / size
        sense = np.where(np.arange(len(rate)) % 2 == 0, 1, -1)
        along = rate / size[:, None] @ (rate[0] / size[0])
        fit = libcontact.identify(
            joint, sense[:, None] * reaction, sense[:, None] * rate,
            torque + 0.65 - 0.3 * sense * along,
            parameters=["coefficient", "adhesion", "drag", "offset"])
        for name, value in (
            ("coefficient", 0.2), ("adhesion", 1e6), ("drag", 0.65),
            ("offset", -0.3),
        ):  # fmt: skip
            self.assertAlmostEqual(fit[name].value / value, 1, delta=1e-8)

    def test_warns_of_errors_that_sigma_does_not_tell(self):
        *arguments, sigma = self.arguments()
        with self.assertWarnsRegex(libcontact.ContactWarning, "chi2/dof"):
            libcontact.identify(*arguments, sigma=sigma / 10)

    def test_of_bad_input_is_refused(self):
        *arguments, _ = self.arguments()
        for options, message in (
            ({"parameters": ["colour"]}, 'parameters: "colour" must be'),
            ({"sigma": 0}, "must be"), ({"level": 2}, "must be"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, message):
                libcontact.identify(*arguments, **options)


if __name__ == "__main__":
    unittest.main()
