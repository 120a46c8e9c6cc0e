"""Pictures have the numbers of the results they are drawn of."""

import re
import unittest
import warnings

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from libcontact import _plots
from support import hip_file, pin_file, source

hip = libcontact.Joint.from_file(hip_file)
pin = libcontact.Joint.from_file(pin_file)
hip_cycle = source / "data/reference/duty/cycle_hip_in.csv"


def gait():
    time, *columns = np.genfromtxt(hip_cycle, delimiter=",", skip_header=1).T
    return hip.cycle(
        time, np.stack(columns[:3], 1), sequence="zxy",
        angles=np.radians(np.stack(columns[3:], 1)))  # fmt: skip


def quiet(function, *arguments, **keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", libcontact.ContactWarning)
        return function(*arguments, **keywords)


class Plots(unittest.TestCase):
    def tearDown(self):
        for number in plt.get_fignums():
            plt.figure(number).savefig("/dev/null", format="png")
        plt.close("all")

    def test_have_the_colours_of_all_pictures(self):
        style = (source / "plots/style.gp").read_text()
        self.assertEqual(
            list(_plots.colours),
            re.findall(r"linetype \d linewidth 2.5 linecolor rgb '(#\w+)'", style))

        laws = (source / "apps/cli/joint/laws.cpp").read_text()
        numbers = dict(re.findall(r'\{"(\w+)", (\d)\}', laws))
        self.assertEqual(_plots.law_colours, {
            law: _plots.colours[int(number) - 1]
            for law, number in numbers.items()})  # fmt: skip

    def test_of_a_joint_have_its_torque_over_the_textbooks(self):
        friction, angle, pressure = pin.plot(5e4)
        s = pin.solve([5e4, 0, 0], [0, 0, 1])
        torque = friction.lines[-1].get_xydata()
        self.assertAlmostEqual(torque[-1][0], 50)
        self.assertEqual(friction.lines[-1].get_ydata()[-1],
                         np.linalg.norm(s.friction_moment) / s.textbook_moment)
        self.assertEqual(angle.lines[0].get_ydata()[-1], np.degrees(s.half_angle))
        self.assertEqual(pressure.lines[0].get_ydata()[-1], s.peak_pressure / 1e6)
        self.assertEqual(pressure.get_xlabel(), "load, kN")

    def test_of_a_joint_without_friction_have_two_panels(self):
        self.assertEqual(len(hip.replace({"friction.coefficient": 0}).plot(2e3)), 3)
        with self.assertRaisesRegex(libcontact.Error, "load must be above 0 N"):
            hip.plot(0)

    def test_of_solutions_are_over_the_load_or_rows(self):
        load = np.linspace(500, 2000, 7)
        s = hip.solve(load[:, None] * [0, 0, 1], [1, 0, 0])
        moment, angle, peak = s.plot()
        np.testing.assert_array_equal(moment.lines[0].get_xdata() * 1e3, load)
        np.testing.assert_array_equal(
            moment.lines[0].get_ydata(), np.linalg.norm(s.friction_moment, axis=1))
        self.assertEqual(peak.get_ylabel(), "peak pressure, MPa")
        rows = s[::-1].plot(quantities="half_angle")[0]
        self.assertEqual((rows.get_xlabel(), *rows.lines[0].get_xdata()),
                         ("row", *range(7)))
        _, axis = plt.subplots()
        s.plot(load, "half_angle", axes=axis)
        np.testing.assert_array_equal(axis.lines[0].get_xdata(), load)
        with self.assertRaisesRegex(libcontact.Error, "Did you mean 'power'"):
            s.plot(quantities=["powr"])
        with self.assertRaisesRegex(libcontact.Error, "several rows"):
            s[0].plot()
        with self.assertRaisesRegex(libcontact.Error, "1 panels must be 3"):
            s.plot(axes=axis)

    def test_of_a_cycle_are_over_its_time(self):
        cycle = gait()
        axes = cycle.plot()
        self.assertEqual(len(axes), 5)
        np.testing.assert_array_equal(
            axes[4].lines[0].get_xydata(),
            np.stack([cycle.time, cycle.rating.pv_max / 1e3], 1))
        self.assertIn("kPa m/s", axes[4].get_ylabel())
        self.assertIn(f"{cycle.energy:.3g} J", axes[0].get_title("left"))

    def test_of_wear_have_the_deepest_place_in_the_middle(self):
        wear = gait().wear(points=500)
        axis, = wear.plot()
        dots = axis.collections[0]
        middle = np.argmin(np.linalg.norm(dots.get_offsets(), axis=1))
        self.assertGreater(dots.get_array()[middle], 0.9 * dots.get_array().max())
        axis, = wear.plot(k=1e-15)
        self.assertIn("depth in 1e+06 cycles, µm", axis.figure.axes[1].get_ylabel())

    def test_of_pressure_are_where_the_contact_is(self):
        # A seat that ends, of either body.
        ring = libcontact.Joint.from_file(
            libcontact.examples["joints/spherical_plain_bearing_ge50.toml"])
        for joint, load in ((ring, [5e4, 0, 1e4]), (hip, [0, 0, 2e3])):
            s = quiet(joint.solve, load, [0, 0, 0.5])
            axis, = quiet(joint.plot_pressure, s)
            p = axis.collections[0].get_array().reshape(240, 240)
            middle = np.nanmax(p[100:140, 100:140])
            self.assertGreater(middle, 0.5 * s.peak_pressure / 1e6)
            self.assertEqual(axis.collections[0].norm.vmax, s.peak_pressure / 1e6)

    def test_of_a_pin_are_over_angle_and_length(self):
        bush = libcontact.Joint.from_file(
            libcontact.examples["joints/relieved_bush.toml"])
        s = bush.solve([1e5, 0, 0], [0, 0, 1], tilt=np.radians([0.02, 0, 0]))
        axis, = bush.plot_pressure(s)
        p = axis.collections[0].get_array()
        self.assertAlmostEqual(np.nanmax(p) / (s.peak_pressure / 1e6), 1, delta=0.03)
        self.assertEqual(axis.get_ylim(), (-25, 25))

    def test_of_a_number_are_profiles(self):
        axis, = pin.plot_pressure(5e4)
        self.assertAlmostEqual(
            axis.lines[0].get_ydata().max(), pin.peak_pressure(5e4) / 1e6)
        for wrong in ([0, 0, 5e4], 0, -1):
            with self.assertRaisesRegex(libcontact.Error, "^contact must be a Solution"):
                pin.plot_pressure(wrong)


if __name__ == "__main__":
    unittest.main()
