"""Joints: their numbers are C++'s, their messages the programs'."""

import copy
import multiprocessing
import pickle
import signal
import tempfile
import threading
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import libcontact
import numpy as np
from support import cxx_rows, hip_file, pin_file, program, random_rows, table

hip = libcontact.Joint.from_file(hip_file)

walled = dict(
    kind="ball", radius_mm=14, radial_clearance_um=100,
    inner={"youngs_modulus_GPa": 230, "poissons_ratio": 0.3},
    outer={"youngs_modulus_GPa": 1, "poissons_ratio": 0.4},
    wall={"backing": "rigid", "layer": [{"thickness_mm": 8}]},
    coefficient=0.0587,
)  # fmt: skip


def numbers(s):
    return np.column_stack(
        [s.normal_force, s.half_angle, s.friction_moment, s.normal, s.power,
         s.slip_axis_angle, s.peak_pressure, s.residual])  # fmt: skip


class Numbers(unittest.TestCase):
    def test_are_those_of_cxx_to_the_last_bit(self):
        for file in hip_file, pin_file:
            rows = random_rows(3000)
            s = libcontact.Joint.from_file(file).solve(*rows)
            of_cxx, _ = cxx_rows(file, *rows)
            self.assertEqual(numbers(s).tobytes(), of_cxx.tobytes())

    def test_warm_rows_differ_in_the_last_digits(self):
        rows = random_rows(2000)
        cold, warm = hip.solve(*rows), hip.solve(*rows, warm=True)
        np.testing.assert_allclose(
            warm.normal_force, cold.normal_force, rtol=1e-12)  # fmt: skip
        self.assertFalse(np.array_equal(warm.normal_force, cold.normal_force))

    def test_of_a_stuck_joint_are_those_of_the_program(self):
        sphere = hip.without_seat()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            stuck = sphere.stuck([300, 2000])
        rows = {
            row["quantity"]: float(row["value"])
            for row in table("hinge-joint", "--joint", hip_file, "--reaction",
                             "2000", "--beta", "90", "--equivalent")}  # fmt: skip
        for name, key in (
            ("load_stiffness", "K_load_N_m_per_rad"),
            ("held_stiffness", "K_held_N_m_per_rad"),
            ("spin_stiffness", "K_spin_N_m_per_rad"),
            ("lugre_stiffness", "sigma0_N_m_per_rad"),
            ("dahl_exponent", "dahl_exponent"),
            ("breakaway_angle", "breakaway_angle_rad"),
        ):
            # There it is R, here R_n, which friction makes 0.2 % smaller.
            values = getattr(stuck, name)
            self.assertEqual(values.shape, (2,))
            np.testing.assert_allclose(values[1], rows[key], rtol=2e-3)
            self.assertNotEqual(values[1], rows[key])
        one = sphere.solve([0, 0, 2000], [1, 0, 0])
        exact = sphere.stuck(one.normal_force, fields="load_stiffness")
        np.testing.assert_allclose(
            exact["load_stiffness"], rows["K_load_N_m_per_rad"], rtol=1e-12)  # fmt: skip
        np.testing.assert_allclose(
            stuck.breakaway_angle,
            stuck.shape_exponent * stuck.friction_moment / stuck.load_stiffness)  # fmt: skip
        pin = libcontact.Joint.from_file(pin_file).stuck(1e4)
        self.assertTrue(np.isnan([pin.held_stiffness, pin.spin_stiffness]).all())
        self.assertGreater(pin.load_stiffness, 0)
        for force in (-1, np.nan):
            self.assertTrue(np.isnan(hip.stuck(force).load_stiffness))
        steel = dict(youngs_modulus_GPa=200, poissons_ratio=0.3)
        wide = libcontact.Joint(
            kind="ball", radius_mm=20, radial_clearance_um=1, inner=steel,
            outer=steel, coefficient=0.1)  # fmt: skip
        with self.assertWarnsRegex(libcontact.ContactWarning, "above 43 deg"):
            wide.stuck(1e5)

    def test_of_a_contact_are_those_of_hinge_angle(self):
        (row, other) = table(
            "hinge-angle", "--joint", hip_file, "--load", "500,2000",
            "--law", "exact")  # fmt: skip
        force = [500, 2000]
        exact = hip.replace({"half_angle.law": "exact"})
        for name, values in (
            ("theta0_exact_deg", np.degrees(exact.half_angle(force))),
            ("load_parameter", exact.load_parameter(force)),
            ("p_peak_exact_by_exact_Pa", exact.peak_pressure(force)),
            ("p_nominal_Pa", exact.nominal_pressure(force)),
            ("approach_m", exact.approach(force)),
            ("stiffness_N_per_m", exact.stiffness(force)),
        ):
            of_program = [float(row[name]), float(other[name])]
            np.testing.assert_allclose(
                values, of_program, rtol=1e-13, err_msg=name)  # fmt: skip
        self.assertAlmostEqual(
            hip.pressure(0, 500.0) / hip.peak_pressure(500.0), 1, delta=1e-14)
        self.assertEqual(hip.pressure(2.0, 500.0), 0)

    def test_of_laws_are_those_of_joints(self):
        keys = {k: walled[k] for k in ("inner", "outer", "wall", "radius_mm")}
        theta0 = libcontact.half_angle(
            hip.load_parameter([500, 2000]), "exact", **keys)  # fmt: skip
        np.testing.assert_array_equal(theta0, hip.half_angle([500, 2000]))
        back = libcontact.load_parameter(theta0, "exact", **keys)
        np.testing.assert_allclose(back, hip.load_parameter([500, 2000]))
        p = libcontact.pressure(0.1, theta0, **keys) * [500, 2000] / 0.014**2
        np.testing.assert_allclose(p, hip.pressure(0.1, [500, 2000]))

    def test_of_plain_laws_need_no_materials(self):
        self.assertAlmostEqual(
            libcontact.half_angle(0.001, "hertz"), np.arcsin(0.1))
        self.assertGreater(libcontact.pressure(0, 0.3, "cosine"), 0)
        with self.assertRaisesRegex(
            libcontact.Error, "^law \"exact\" requires inner and outer"
        ):  # fmt: skip
            libcontact.half_angle(1, "exact")
        for wrong in (
            lambda: libcontact.half_angle(1, "hertzz"),
            lambda: libcontact.pressure(0, 1, "hertzz"),
            lambda: libcontact.friction_coefficients(0.5, 0.1, "hertzz"),
        ):
            with self.assertRaisesRegex(
                libcontact.Error, 'law = "hertzz": unknown'
            ):  # fmt: skip
                wrong()

    def test_of_a_pin_are_about_its_axis(self):
        pin = libcontact.Joint.from_file(pin_file)
        s = pin.solve([300, 0, 500], [0, 0, 2.0], axis=[0, 0, 1])
        np.testing.assert_array_equal(s.reaction, [300, 0, 0])
        self.assertEqual(s.power, pin.solve([300, 0, 0], [0, 0, 2.0]).power)

    def test_of_friction_are_those_of_hinge_table(self):
        rows = table(
            "hinge-table", "--theta0", "10:90:4", "--alpha", "0:90:5")  # fmt: skip
        column = lambda name: np.array([float(row[name]) for row in rows])
        c = libcontact.friction_coefficients(
            np.radians(column("theta0_deg")), np.radians(column("alpha_deg")))
        for values, name in (
            (c.force, "chi"), (c.sliding, "sigma_Y"), (c.spinning, "sigma_Z")
        ):  # fmt: skip
            # Degrees become radians, and cos 90 deg 6e-17.
            np.testing.assert_allclose(
                values, column(name + "_cosine"), rtol=1e-14, atol=1e-15)

    def test_of_a_worn_in_seat_are_its_closed_form(self):
        theta0 = np.radians([5, 40, 90])
        s, c = np.sin(theta0), np.cos(theta0)
        np.testing.assert_allclose(
            libcontact.pressure(0.05, theta0, "worn"),
            np.cos(0.05) * 1.5 / np.pi / (1 - c**3), rtol=1e-13)
        np.testing.assert_allclose(
            libcontact.pressure(0, theta0, "worn", kind="pin"),
            1 / (theta0 + s * c), rtol=1e-13)
        self.assertTrue(np.isnan(libcontact.pressure(0, 1.6, "worn")))
        said = libcontact.Joint(**walled, pressure="worn")
        self.assertEqual(
            said, libcontact.Joint(**walled).replace({"pressure.law": "worn"}))
        (row,) = table(
            "hinge-joint", "--joint", hip_file, "--pressure", "worn",
            "--reaction", 2000, "--beta", 90)  # fmt: skip
        moment = said.solve([2000, 0, 0], [0, 0, 1]).friction_moment
        self.assertAlmostEqual(
            np.linalg.norm(moment) / float(row["M_t_N_m"]), 1, delta=1e-13)

    def test_of_friction_stresses_are_those_of_hinge_joint(self):
        pin = {"kind": "pin", "radius_mm": 20, "radial_clearance_um": 40,
               "length_mm": 50,
               "inner": {"youngs_modulus_GPa": 207, "poissons_ratio": 0.292},
               "outer": {"youngs_modulus_GPa": 111, "poissons_ratio": 0.349}}
        ratio = np.logspace(-11, -7, 12)
        for friction in (
            {"law": "stribeck", "static_coefficient": 0.15,
             "dynamic_coefficient": 0.05, "stribeck_velocity_mm_per_s": 10},
            {"law": "power", "coefficient": 0.1, "reference_pressure_MPa": 10,
             "exponent": 0.25},
            {"law": "pressure_table", "pressures_MPa": [1, 5, 30],
             "coefficients": [0.2, 0.15, 0.12], "curve": "linear"},
            {"law": "hersey_table", "speeds_over_pressure_m_per_s_Pa": ratio,
             "coefficients": 0.05 + 0.1 / (1 + ratio * 1e9)},
        ):
            name = friction["law"]
            keys = {k: v for k, v in friction.items() if k != "law"}
            joint = libcontact.Joint(**pin, friction=name, **keys)
            self.assertEqual(joint, libcontact.Joint(**pin, friction=friction))
            with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
                file.write(joint.to_toml())
                file.flush()
                (row,) = table(
                    "hinge-joint", "--joint", file.name, "--reaction", 2000,
                    "--rate", 0.3)  # fmt: skip
            s = joint.solve([2000, 0, 0], [[0, 0, 0.3], [0, 0, 3]])
            self.assertAlmostEqual(
                s.friction_moment[0, 2] / float(row["M_t_z_N_m"]), 1,
                delta=1e-12, msg=name)  # fmt: skip
            same = name in ("power", "pressure_table")
            moments = np.abs(s.friction_moment[:, 2])
            self.assertEqual(np.ptp(moments) < 1e-9 * moments[0], same, name)

    def test_of_friction_stresses_have_keys(self):
        file = pin_file.parents[1] / "duty/stribeck_pin.toml"
        pin = libcontact.Joint.from_file(file)
        power = lambda joint: joint.solve([2000, 0, 0], [0, 0, 3]).power
        rougher = pin.replace({"friction.dynamic_coefficient": 0.1})
        self.assertAlmostEqual(power(rougher) / power(pin), 2, delta=0.02)
        for key, value, message in (
            ("exponent", 0.2, "must be left out"),
            ("static_coefficient", -1, "must be"), ("law", "oil", "must be"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, message):
                pin.replace({"friction." + key: value})
        # Nothing rests on a stress that falls with the speed.
        rest = pin.at_rest([2000, 0, 0], [0, 0, 1])
        self.assertEqual(rest.status, libcontact.Status.OUT_OF_RANGE)
        self.assertTrue(np.isnan(rest.utilisation))

    def test_of_rest_are_those_of_hinge_joint(self):
        (row,) = table(
            "hinge-joint", "--joint", hip_file, "--reaction-xyz", "0,0,2000",
            "--moment-xyz", "1,0,0.5")  # fmt: skip
        rest = hip.at_rest([0, 0, 2000], [1, 0, 0.5])
        self.assertEqual(rest.utilisation, float(row["utilisation"]))
        self.assertTrue(rest.holds)

    def test_without_a_value_are_nan_and_said_so(self):
        s = hip.solve([[0, 0, np.nan], [0, 0, 1.0]], [0, 0, 1])
        self.assertEqual(
            list(s.status),
            [libcontact.Status.OUT_OF_RANGE, libcontact.Status.OK])
        self.assertTrue(np.isnan(s.half_angle[0]))
        self.assertEqual(hip.solve([0, 0, 1], [0, 0, 0]).state,
                         libcontact.State.RESTING)


class Shapes(unittest.TestCase):
    def test_broadcast(self):
        reaction, rate = random_rows(12)
        grid = hip.solve(reaction.reshape(4, 3, 3), rate[:3])
        self.assertEqual(grid.shape, (4, 3))
        self.assertEqual(grid.normal.shape, (4, 3, 3))
        one = hip.solve(reaction[7], rate[1])
        self.assertEqual(one.shape, ())
        self.assertIsInstance(one.half_angle, float)
        self.assertEqual(one.half_angle, grid.half_angle[2, 1])
        column = hip.solve(reaction[:4, None], rate[None, :5])
        self.assertEqual(
            column.half_angle[2, 4],
            hip.solve(reaction[2], rate[4]).half_angle)
        none = hip.solve(np.empty((0, 3)), rate[0])
        self.assertEqual(none.half_angle.shape, (0,))

    def test_of_any_memory(self):
        reaction, rate = random_rows(6)
        straight = hip.solve(reaction[::2], rate[::2]).power
        turned = hip.solve(np.asfortranarray(reaction)[::2], rate[::2].tolist())
        np.testing.assert_array_equal(turned.power, straight)
        whole = hip.solve(np.array([0, 0, 2000]), np.float32([1, 0, 1]))
        self.assertEqual(
            whole.power, hip.solve([0, 0, 2000.0], [1, 0, 1.0]).power)

    def test_become_columns(self):
        s = hip.solve(*random_rows(5))
        columns = s.to_dict()
        self.assertEqual({len(c) for c in columns.values()}, {5})
        np.testing.assert_array_equal(columns["normal_y"], s.normal[:, 1])
        again = pickle.loads(pickle.dumps(s))
        np.testing.assert_array_equal(again.normal, s.normal)

    def test_that_do_not_fit_are_refused(self):
        for arguments, message in (
            (([1, 2], [0, 0, 1]),
             "reaction of shape (2,) must be of shape (..., 3)"),
            ((np.ones((4, 3)), np.ones((5, 3))),
             "arguments of (4,) and (5,) rows must be of shapes that "
             "broadcast together"),
        ):  # fmt: skip
            with self.assertRaises(libcontact.Error) as caught:
                hip.solve(*arguments)
            self.assertEqual(str(caught.exception), message)


class Files(unittest.TestCase):
    def test_by_keywords_say_the_same(self):
        said = libcontact.Joint(**walled, inner_body="body")
        rows = random_rows(50)
        np.testing.assert_array_equal(
            said.solve(*rows).friction_moment,
            hip.solve(*rows).friction_moment)
        self.assertEqual(libcontact.Joint(**said.to_dict()), said)

    def test_may_name_a_shipped_pair(self):
        size = {"kind": "ball", "geometry": {"radius": 0.02, "radial_clearance": 3e-5}}
        joint = libcontact.Joint(**size, materials={"pair": "steel_bronze"})
        self.assertEqual(joint["materials"]["inner"]["name"], "carbon steel")

    def test_have_the_messages_of_the_programs(self):
        for key, value in ("geometry.radius_mm", -5), ("wall.backing", "air"):
            _, said = program(
                "hinge-joint", "--joint", hip_file, "--set", f"{key}={value}",
                "--reaction", "1", "--beta", "60")  # fmt: skip
            with self.assertRaises(libcontact.Error) as caught:
                hip.replace({key: value})
            setting = str(caught.exception).replace('"air": wall', "air: wall")
            self.assertEqual("hinge-joint: " + setting + "\n", said)

    def test_without_a_place_have_messages_without(self):
        materials = {k: walled[k] for k in ("inner", "outer")}
        for keys, message in (
            ({}, "a joint requires inner and outer, the two materials, or pair"),
            ({"radius_mm": -50, **materials},
             "geometry.radius_mm = -50 must be above 0"),
            ({"radius_mm": 50, **materials},
             "geometry requires radial_clearance, diametral_clearance, "
             "relative_clearance, radial_interference, "
             "diametral_interference, or hole and shaft"),
            ({"diametral_clearance_um": 5, **materials}, "geometry requires radius or "
             "diameter"),
        ):  # fmt: skip
            with self.assertRaises(libcontact.Error) as caught:
                libcontact.Joint(kind="ball", **keys)
            self.assertEqual(str(caught.exception), message)
        with self.assertRaisesRegex(TypeError, "no number"):
            libcontact.Joint(kind="ball", radius_mm=print, **materials)
        with self.assertRaises(FileNotFoundError):
            libcontact.Joint.from_file("gone.toml")
        frictionless = {k: v for k, v in walled.items() if k != "coefficient"}
        with self.assertRaisesRegex(libcontact.Error, r"requires \[friction\]"):
            libcontact.Joint(**frictionless).solve([0, 0, 1], [0, 0, 1])

    def test_have_keys(self):
        self.assertEqual(hip["geometry.radius_mm"], 14)
        self.assertEqual(hip["wall.layer[1].thickness_mm"], 8)
        self.assertEqual(hip["materials.inner.youngs_modulus_GPa"], 230)
        other = hip.replace({"geometry.radius_m": 0.015,
                             "materials.inner.youngs_modulus_MPa": 2e5})
        self.assertEqual(other.radius, 0.015)
        self.assertEqual(other["geometry.radius_m"], 0.015)
        self.assertEqual(other["materials.inner.youngs_modulus_MPa"], 2e5)
        for key in ("geometry.radius_mm", "materials.inner.youngs_modulus_GPa",
                    "wall.layer[2]", "geometry.radius_mm.x"):
            with self.assertRaises(KeyError):
                other[key]
        self.assertEqual(hip["geometry.radius_mm"], 14)

    def test_have_the_clearance_of_their_temperatures(self):
        steel = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3,
                 "thermal_expansion_per_K": 11.5e-6}
        bronze = {"youngs_modulus_GPa": 110, "poissons_ratio": 0.34,
                  "thermal_expansion_per_K": 18e-6}
        warm = libcontact.Joint(
            kind="ball", radius_mm=25, radial_clearance_um=60, inner=steel,
            outer=bronze, coefficient=0.1, inner_temperature_C=100,
            outer_temperature_C=60)
        grown = 60e-6 + 0.025 * (18e-6 * 40 - 11.5e-6 * 80)
        self.assertAlmostEqual(warm.radial_clearance / grown, 1, 12)
        even = warm.replace({"inner_temperature_C": 20,
                             "outer_temperature_K": 293.15})
        self.assertEqual(even.radial_clearance, 60e-6)

    def test_say_where_the_theory_ends(self):
        self.assertEqual(hip.notes([500, 2000]), [])
        (note,) = hip.notes([500, 20e3])
        _, said = program(
            "hinge-angle", "--joint", hip_file, "--load", "500,20e3")
        self.assertIn(note, said)
        wide = hip.replace({"geometry.radial_clearance_mm": 2})
        self.assertEqual(len(wide.notes()), 1)

    def test_warn_of_contacts_beyond_the_theory(self):
        soft = hip.replace({"materials.outer.limit_pressure_MPa": 5})
        said = ("peak pressure above 5 MPa, the limit pressure of the outer "
                "body, UHMWPE")
        calls = [
            lambda force: soft.solve([0, 0, force], [1, 0, 1]),
            lambda force: soft.solve([[0, 0, 10], [0, 0, force]], [1, 0, 1]),
            lambda force: soft.solve_contact([0, 0, force], [1, 0, 1]),
            lambda force: soft.at_rest([0, 0, force], [1, 0, 0]),
            lambda force: soft.pv([0, 0, force], [1, 0, 1]),
            lambda force: soft.pv_at([0, 0, force], [1, 0, 1], [0, 0, 1]),
            lambda force: soft.peak_pressure(force),
            lambda force: soft.pressure(0.1, [1, force]),
            lambda force: soft.half_angle([force, 1]),
            lambda force: soft.cycle(
                [0, 1, 2, 3], [[0, 0, 10 + force * i] for i in (0, 1, 0, 1)],
                rates=[[np.pi / 8**0.5, 0, np.pi / 8**0.5]] * 4),  # one turn
            lambda force: libcontact.identify(
                soft, [[0, 0, 10], [0, 0, 30], [0, 0, force]], [1, 0, 0],
                [0.01, 0.03, 0.001 * force]),
        ]  # fmt: skip
        for call in calls:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                call(100)
                self.assertEqual(caught, [])
                call(2000)
            (one,) = caught
            self.assertIs(one.category, libcontact.ContactWarning)
            self.assertEqual(str(one.message), said)
            self.assertEqual(one.filename, __file__)
            self.assertIn(one.lineno, [
                line for _, _, line in call.__code__.co_lines()])
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaises(libcontact.ContactWarning):
                    call(2000)
        # A quantity that concerns no contact is silent.
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            soft.nominal_pressure(2000)
            soft.load_parameter(2000)
            self.assertIn("5 MPa", soft.notes(2000)[0])

    def test_warn_of_a_liner_without_a_wall(self):
        keys = dict(
            kind="pin", diameter_mm=20, radial_clearance_um=20, length_mm=20,
            pair=str(libcontact.examples["materials/steel_ptfe_liner.toml"]))
        bush = libcontact.Joint(**keys)
        said = "outer body, woven PTFE liner, is a liner, but modelled as unbounded"
        with self.assertWarnsRegex(libcontact.ContactWarning, said):
            bush.peak_pressure(1e4)
        of_materials = {k: v for k, v in keys.items() if k != "pair"} | {
            "inner": libcontact.materials["carbon steel"],
            "outer": libcontact.materials["woven PTFE liner"]}
        with self.assertWarnsRegex(libcontact.ContactWarning, said):
            libcontact.Joint(**of_materials).peak_pressure(1e4)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            libcontact.Joint(**keys, liner=False).peak_pressure(1e4)
            bush.replace({"materials.liner": False}).peak_pressure(1e4)

    def test_pickle_copy_and_compare(self):
        other = hip.replace({"materials.inner.youngs_modulus_MPa": 2e5})
        for joint in hip, other, libcontact.Joint(**walled):
            again = pickle.loads(pickle.dumps(joint))
            self.assertEqual(again, joint)
            self.assertEqual(hash(again), hash(joint))
            self.assertEqual(again.solve([0, 0, 1e3], [1, 0, 1]).power,
                             joint.solve([0, 0, 1e3], [1, 0, 1]).power)
            self.assertIs(copy.deepcopy(joint), joint)
        self.assertNotEqual(hip, other)
        self.assertNotEqual(hip, "hip")

    def test_are_equal_if_they_are_alike(self):
        rest = {k: v for k, v in walled.items() if k != "radius_mm"}
        in_metres = libcontact.Joint(**rest, radius_m=0.014)
        self.assertEqual(in_metres, libcontact.Joint(**walled))
        self.assertEqual(hash(in_metres), hash(libcontact.Joint(**walled)))

    def test_differ_by_the_friction_of_their_materials(self):
        with tempfile.TemporaryDirectory() as folder:
            joints = []
            for speed in 10, 20:
                pair = Path(folder) / f"{speed}.toml"
                pair.write_text(
                    'name = "pair"\n'
                    "inner = {youngs_modulus_GPa = 210, poissons_ratio = 0.3}\n"
                    "outer = {youngs_modulus_GPa = 110, poissons_ratio = 0.3}\n"
                    '[friction]\nlaw = "stribeck"\n'
                    "static_coefficient = 0.15\ndynamic_coefficient = 0.05\n"
                    f"stribeck_velocity_mm_per_s = {speed}\n")
                joints.append(libcontact.Joint(
                    kind="pin", radius_mm=20, radial_clearance_um=40,
                    length_mm=50, pair=str(pair)))
            self.assertNotEqual(*joints)


def moment_of_hip(rows):
    return hip.solve(*rows).friction_moment


class Side(unittest.TestCase):
    """By side: threads and processes."""

    def test_threads_and_forks_have_the_same_answers(self):
        rows = [random_rows(5000, seed) for seed in range(4)]
        alone = [moment_of_hip(r) for r in rows]
        with ThreadPoolExecutor(4) as threads:
            of_threads = list(threads.map(moment_of_hip, rows))
        with multiprocessing.get_context("fork").Pool(2) as forks:
            of_forks = forks.map(moment_of_hip, rows)
        for of_others in of_threads, of_forks:
            for mine, theirs in zip(alone, of_others):
                np.testing.assert_array_equal(mine, theirs)

    def test_others_go_on_while_rows_are_solved(self):
        rows = random_rows(100_000)
        solved = threading.Event()
        thread = threading.Thread(
            target=lambda: (hip.solve(*rows), solved.set()))
        thread.start()
        turns = 0
        while not solved.wait(1e-3):
            turns += 1
        thread.join()
        # With the lock held it would be asked once, at the end.
        self.assertGreater(turns, 10)

    def test_ctrl_c_ends_it(self):
        rows = random_rows(2_000_000)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        with self.assertRaises(KeyboardInterrupt):
            hip.solve(*rows)


class Interference(unittest.TestCase):
    pressed = libcontact.Joint.from_file(
        hip_file.parent / "lined_bush_pressed.toml")
    forces = [0, 2000, 3500, 9000]

    def test_has_the_numbers_of_hinge_joint(self):
        rows = table(
            "hinge-joint", "--joint", hip_file.parent / "lined_bush_pressed.toml",
            "--reaction", "0,2000,3500,9000")  # fmt: skip
        column = lambda name: [float(row[name]) for row in rows]
        s = self.pressed.solve(
            [[force, 0, 0] for force in self.forces], [0, 0, 1], axis=[0, 0, 1])
        np.testing.assert_allclose(
            np.linalg.norm(s.friction_moment, axis=1), column("M_t_N_m"),
            rtol=1e-13)  # fmt: skip
        force = s.normal_force
        for name, values in (
            ("p_0_Pa", self.pressed.interference_pressure(force)),
            ("R_lift_off_N", self.pressed.lift_off_force(force)),
            ("M_0_N_m", self.pressed.unloaded_moment(force)),
            ("sum_p_N", self.pressed.sum_of_pressures(force)),
            ("shift_m", self.pressed.shift(force)),
            ("stiffness_N_per_m", self.pressed.stiffness(force)),
        ):
            np.testing.assert_allclose(
                values, column(name), rtol=1e-13, err_msg=name)  # fmt: skip
        self.assertTrue(np.isnan(self.pressed.approach(2000)))
        words = [libcontact.ContactState(i).name for i in s.contact_state]
        self.assertEqual(words, [row["contact_state"].upper() for row in rows])
        self.assertIn(words[0], str(s))
        # One with a clearance has none.
        self.assertTrue(np.isnan(hip.lift_off_force(500)))
        self.assertTrue(np.isnan(hip.unloaded_moment(500)))

    def test_turns_hard_without_load(self):
        moment = self.pressed.unloaded_moment(0)
        s = self.pressed.solve([0, 0, 0], [0, 0, 2], axis=[0, 0, 1])
        self.assertAlmostEqual(-s.friction_moment[2] / moment, 1, 13)
        rest = self.pressed.at_rest([0, 0, 0], [0, 0, moment / 4], axis=[0, 0, 1])
        self.assertAlmostEqual(rest.utilisation, 0.25, 13)

    def test_is_refused_where_there_is_none(self):
        with self.assertRaisesRegex(
            libcontact.Error, "half-angle law fitted must be exact with interference"
        ):  # fmt: skip
            self.pressed.replace({"half_angle.law": "fitted"}).half_angle(1)
        solid = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.5}
        with self.assertRaisesRegex(libcontact.Error, "incompressible"):
            libcontact.Joint(
                kind="pin", radius_mm=10, length_mm=10, coefficient=0.1,
                radial_interference_um=1, inner=solid,
                outer={"youngs_modulus_GPa": float("inf"),
                       "poissons_ratio": 0.3}).half_angle(1)  # fmt: skip

    def test_says_what_it_leaves_out(self):
        self.assertTrue(any("hoop stress" in n for n in self.pressed.notes()))


if __name__ == "__main__":
    unittest.main()
