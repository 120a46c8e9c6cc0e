"""Arrays over the numbers of a joint."""

import pickle
import time
import unittest

import libcontact
import numpy as np
from support import hip_file, pin_file, random_rows, source

hip = libcontact.Joint.from_file(hip_file)
pin = libcontact.Joint.from_file(pin_file)
f0 = "materials.friction.coefficient"
clearance = "geometry.radial_clearance_um"


class Joints(unittest.TestCase):
    def test_are_those_of_replace(self):
        keys = {clearance: [50.0, 100, 150], f0: [0.03, 0.062, 0.1]}
        several = hip.vary(keys)
        self.assertEqual(several.shape, (3,))
        force, rate = [0, 300, 2000], [1, 0, 0.4]
        solution = several.solve(force, rate)
        for i in range(3):
            one = hip.replace({key: values[i] for key, values in keys.items()})
            self.assertEqual(several[i], one)
            # A law of the same materials is the same law.
            self.assertEqual(several.radial_clearance[i], one.radial_clearance)
            self.assertEqual(solution[i].power, one.solve(force, rate).power)
            for name in "half_angle", "peak_pressure", "contact_area", "approach":
                self.assertEqual(getattr(several, name)(900)[i], getattr(one, name)(900))
            self.assertEqual(several.pressure(0.1, 900)[i], one.pressure(0.1, 900))
            held = several.at_rest(force, [0.1, 0, 0.1]).utilisation[i]
            self.assertEqual(held, one.at_rest(force, [0.1, 0, 0.1]).utilisation)
            self.assertEqual(
                several.pv(force, rate).heat[i], one.pv(force, rate).heat)
            inertia = np.eye(3) * 20
            np.testing.assert_array_equal(
                several.step(force, rate, [1, 1, 1], inertia).moment[i],
                one.step(force, rate, [1, 1, 1], inertia).moment)

    def test_broadcast_against_rows(self):
        several = hip.vary({f0: [[0.01], [0.1]], clearance: [60, 90, 120]})
        reaction, rate = random_rows(5)
        power = several.solve(reaction[:, None, None], rate[:, None, None]).power
        self.assertEqual(power.shape, (5, 2, 3))
        alone = several[1, 2].solve(reaction, rate).power
        np.testing.assert_array_equal(power[:, 1, 2], alone)
        np.testing.assert_array_equal(
            several[:, 1].solve(reaction[:, None], rate[:, None]).power,
            power[:, :, 1])
        out = np.empty((2, 3))
        self.assertIs(several.half_angle(700, out=out, threads=2), out)
        np.testing.assert_array_equal(out, several.half_angle(700))

    def test_share_laws_that_do_not_change(self):
        """A law takes milliseconds, a joint 16 us."""
        many = np.linspace(0.01, 0.1, 1000)
        for keys, laws in (
            ({f0: many}, 2),
            ({clearance: 100 * many}, 2),
            ({"geometry.radius_mm": many[:3] * 400}, 6),  # it has a wall
            ({"materials.outer.poissons_ratio": [0.3, 0.35, 0.3]}, 4),
        ):  # fmt: skip
            self.assertEqual(hip.vary(keys).laws, laws, keys)
        for keys, laws in (
            ({"geometry.radius_mm": 300 * many}, 2),
            ({"materials.inner.youngs_modulus_GPa": [100, 200, 300],
              "materials.outer.youngs_modulus_GPa": [50, 100, 150]}, 2),
            ({"materials.inner.youngs_modulus_GPa": [100, 200, 300]}, 6),
        ):  # fmt: skip
            self.assertEqual(pin.vary(keys).laws, laws, keys)
        start = time.process_time()
        hip.vary({f0: [0.1]})
        laws = time.process_time() - start
        hip.vary({f0: many})
        joints = time.process_time() - start - 2 * laws
        self.assertLess(joints / len(many), laws / 10)

    def test_say_what_is_wrong_as_replace_does(self):
        for keys, said in (
            ({"geometry.radius_mm": [14, -14]},
             "geometry.radius_mm = -14 must be above 0"),
            ({"geometry.radius_mmm": [14]}, "radius_mm"),
            ({}, "vary\\(\\) requires keys"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, said):
                hip.vary(keys)
        with self.assertRaisesRegex(TypeError, "^half_angle.law: an array of <U5 must be of floats"):
            hip.vary({"half_angle.law": ["exact"]})
        with self.assertRaisesRegex(ValueError, "broadcast"):
            hip.vary({f0: [1, 2], clearance: [1, 2, 3]})
        free = libcontact.Joint.from_file(source / "data/duty/torque_rig.toml")
        without = free.vary({"geometry.radial_clearance_um": [20, 30]})
        self.assertEqual(without.half_angle(100).shape, (2,))
        with self.assertRaisesRegex(libcontact.Error, "requires \\[friction\\]"):
            without.solve([0, 0, 1], [1, 0, 0])

    def test_warn_of_the_first_that_leaves_its_limits(self):
        soft = hip.vary({"materials.outer.limit_pressure_MPa": [1000, 3, 2]})
        with self.assertWarnsRegex(libcontact.ContactWarning, "above 3 MPa"):
            soft.solve([0, 0, 2000], [1, 0, 0])

    def test_are_values(self):
        several = hip.vary({f0: [0.1, 0.2]})
        self.assertEqual(pickle.loads(pickle.dumps(several)), several)
        self.assertNotEqual(several, hip.vary({f0: [0.1, 0.3]}))
        self.assertEqual([one["materials.friction.coefficient"] for one in several],
                         [0.1, 0.2])
        self.assertRegex(repr(several), r"of shape \(2,\), .*coefficient 0.1 to 0.2")
        self.assertRegex(repr(hip.vary({f0: 0.1})), r"of shape \(\), .*coefficient 0.1>$")
        with self.assertRaises(ValueError):
            several.varied[f0][0] = 7


if __name__ == "__main__":
    unittest.main()
