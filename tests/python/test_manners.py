"""Manners: joints and results behave as Python's and NumPy's own."""

import ast
import os
import pickle
import tempfile
import unittest
from pathlib import Path

import libcontact
import numpy as np
from support import hip_file, pin_file, program, python, random_rows, source

hip = libcontact.Joint.from_file(hip_file)
rig_file = source / "data/duty/torque_rig.toml"
rig_data = source / "data/duty/torque_rig.csv"
case_file = source / "data/cases/two_stage_turn.toml"


def fit_of_rig():
    load, b, torque, sigma = np.genfromtxt(
        rig_data, delimiter=",", skip_header=2).T
    b = np.radians(b)[:, None]
    return libcontact.identify(
        libcontact.Joint.from_file(rig_file), load[:, None] * [0, 0, 1],
        np.sin(b) * [1, 0, 0] + np.cos(b) * [0, 0, 1], torque, sigma=sigma)


class Results(unittest.TestCase):
    def setUp(self):
        rows = (a.reshape(4, 6, 3) for a in random_rows(24))
        self.s = hip.solve(*rows)

    def test_have_some_of_their_rows(self):
        s = self.s
        mask = s.half_angle > np.median(s.half_angle)
        for index in (2, -1, (1, 3), slice(1, 3), ..., (..., 0), mask, [0, 2],
                      (slice(None), None, 1), np.array(3)):  # fmt: skip
            some = s[index]
            self.assertIs(type(some), libcontact.Solution)
            np.testing.assert_array_equal(some.power, s.power[index])
            self.assertEqual(some.shape, np.shape(s.power[index]))
            np.testing.assert_array_equal(
                some.normal, s.normal.reshape(24, 3)[
                    np.arange(24).reshape(4, 6)[index]])  # fmt: skip
            again = pickle.loads(pickle.dumps(s))[index]
            np.testing.assert_array_equal(again.status, some.status)
            np.testing.assert_array_equal(again.normal, some.normal)
        with self.assertRaises(IndexError):
            s[4]

    def test_are_iterated_and_reshaped(self):
        s = self.s
        self.assertEqual([row.shape for row in s], [(6,)] * 4)
        flat = s.reshape(-1)
        np.testing.assert_array_equal(flat.power, s.power.ravel())
        self.assertEqual(s.reshape(2, 12).normal.shape, (2, 12, 3))
        one = s[0, 0]
        self.assertTrue(one)
        self.assertFalse(s[:0])
        with self.assertRaises(TypeError):
            len(one)
        with self.assertRaises(TypeError):
            iter(one)

    def test_keep_their_shape_in_dicts(self):
        columns = self.s.to_dict()
        self.assertEqual({c.shape for c in columns.values()}, {(4, 6)})
        np.testing.assert_array_equal(
            columns["normal_z"], self.s.normal[..., 2])

    def test_print_values_with_units(self):
        one = self.s[0, 0]
        lines = repr(one).splitlines()
        self.assertEqual(lines[0], "libcontact.Solution")
        line = next(x for x in lines if x.startswith("half_angle"))
        self.assertEqual(line.split(), ["half_angle", "rad", f"{one.half_angle:.6g}"])
        self.assertRegex(repr(one), "status +OK\n")
        many = repr(self.s)
        self.assertIn("of shape (4, 6)", many)
        self.assertIn(f"{self.s.power[0, 3]:.4g}", many)
        self.assertIn("<td>friction_moment</td><td>N m</td>", self.s._repr_html_())
        for result in (
            hip.at_rest([0, 0, 9], [1, 0, 1]), hip.pv([0, 0, 9], [1, 0, 1]),
            libcontact.friction_coefficients([0.1, 0.2], 0.3),
        ):  # fmt: skip
            self.assertGreater(len(repr(result).splitlines()), 2)

    def test_nobody_writes_into_them(self):
        with self.assertRaises(ValueError):
            self.s.power[0] = 1
        self.assertIs(self.s.power, self.s.power)

    def test_are_what_the_next_ones_start_from(self):
        reaction, rate = random_rows(50)
        near = reaction * (1 + 1e-6)
        first = hip.solve(reaction, rate)
        cold, warm = hip.solve(near, rate), hip.solve(near, rate, last=first)
        np.testing.assert_allclose(warm.power, cold.power, rtol=1e-12)
        self.assertLess(warm.evaluations.sum(), cold.evaluations.sum())
        one = hip.solve(near[7], rate[7], last=first[7])
        self.assertEqual(one.power, warm.power[7])
        unpickled = pickle.loads(pickle.dumps(first))
        np.testing.assert_array_equal(
            hip.solve(near, rate, last=unpickled).power, cold.power)
        with self.assertRaisesRegex(libcontact.Error, "^last must be"):
            hip.solve(near, rate, last=first[:9])
        held = hip.at_rest(reaction[0], [1e-3, 0, 2e-3])
        again = hip.at_rest(near[0], [1e-3, 0, 2e-3], last=held)
        self.assertAlmostEqual(again.utilisation / held.utilisation, 1, delta=1e-5)

    def test_may_be_some_quantities(self):
        rows = random_rows(3000)
        whole = hip.solve(*rows)
        some = hip.solve(*rows, fields=("friction_moment", "status"))
        self.assertEqual(list(some), ["friction_moment", "status"])
        for name, values in some.items():
            np.testing.assert_array_equal(values, getattr(whole, name))
        one = hip.solve(*rows, fields="power")
        self.assertEqual(list(one), ["power"])
        np.testing.assert_array_equal(one["power"], whole.power)
        with self.assertRaisesRegex(libcontact.Error, 'did you mean "power"'):
            hip.solve(*rows, fields="powr")
        out = {"power": np.empty(3000)}
        self.assertIs(hip.solve(*rows, out=out)["power"], out["power"])
        np.testing.assert_array_equal(out["power"], whole.power)
        for wrong in ({"power": np.empty(2)}, {"power": np.empty(3000, "f4")},
                      {"power": whole.power}, {"powr": np.empty(3000)}):  # fmt: skip
            with self.assertRaises(libcontact.Error):
                hip.solve(*rows, out=wrong)

    def test_are_named_once(self):
        reaction, rate = random_rows(3000)
        solution = hip.solve(reaction, rate)
        for call, rows, field in (
            (hip.solve, (reaction, rate), "power"),
            (hip.solve_contact, (reaction, rate), "power"),
            (hip.at_rest, (reaction, rate), "utilisation"),
            (hip.pv, (reaction, rate), "pv_max"),
            (hip.step, (reaction, rate, rate, np.eye(3)), "moment"),
            (hip.moment_set(solution).prox, (np.eye(3), rate), "moment"),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, f"^duplicate field {field}$"):
                call(*rows, fields=[field, "status", field])

    def test_take_the_threads_that_there_are(self):
        rows = random_rows(3000)
        many = hip.solve(*rows, threads=100_000)
        np.testing.assert_array_equal(many.power, hip.solve(*rows).power)
        done = python("""
            import resource
            import libcontact, numpy as np
            hip = libcontact.Joint.from_file("data/joints/hip_cocr_uhmwpe.toml")
            force = np.linspace(1, 1e3, 200_000)
            wanted = hip.half_angle(force)
            out = np.empty_like(force)
            with open("/proc/self/statm") as memory:
                used = int(memory.read().split()[0]) * resource.getpagesize()
            # Room for the stacks of some.
            resource.setrlimit(resource.RLIMIT_AS, (used + 2**26, -1))
            hip.half_angle(force, out=out, threads=100)
            print((out == wanted).all())
            """.replace("\n            ", "\n"), cwd=source)
        self.assertEqual((done.stdout, done.stderr), ("True\n", ""))

    def test_are_at_most_what_can_be_counted(self):
        def spread(place):
            return np.ones((*(65536 if d == place else 1 for d in range(4)), 3))

        with self.assertRaisesRegex(libcontact.Error, "65536, 65536.* of fewer rows"):
            hip.step(*map(spread, range(3)), np.ones((65536, 3, 3)))

    def test_are_the_same_on_several_threads(self):
        rows = random_rows(10_000)
        alone, shared = hip.solve(*rows), hip.solve(*rows, threads=3)
        np.testing.assert_array_equal(alone.power, shared.power)
        soft = hip.replace({"materials.outer.limit_pressure_MPa": 1})
        with self.assertWarns(libcontact.ContactWarning):
            soft.solve(*rows, threads=2)

    def test_of_other_functions_too(self):
        reaction, rate = random_rows(3000)
        moment = 1e-3 * rate
        for call, whole, field in (
            (hip.solve_contact, (reaction, rate), "power"),
            (hip.at_rest, (reaction, moment), "utilisation"),
            (hip.pv, (reaction, rate), "pv_max"),
            (hip.step, (reaction, rate, rate, np.eye(3)), "moment"),
        ):  # fmt: skip
            wanted = getattr(call(*whole), field)
            some = call(*whole, fields=[field], threads=2)
            np.testing.assert_array_equal(some[field], wanted)
            out = {field: np.empty_like(wanted)}
            call(*whole, out=out)
            np.testing.assert_array_equal(out[field], wanted)
        force = np.abs(reaction[:, 0])
        out = np.empty(3000)
        for function in hip.half_angle, hip.stiffness, hip.peak_pressure:
            self.assertIs(function(force, out=out, threads=2), out)
            np.testing.assert_array_equal(out, function(force))
        self.assertIs(hip.pressure(0.1, force, out=out), out)
        np.testing.assert_array_equal(out, hip.pressure(0.1, force, threads=3))
        for wrong in np.empty(2), np.empty(3000, "f4"), [0.0] * 3000:
            with self.assertRaisesRegex(libcontact.Error, "^out must be a writable"):
                hip.half_angle(force, out=wrong)
        with self.assertRaisesRegex(libcontact.Error, "threads = 0 must be 1 or more"):
            hip.half_angle(force, threads=0)

    def test_of_ten_million_rows_need_little_memory(self):
        """A million here; ten million moments took 0.23 GB once."""
        done = python(
            "import libcontact, numpy as np, resource\n"
            f"pin = libcontact.Joint.from_file({str(pin_file)!r})\n"
            "R = np.ones((1_000_000, 3)); w = np.ones((1_000_000, 3))\n"
            "used = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
            "before = used()\n"
            "pin.solve(R, w, fields=('friction_moment',))\n"
            "print((used() - before) / 1024)\n"
            "before = used()\n"
            "pin.at_rest(R, w, fields=('utilisation',))\n"
            "pin.half_angle(R[0, 0] + np.broadcast_to(0.0, 1_000_000))\n"
            "print((used() - before) / 1024)")
        # 24 bytes a row are 23 MiB; rows of all quantities are 15 times that.
        # What solve() gave back is used again.
        moments, others = map(float, done.stdout.split())
        self.assertLess(moments, 30, done.stderr)
        self.assertLess(others, 10, done.stderr)


class Others(unittest.TestCase):
    def test_a_fit_prints_the_report_of_hinge_identify(self):
        fit = fit_of_rig()
        printed, _ = program(
            "hinge-identify", "--joint", rig_file, "--data", rig_data,
            "--format", "csv")  # fmt: skip
        symbols = [line.split(",")[0] for line in printed.splitlines()[1:]]
        lines = repr(fit).splitlines()[2:]
        self.assertEqual([line.split()[0] for line in lines], symbols)
        f0 = fit["coefficient"]
        self.assertIn(f"{f0.value:.6g}  ", lines[0])
        self.assertEqual(float(f0), f0.value)
        self.assertEqual(list(fit), ["coefficient", "adhesion"])
        self.assertIn("<table>", fit._repr_html_())

    def test_cycles_wear_and_runs_print_what_they_are(self):
        cycle = hip.cycle([0, 1, 2, 3], [[0, 0, 9], [0, 0, 12], [0, 0, 9], [0, 0, 8]],
                          rates=[[1, 0, 1]] * 4)  # fmt: skip
        self.assertRegex(repr(cycle), f"energy +J +{cycle.energy:.6g}")
        self.assertRegex(repr(cycle.wear(points=20)), "^libcontact.Wear of the body")
        run = libcontact.Run(libcontact.Case.from_file(case_file))
        self.assertEqual(repr(run), "<libcontact.Run at 0 s of 2.6 s, running>")
        self.assertIn("libcontact.Run at 0 s of 2.6 s", run._repr_html_())
        run.advance_to(2.6)
        event = run.events[0]
        self.assertIn(f"<td>{event.time:.6g}</td><td>{event.body}</td>",
                      run._repr_html_())
        self.assertIn(f"<td>energy</td><td>J</td><td>{cycle.energy:.6g}</td>",
                      cycle._repr_html_())
        wear = cycle.wear("carrier", points=20)
        self.assertIn("<caption>libcontact.Wear of the carrier at 20 points",
                      wear._repr_html_())
        self.assertIn(
            "<td>deepest_pv_integral</td><td>Pa m</td>"
            f"<td>{wear.deepest_pv_integral:.6g}</td>", wear._repr_html_())

    def test_joints_play_and_moment_sets_print_what_they_are(self):
        key = "geometry.radial_clearance_um"
        several = hip.vary({key: [[50], [60], [70], [80], [90]]})
        page = several._repr_html_()
        self.assertIn("of shape (5, 1)</caption>", page)
        self.assertIn("<th>3, 0</th><th>...</th>", page)
        self.assertIn(f"<td>{key}</td><td>50</td><td>60</td>", page)
        play = libcontact.Play(hip, damping=0.5)
        self.assertEqual(
            repr(play), f"<libcontact.Play of {hip.name!r}, damping 0.5 s/m, up "
            f"to {play.largest_penetration:.4g} m>")
        rows = (a.reshape(2, 3, 3) for a in random_rows(6))
        moments = hip.moment_set(hip.solve(*rows))
        self.assertEqual(repr(moments), "<libcontact.MomentSet of shape (2, 3)>")


class Stub(unittest.TestCase):
    def test_says_what_functions_do(self):
        text = (Path(libcontact.__file__).parent / "_core.pyi").read_text()
        body = ast.parse(text).body
        classes = {c.name: c for c in body if isinstance(c, ast.ClassDef)}
        for name in "_JointSet", "Joint", "MomentSet", "Solution", "Play":
            first = {}
            for function in classes[name].body:
                if isinstance(function, ast.FunctionDef):
                    first.setdefault(function.name, function)
            for key, function in first.items():
                if not key.startswith("_"):
                    self.assertTrue(ast.get_docstring(function), f"{name}.{key}")
        of_law = next(f for f in body if getattr(f, "name", "") == "half_angle")
        self.assertIn("load_parameter:", ast.get_docstring(of_law))


class Arguments(unittest.TestCase):
    def test_that_are_no_numbers_are_refused_as_numpy_does(self):
        pin = libcontact.Joint.from_file(pin_file)
        forces = np.ones((4, 3))
        for wrong, said in (
            ("500", "array of <U3"), (["1", "2"], "array of <U1"),
            (np.array(["2020-01-01"], "M8[s]"), "array of datetime64"),
            (1 + 2j, "array of complex128"), (None, "array of object"),
            ([1, None], "array of object"), ({}, "array of object"),
            (np.ma.array([500.0, 600.0], mask=[0, 1]), "masked array"),
        ):  # fmt: skip
            with self.assertRaisesRegex(TypeError, said):
                hip.half_angle(wrong)
            for call in (
                lambda wrong=wrong: hip.solve(wrong, [1, 0, 1]),
                lambda wrong=wrong: hip.vary({"geometry.radius_mm": wrong}),
                lambda wrong=wrong: hip.cycle(wrong, forces, rates=forces),
                lambda wrong=wrong: hip.cycle([0, 1, 2, 3], wrong, rates=forces),
                lambda wrong=wrong: hip.cycle([0, 1, 2, 3], forces, rates=wrong),
                lambda wrong=wrong: pin.cycle([0, 1, 2, 3], forces, angles=wrong),
            )[:None if wrong is not None else 4]:  # fmt: skip
                with self.assertRaisesRegex(TypeError, said):
                    call()
        with self.assertRaisesRegex(ValueError, "inhomogeneous"):
            hip.solve([[1, 2, 3], [1, 2]], [1, 0, 1])

    def test_with_units_are_refused(self):
        class Quantity:  # as pint's: NumPy takes its magnitude, as it is
            units = "kilonewton"

            def __init__(self, magnitude):
                self.magnitude = magnitude

            def to(self, unit):
                return self

            def __array__(self, dtype=None, copy=None):
                return np.array(self.magnitude, float)

        pin = libcontact.Joint.from_file(pin_file)
        forces = np.ones((4, 3))
        two = Quantity(2)
        three = Quantity([0, 0, 2])
        rows = Quantity(forces)
        for call in (
            lambda: hip.peak_pressure(two), lambda: hip.half_angle([1.0, two]),
            lambda: hip.solve(three, [1, 0, 1]),
            lambda: hip.solve([1, 0, 1], three),
            lambda: hip.vary({"geometry.radius_mm": Quantity([1, 2])}),
            lambda: hip.cycle(range(4), rows, rates=forces),
            lambda: pin.cycle(range(4), forces, angles=Quantity([1] * 4)),
        ):  # fmt: skip
            with self.assertRaisesRegex(TypeError, "a quantity with a unit"):
                call()

    def test_of_all_kinds_of_numbers_are_taken(self):
        exact = hip.half_angle([1.0, 1.0])
        for ones in (
            [1, 1], [True, True], np.ones(2, "f4"), np.ones(2, ">f8"),
            np.ones(2, "u1"), np.ones(4)[::2], np.ones((2, 2))[:, 0],
            np.ones(2, "g"),
        ):  # fmt: skip
            np.testing.assert_array_equal(hip.half_angle(ones), exact)

    def test_that_are_misspelt_are_said_before_what_is_missing(self):
        size = {"radius_mm": 14, "radial_clearance_um": 100}
        for call, said in (
            (lambda: libcontact.Joint(kind="balll", **size), "balll"),
            (lambda: libcontact.Joint(kind="balll"), "balll"),
            (lambda: libcontact.Joint(kind="pin", half_angle="hertzz"), "hertzz"),
            (lambda: libcontact.Joint(kind="pin"), "^a joint requires inner"),
            (lambda: libcontact.Joint(kind="ball", half_angle="hertzz", **size),
             "hertzz"),
            (lambda: libcontact.Joint(kind="ball", half_angle="exact", **size),
             "^a joint requires inner and outer"),
            (lambda: libcontact.half_angle(1, "hertzz"), "hertzz"),
            (lambda: libcontact.half_angle(1, kind="balll"), "balll"),
            (lambda: libcontact.half_angle(1), '^law "fitted" requires inner'),
        ):  # fmt: skip
            with self.assertRaisesRegex(libcontact.Error, said):
                call()

    def test_of_several_joints_are_sent_to_vary(self):
        metal = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
        for several in [50, 100], np.array([50.0, 100.0]):
            with self.assertRaisesRegex(
                libcontact.Error,
                "radial_clearance_um = .* must be a number; Joint.vary\\(\\) makes a "
                "joint of each$"):
                libcontact.Joint(kind="ball", radius_mm=14, inner=metal,
                                 outer=metal, radial_clearance_um=several)  # fmt: skip

    def test_that_do_not_go_have_the_sentences_of_python(self):
        case = libcontact.Case.from_file(case_file)
        cycle = hip.cycle([0, 1, 2, 3], np.ones((4, 3)), rates=np.ones((4, 3)))
        for call, said in (
            (lambda: hip.solve([0, 0, 1], axes=0),
             "Joint.solve() got an unexpected keyword argument 'axes'. Did you "
             "mean 'axis'?"),
            (lambda: hip.solve([0, 0, 1], omega=[0, 0, 1]),
             "Joint.solve() got an unexpected keyword argument 'omega'"),
            (lambda: hip.solve([0, 0, 1]),
             "Joint.solve() missing a required argument: 'angular_velocity'"),
            (lambda: libcontact.Run(3), "Run() does not take (int, bool)"),
            (lambda: libcontact.Play(3), "Play() does not take (int)"),
            (lambda: libcontact.damping_of_restitution(0.5),
             "damping_of_restitution() missing a required argument: 'speed'"),
            (lambda: libcontact.Joint(kind="ball", radial_clearence_um=20),
             "Joint() got an unexpected keyword argument 'radial_clearence_um'. "
             "Did you mean 'radial_clearance_um'?"),
            (lambda: hip.cycle([0, 1], [[0, 0, 1]] * 2, rate=0),
             "Joint.cycle() got an unexpected keyword argument 'rate'. Did you "
             "mean 'rates'?"),
            (lambda: cycle.wear(point=20),
             "Cycle.wear() got an unexpected keyword argument 'point'. Did you "
             "mean 'points'?"),
            (lambda: cycle.wear(1e-15),
             'body = 1e-15 must be "carrier" or "body"; wear_in() and plot() of '
             "the result take a wear coefficient, m^2/N: 1e-9 of one in "
             "mm^3/(N m)"),
            (lambda: libcontact.identify(hip, 1, 1, 1, sigmas=1),
             "identify() got an unexpected keyword argument 'sigmas'. Did you "
             "mean 'sigma'?"),
            (lambda: case.run(clearence=False),
             "Case.run() got an unexpected keyword argument 'clearence'. Did you "
             "mean 'clearance'?"),
            (lambda: libcontact.Run(case, clearence=False),
             "Run() got an unexpected keyword argument 'clearence'. Did you "
             "mean 'clearance'?"),
            (lambda: libcontact.Run(case).advance_to(1, progres=print),
             "Run.advance_to() got an unexpected keyword argument 'progres'. Did "
             "you mean 'progress'?"),
            (lambda: libcontact.study.run("s.toml", None, run=3),
             "run() got an unexpected keyword argument 'run'. Did you mean "
             "'runs'?"),
            (lambda: libcontact.half_angle(1, lw="hertz"),
             "half_angle() got an unexpected keyword argument 'lw'. Did you mean "
             "'law'?"),
            (lambda: libcontact.load_parameter(1, lw="hertz"),
             "load_parameter() got an unexpected keyword argument 'lw'. Did you "
             "mean 'law'?"),
            (lambda: libcontact.pressure(0, 1, lw="exact"),
             "pressure() got an unexpected keyword argument 'lw'"),
            (lambda: libcontact.friction_coefficients(0.5, 0.1, presure="exact"),
             "friction_coefficients() got an unexpected keyword argument "
             "'presure'. Did you mean 'pressure'?"),
        ):  # fmt: skip
            with self.assertRaises(TypeError) as caught:
                call()
            self.assertEqual(str(caught.exception), said)

    def test_of_one_key_in_two_units_are_refused_without_lines(self):
        metal = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
        with self.assertRaises(libcontact.Error) as caught:
            libcontact.Joint(
                kind="ball", radius_mm=14, radius_m=0.014, inner=metal,
                outer=metal, radial_clearance_um=10)  # fmt: skip
        self.assertEqual(
            str(caught.exception),
            "duplicate key geometry.radius_m as geometry.radius_mm")

    def test_may_be_one_name_or_an_array_without_dimension(self):
        rig = libcontact.Joint.from_file(rig_file)
        fit = libcontact.identify(
            rig, np.arange(9, 36).reshape(9, 3), [1, 0, 0], np.ones(9),
            parameters="coefficient")  # fmt: skip
        self.assertEqual(list(fit), ["coefficient"])
        key = "materials.friction.coefficient"
        self.assertEqual(hip.replace({key: np.array(0.1)})[key], 0.1)


class Habits(unittest.TestCase):
    def test_say_what_is_meant(self):
        metal = libcontact.materials["carbon steel"]
        for call, said in (
            (lambda: libcontact.materials["uhmwpe"], "there is 'UHMWPE'"),
            (lambda: libcontact.examples["hip_cup"],
             "there is 'joints/hip_cup.toml'"),
            (lambda: libcontact.examples["joints/hip_cap.toml"],
             "there is 'joints/hip_cup.toml'"),
            (lambda: libcontact.Joint("hip.toml"),
             "Joint.from_file('hip.toml') reads a file"),
            (lambda: libcontact.Joint(radius_mm=2), "requires kind"),
            (lambda: libcontact.Joint(kind="ball", clearance_um=50, inner=metal),
             "Did you mean 'radial_clearance_um'?"),
            (lambda: hip.replace(radios_mm=16), "Did you mean 'radius_mm'?"),
            (lambda: hip.tabulated(), "requires loads or table"),
        ):  # fmt: skip
            with self.assertRaises((TypeError, KeyError, ValueError)) as caught:
                call()
            self.assertIn(said, str(caught.exception))

    def test_replace_takes_the_keywords_of_joints(self):
        self.assertEqual(hip.replace(radius_mm=16),
                         hip.replace({"geometry.radius_mm": 16}))
        thin = hip.replace({"wall.layer[1].thickness_mm": 4}, radius_mm=16)
        self.assertEqual((thin.radius, thin["wall.layer[1].thickness_mm"]),
                         (0.016, 4))

    def test_without_matplotlib_plots_say_what_they_need(self):
        done = python(
            "import sys; sys.modules['matplotlib'] = None\n"
            "import libcontact\n"
            "libcontact.Joint.from_file("
            "libcontact.examples['joints/pin_joint.toml']).plot(1e3)")
        self.assertIn("ImportError: plot() requires matplotlib", done.stderr)

    def test_without_its_compiled_part_the_package_says_what_to_build(self):
        package = Path(libcontact.__file__).resolve().parent
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "libcontact").mkdir()
            for file in package.glob("*.py"):
                (Path(folder) / "libcontact" / file.name).write_text(
                    file.read_text())
            done = python("import libcontact",
                          env=os.environ | {"PYTHONPATH": folder})
        self.assertIn("has no compiled _core for Python 3.", done.stderr)
        self.assertIn("--target contact_python", done.stderr)


class Files(unittest.TestCase):
    def test_have_keys_as_dicts_have(self):
        self.assertIn("geometry.radius_mm", hip)
        self.assertIn("materials.friction", hip)
        self.assertNotIn("geometry.radius_m", hip)
        self.assertEqual(hip.get("geometry.radius_m", 7), 7)
        self.assertEqual(list(hip), hip.keys())
        for key in hip:
            self.assertIsNotNone(hip[key])
        self.assertIn("materials.outer.youngs_modulus_GPa", hip.keys())
        case = libcontact.Case.from_file(case_file)
        for key in 3, None, ("geometry",):
            self.assertNotIn(key, case)
            self.assertEqual(case.get(key, 7), 7)
            with self.assertRaises(KeyError):
                case[key]
        self.assertIn("body[1].hinge.joint[1].geometry.radius_mm", case.keys())

    def test_say_which_key_there_is(self):
        for key, said in (
            ("geometry.radius_m", "in geometry there is radius_mm"),
            ("geometri.radius_mm", "there is geometry.radius_mm"),
            ("wall.layer[2]", "there are 1"),
            ("friction.coefficient", "there is materials.friction.coefficient"),
        ):  # fmt: skip
            with self.assertRaises(KeyError) as caught:
                hip[key]
            self.assertEqual(caught.exception.args[0], f"{key}: {said}")
        case = libcontact.Case.from_file(case_file)
        for body, said in (
            ("stge", "there are 1: stage"), ("9", "there are 1"),
            ("xyz", "there are 1: stage"),
        ):  # fmt: skip
            with self.assertRaises(KeyError) as caught:
                case[f"body[{body}].mass_t"]
            self.assertEqual(
                caught.exception.args[0], f"body[{body}].mass_t: {said}")

    def test_need_no_other_files(self):
        case = libcontact.Case.from_file(case_file)
        key = "body[1].hinge.joint[1].friction.coefficient"
        rougher = hip.replace({"materials.friction.coefficient": 0.1})
        before = Path.cwd()
        with tempfile.TemporaryDirectory() as empty:
            os.chdir(empty)
            try:
                for joint in hip, rougher:
                    Path("joint.toml").write_text(joint.to_toml())
                    self.assertEqual(libcontact.Joint.from_file("joint.toml"), joint)
                    self.assertEqual(libcontact.Joint(**joint.to_dict()), joint)
                    self.assertNotIn(str(source), pickle.dumps(joint).decode("latin1"))
                for one in case, case.replace({key: 0.5}):
                    self.assertEqual(libcontact.Case(one.to_dict()), one)
                    self.assertNotIn(str(source), pickle.dumps(one).decode("latin1"))
            finally:
                os.chdir(before)
        again = pickle.loads(pickle.dumps(hip))
        key = "materials.friction.coefficient"
        self.assertEqual(again[key], hip[key])
        self.assertEqual(again.replace({key: 0.1}), rougher)

    def test_have_friction_wherever_it_stands(self):
        pin = source / "data/duty/stribeck_pin.toml"
        for joint, of in (
            (hip, ("dry", 0.0587, 0)),
            (pickle.loads(pickle.dumps(hip)), ("dry", 0.0587, 0)),
            (libcontact.Joint.from_file(rig_file), (None, None, None)),
            (libcontact.Joint.from_file(pin), ("stribeck", None, None)),
        ):  # fmt: skip
            said = joint.friction_law, joint.coefficient, joint.adhesion
            self.assertEqual(said, of)


if __name__ == "__main__":
    unittest.main()
