"""Load laws as text: compiled and run, they have the joint's moments."""

import ctypes
import functools
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import libcontact
import numpy as np
from support import program, source, table

folder = source / "data/reference/load_law"
# All of them by scripts/check.sh long.
count = 100_000 if "CONTACT_LONG" in os.environ else 10_000
steel = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
# A pendulum's, with adhesion: the law needs its loads.
sticky = libcontact.Joint(
    kind="pin", radius_mm=20, radial_clearance_um=20, length_mm=40, inner=steel,
    outer=steel, coefficient=0.15, adhesion_Pa=2e4)  # fmt: skip


def joint_of(name):
    place = "duty" if name == "stribeck_pin" else "joints"
    joint = libcontact.Joint.from_file(source / f"data/{place}/{name}.toml")
    return joint.without_seat().without_relief()


@functools.cache
def kernel_of(name, language="c", error=1e-4):
    return joint_of(name).kernel(language, error=error)


def claims(text):
    """Errors in double and in float, least and largest load."""
    found = re.search(
        r"over \|?M.*?: (\S+) in double, (\S+) in float.* from (\S+)\W+to (\S+) N",
        text, re.S)  # fmt: skip
    return [float(number) for number in found.groups()]


batches = {
    "pin": """
void batch(long n, const KREAL *R, const KREAL *f, KREAL *M, KREAL *dM) {
  for (long i = 0; i < n; ++i) M[i] = friction(R[i], f[i], dM + i);
}
""",
    "ball": """
void batch(long n, const KREAL *R, const KREAL *w, const KREAL *f, KREAL *M,
           KREAL *out) {
  for (long i = 0; i < n; ++i) {
    out[3 * i + 1] = friction(R + 3 * i, w + 3 * i, *f, M + 3 * i, out + 3 * i);
    out[3 * i + 2] = friction_hold(R + 3 * i, w + 3 * i, *f);
  }
}
void gradients(long n, const KREAL *R, const KREAL *w, const KREAL *f,
               KREAL *dM_dR, KREAL *dM_dw) {
  for (long i = 0; i < n; ++i)
    friction_gradient(R + 3 * i, w + 3 * i, *f, dM_dR + 9 * i, dM_dw + 9 * i);
}
""",
}


@functools.cache
def compiled(text, kind, real="double"):
    """The text as C11, without a warning; as C++17 too."""
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "law.c"
        file.write_text(f"#define KREAL {real}\n{text}{batches[kind]}")
        flags = ["-O2", "-Wall", "-Wextra", "-pedantic", "-Werror"]
        cc, cxx = os.environ.get("CC", "cc"), os.environ.get("CXX", "c++")
        subprocess.check_call(
            [cxx, "-x", "c++", "-std=c++17", *flags, "-fsyntax-only", file])  # fmt: skip
        subprocess.check_call(
            [cc, "-std=c11", *flags, "-ffp-contract=off", "-shared", "-fPIC",
             file, "-o", f"{place}/law.so", "-lm"])  # fmt: skip
        return ctypes.CDLL(f"{place}/law.so")


def pin_in_c(text, load, f, real="double"):
    """M and dM/dR."""
    kind = np.float64 if real == "double" else np.float32
    load = np.ascontiguousarray(load, kind)
    given = [load, np.ascontiguousarray(f + 0 * load, kind)]
    out = [np.empty_like(load), np.empty_like(load)]
    compiled(text, "pin", real).batch(
        ctypes.c_long(load.size), *(x.ctypes.data_as(ctypes.c_void_p) for x in given + out))  # fmt: skip
    return [x.astype(float) for x in out]


def ball_in_c(text, R, w, f, real="double"):
    """M; normal force, flag, and the share of _hold() with w for the moment."""
    kind = np.float64 if real == "double" else np.float32
    R, w, f = (np.ascontiguousarray(x, kind) for x in (R, w, f))
    R, w = np.broadcast_arrays(R, w)
    given = [np.ascontiguousarray(x) for x in (R, w, f)]
    out = [np.empty_like(given[0]), np.empty_like(given[0])]
    compiled(text, "ball", real).batch(
        ctypes.c_long(R.size // 3), *(x.ctypes.data_as(ctypes.c_void_p) for x in given + out))  # fmt: skip
    M, rest = (x.astype(float) for x in out)
    return M, rest[..., 0], rest[..., 1], rest[..., 2]


def gradients_in_c(text, R, w, f):
    """dM/dR and dM/dw."""
    given = [np.ascontiguousarray(x, float) for x in (R, w, f)]
    out = [np.empty(given[0].shape + (3,)) for _ in range(2)]
    compiled(text, "ball").gradients(
        ctypes.c_long(given[0].size // 3), *(x.ctypes.data_as(ctypes.c_void_p) for x in given + out))  # fmt: skip
    return out


def in_node(text, call, values):
    """The answers of JavaScript to some values."""
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "law.mjs").write_text(text)
        (Path(place) / "run.mjs").write_text(
            "import * as law from './law.mjs';\nimport fs from 'fs';\n"
            "const x = JSON.parse(fs.readFileSync(0));\n"
            f"console.log(JSON.stringify(x.map(x => law.{call})));\n")  # fmt: skip
        done = subprocess.run(
            ["node", f"{place}/run.mjs"], input=json.dumps(values),
            capture_output=True, text=True, check=True)  # fmt: skip
    return json.loads(done.stdout)


def in_numpy(text):
    scope = {}
    exec(text, scope)
    return scope


def off(M, exact):
    """The largest error of vectors."""
    return np.max(np.linalg.norm(M - exact, axis=-1) / np.linalg.norm(exact, axis=-1))


def matrices_off(A, exact):
    size = lambda X: np.linalg.norm(X, axis=(-2, -1))
    return size(A - exact) / size(exact)


def ball_states(low, high, number=count):
    """Reactions and rates in random directions, a third of them close."""
    random = np.random.default_rng(75)
    R = random.normal(size=(number, 3))
    low, high = low * (1 + 1e-5), high * (1 - 1e-5)  # as they are printed
    R *= (np.exp(random.uniform(np.log(low), np.log(high), number)) / np.linalg.norm(R, axis=1))[:, None]
    across = np.cross(R, random.normal(size=(number, 3)))
    b = random.uniform(0, np.pi, number)
    close = random.random(number) < 0.3
    b[close] = np.exp(random.uniform(np.log(1e-4), np.log(3), close.sum()))
    unit = [x / np.linalg.norm(x, axis=1)[:, None] for x in (R, across)]
    w = unit[0] * np.cos(b)[:, None] + unit[1] * np.sin(b)[:, None]
    return R, w * np.exp(random.uniform(-9, 3, number))[:, None]


def relative(a, b):
    return np.max(np.abs(np.asarray(a) / b - 1))


def pin_states(joint, low, high):
    """Random loads with the coefficients and moments of the joint."""
    random = np.random.default_rng(57)
    load = np.exp(random.uniform(np.log(low), np.log(high), count))
    zero = 0 * load
    rate = np.exp(random.uniform(np.log(1e-4), np.log(30), count))
    s = joint.solve(
        np.stack([load, zero, zero], -1), np.stack([zero, zero, rate], -1), axis=[0, 0, 1])  # fmt: skip
    f = np.linalg.norm(s.friction_force, axis=-1) / s.normal_force
    return load, f, -s.friction_moment[:, 2]


class Pins(unittest.TestCase):
    def test_are_as_exact_as_they_say(self):
        for joint, error, loads in (
            (joint_of("pin_joint"), 1e-4, None),
            (joint_of("pin_joint"), 2e-6, None),
            (joint_of("wheel_pin"), 1e-6, None),
            (joint_of("stribeck_pin"), 1e-4, None),
            (joint_of("relieved_bush"), 1e-5, None),
            (joint_of("lined_bush_pressed"), 1e-4, None),
            (joint_of("lined_bush_pressed"), 3e-6, None),
            (sticky, 1e-6, (5.0, 5e4)),
        ):  # fmt: skip
            with self.subTest(joint=joint.name, error=error):
                text = joint.kernel(error=error, reaction=loads)
                double, single, low, high = claims(text)
                self.assertLessEqual(double, error * 1.05)  # as it is printed
                load, f, moment = pin_states(joint, low, high)
                if loads:
                    text = text.replace("KREAL *dM)", "KREAL f, KREAL *dM)")
                    text = text.replace("if (dM)", "(void)f; if (dM)")
                # The grid of the claim differs from these loads.
                M, slope = pin_in_c(text, load, f)
                self.assertLess(relative(M, moment), 1.2 * double)
                M, _ = pin_in_c(text, load, f, "float")
                self.assertLess(relative(M, moment), 1.2 * single)
                # Differences of second order, of M near its kinks at the ends.
                h = 1e-5
                more, less = (
                    pin_in_c(text, load * x, f)[0] for x in (1 + h, 1 - h))  # fmt: skip
                difference = (more - less) / (2 * h * load)
                off = np.abs(difference - slope) / (moment / load)
                self.assertLess(np.quantile(off, 0.999), 1e-6)

    # The joint's own moments, of version 0.2.0.
    def test_have_the_moments_of_the_table(self):
        with open(folder / "pins.csv") as file:
            rows = np.genfromtxt(file, delimiter=",", dtype=None, names=True,
                                 encoding="utf8")  # fmt: skip
        self.assertEqual(len(rows), 16)
        for name in ("pin_joint", "lined_bush_pressed"):
            of = rows[rows["joint"] == name]
            text = joint_of(name).kernel(error=3e-6)
            M, _ = pin_in_c(text, of["R_N"], of["f"])
            self.assertLess(relative(M, of["M_N_m"]), 3e-6)
        # Up to lift-off all digits are interference's.
        self.assertLess(relative(M[:2], of["M_N_m"][:2]), 1e-11)
        _, slope = pin_in_c(joint_of("pin_joint").kernel(error=1e-6), [1e5], 0.1)
        self.assertLess(relative(slope, 0.00224064223588), 1e-5)

    def test_are_the_same_in_javascript_and_numpy(self):
        for name, arguments in (
            ("pin_joint", {}), ("lined_bush_pressed", {}), ("sticky", {"reaction": (5, 5e4)}),
        ):  # fmt: skip
            joint = sticky if name == "sticky" else joint_of(name)
            load = np.geomspace(1, 1e5, 300)
            text = joint.kernel("numpy", **arguments)
            M, slope = in_numpy(text)["friction"](load)
            c = joint.kernel("c", **arguments)
            if arguments:
                c = c.replace("KREAL *dM)", "KREAL f, KREAL *dM)")
                c = c.replace("if (dM)", "(void)f; if (dM)")
            in_c, slope_in_c = pin_in_c(c, load, joint.coefficient)
            self.assertLess(relative(M, in_c), 1e-13)
            self.assertLess(relative(slope + M / load, slope_in_c + M / load), 1e-13)
            if shutil.which("node") is None:
                self.skipTest("nodejs is missing")
            js = np.array(in_node(joint.kernel("js", **arguments), "friction(x)", load.tolist()))  # fmt: skip
            self.assertLess(relative(js[:, 0], in_c), 1e-13)

    def test_NaN_stays(self):
        for joint, reaction in (
            (joint_of("pin_joint"), None), (joint_of("lined_bush_pressed"), None), (sticky, (5, 5e4)),
        ):  # fmt: skip
            law = in_numpy(joint.kernel("numpy", reaction=reaction))
            self.assertTrue(np.isnan(law["friction"](np.nan)).all())

    def test_are_what_the_program_prints(self):
        file = source / "data/joints/pin_joint.toml"
        for language in ("c", "cuda", "glsl", "jax", "js", "numpy", "st"):
            text, _ = program(
                "hinge-joint", "--joint", file, "--kernel", language,
                "--kernel-name", "wheel", "--kernel-error", 1e-5)  # fmt: skip
            joint = libcontact.Joint.from_file(file)
            self.assertEqual(text, joint.kernel(language, name="wheel", error=1e-5))
            same, _ = program(
                "hinge-joint", "kernel", file, "--language", language,
                "--error", 1e-5, "--kernel-name", "wheel")  # fmt: skip
            self.assertEqual(same, text)
            self.assertIn("wheel", text)
            self.assertNotIn("NAME", text)
            self.assertEqual("do not run" in text, language not in ("c", "js", "numpy"))

    # A pin of another size than in the page's numbers.
    def test_pairs_of_the_page(self):
        page = (source / "libcontact/docs/how-to/equivalent.md").read_text()
        pairs = re.findall(r"^\| steel [^|]*\|(.*, 0\..*)\|$", page, re.M)
        self.assertEqual(len(pairs), 5)
        for pair in pairs:
            E1, nu1, E2, nu2, L0, *c, error = map(float, re.split(r"[|,]", pair))
            pin = libcontact.Joint(
                kind="pin", radius_mm=3, radial_clearance_um=30, length_mm=9, coefficient=0.3,
                inner={"youngs_modulus_GPa": E1, "poissons_ratio": nu1},
                outer={"youngs_modulus_GPa": E2, "poissons_ratio": nu2})  # fmt: skip
            R0 = L0 * np.pi / 2 * 0.01 * 3e-3 * 9e-3 * pin.effective_modulus
            load, f, moment = pin_states(pin, R0 * 1e-4, R0 * 1e4)
            N = load / np.sqrt(1 + f**2)
            M = 3e-3 * f * N * np.polynomial.polynomial.polyval(N / (N + R0), c)
            self.assertLess(relative(M, moment), 1.1 * error)
            with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
                file.write(pin.to_toml())
                file.flush()
                rows = table("hinge-joint", "--joint", file.name, "--reaction",
                             "1,9", "--equivalent")  # fmt: skip
            law = {row["quantity"]: float(row["value"]) for row in rows}
            np.testing.assert_allclose(law["load_law_R0_N"], R0, rtol=1e-4)
            np.testing.assert_allclose(
                [law[f"load_law_c{i}"] for i in range(4)], c, rtol=0, atol=2e-5)

    def test_refusals(self):
        for keys, arguments, message in (
            ({}, {"error": 1e-9}, "an error of 1e-09 of the load law must be at least"),
            ({}, {"name": "a b"}, "the name a b of a function must be a letter"),
            ({}, {"language": "ada"}, 'unknown language "ada"'),
            ({}, {"reaction": (5, 5)}, "must be above 0, the first one less"),
            ({"half_angle.law": "hertz"}, {}, "that have a value there"),
            ({"friction.coefficient": 0.0}, {}, "with a coefficient above 0"),
        ):  # fmt: skip
            joint = joint_of("pin_joint").replace(keys)
            with self.assertRaisesRegex(libcontact.Error, message):
                joint.kernel(**arguments)


class Balls(unittest.TestCase):
    def test_are_as_exact_as_they_say(self):
        for name, error, numbers in (
            ("hip_cocr_uhmwpe", 6e-3, 54), ("hip_cocr_uhmwpe", 6e-4, 116),
            ("hip_cocr_uhmwpe", 1e-4, 202), ("hip_cocr_uhmwpe", 1e-6, 460),
            ("wheel_ball", 6e-4, 116), ("wheel_ball", 2e-5, 202), ("wheel_ball", 1e-6, 460),
            ("ball_stud", 6e-4, 116), ("ball_stud", 1.2e-4, 202), ("ball_stud", 1e-6, 460),
            ("spherical_plain_bearing", 2e-4, 116), ("spherical_plain_bearing", 1e-4, 202),
            ("spherical_plain_bearing", 1e-6, 460),
        ):  # fmt: skip
            with self.subTest(name=name, error=error):
                joint = joint_of(name)
                text = kernel_of(name, error=error)
                double, single, low, high = claims(text)
                self.assertLessEqual(double, error * 1.05)
                self.assertIn(f" {numbers} numbers.", text)
                if numbers < 460:  # monomials; more of them cancel in float
                    self.assertLessEqual(single, 1.2 * error)
                R, w = ball_states(low, high)
                s = joint.solve(R, w, threads=2)
                M, N, flag, _ = ball_in_c(text, R, w, joint.coefficient)
                self.assertLess(off(M, s.friction_moment), 1.2 * double)
                self.assertLess(relative(N, s.normal_force), max(double, 1e-4))
                self.assertFalse(flag.any())
                self.assertLess(np.max(np.sum(M * w, axis=1)), 0)
                M32, *_ = ball_in_c(text, R, w, joint.coefficient, "float")
                self.assertLess(off(M32, s.friction_moment), 1.5 * single)  # roundings
                # Turned back it resists the same, in a mirror.
                k = np.cross(w, R) / np.linalg.norm(np.cross(w, R), axis=1)[:, None]
                mirrored = 2 * np.sum(M * k, axis=1)[:, None] * k - M
                back, *_ = ball_in_c(text, R, -w, joint.coefficient)
                self.assertLess(off(back, mirrored), 1e-9)

    # There one formula takes over from the other.
    def test_have_no_step_at_the_rim(self):
        joint = joint_of("wheel_ball")
        for error in (2e-4, 1e-6):
            text = kernel_of("wheel_ball", error=error)
            double, _, low, high = claims(text)
            load = np.geomspace(1.1 * low, 0.9 * high, 50)
            R = np.stack([0 * load, 0 * load, load], -1)
            rate = lambda b: np.stack([np.sin(b), 0 * b, np.cos(b)], -1)
            inside, outside = 0 * load + 1e-6, 0 * load + np.pi / 2
            for _ in range(60):
                b = (inside + outside) / 2
                s = joint.solve(R, rate(b))
                is_outside = np.cos(s.slip_axis_angle) > np.sin(s.half_angle)
                inside, outside = np.where(is_outside, inside, b), np.where(is_outside, b, outside)
            # The two half-angles differ by 1e-6 of themselves at most.
            M = [ball_in_c(text, R, rate(b * x), joint.coefficient)[0] for x in (1 - 1e-4, 1 - 1e-5, 1, 1 + 1e-5, 1 + 1e-4)]
            for one, two, turn in zip(M, M[1:], (9e-5, 1e-5, 1e-5, 9e-5)):
                self.assertLess(off(one, two), 2 * double + 2 * turn)

    def test_take_another_coefficient(self):
        text = kernel_of("wheel_ball", error=1e-6)
        _, _, low, high = claims(text)
        R, w = ball_states(low, high, 20_000)
        slippery = joint_of("wheel_ball").replace({"friction.coefficient": 0.5})
        M, *_ = ball_in_c(text, R, w, 0.5)
        self.assertLess(off(M, slippery.solve(R, w).friction_moment), 1e-6)

    def test_have_the_moments_of_the_table(self):
        with open(folder / "balls.csv") as file:
            rows = np.genfromtxt(file, delimiter=",", dtype=None, names=True,
                                 encoding="utf8")  # fmt: skip
        self.assertEqual(len(rows), 20)
        for name, share in (
            ("hip_cocr_uhmwpe", (0.229068015303, 0.608166834066)),
            ("wheel_ball", (0.183277296419, 0.519408708057)),
        ):  # fmt: skip
            joint = joint_of(name)
            of = rows[rows["joint"] == name]
            b = np.radians(of["b_deg"])
            R = np.stack([0 * b, 0 * b, of["R_N"]], -1)
            w = np.stack([np.sin(b), 0 * b, np.cos(b)], -1)
            text = kernel_of(name, error=1e-6)
            M, N, flag, _ = ball_in_c(text, R, w, joint.coefficient)
            self.assertLess(off(M, np.stack([of[f"M_{x}_N_m"] for x in "xyz"], -1)), 1e-6)
            self.assertLess(relative(N, of["R_n_N"]), 1e-6)
            self.assertFalse(flag.any())
            R = np.array([[0, 0, 2000.0], [0, 0, 50]])
            moment = np.array([[0.3, 0, 0.1], [0.002, 0, 0.004]])
            *_, used = ball_in_c(text, R, moment, joint.coefficient)
            self.assertLess(relative(used, share), 2e-5)

    def test_rest_as_the_joint(self):
        for name in ("hip_cocr_uhmwpe", "wheel_ball"):
            joint = joint_of(name)
            text = kernel_of(name, error=1e-6)
            _, _, low, high = claims(text)
            R, moment = ball_states(low, high, 2000)
            *_, used = ball_in_c(text, R, moment, joint.coefficient)
            exact = joint.at_rest(R, moment).utilisation
            self.assertLess(relative(used, exact), 2e-5)

    def test_have_the_gradients_of_the_joint(self):
        for name, error, most, usual in (
            ("hip_cocr_uhmwpe", 1e-6, 1e-4, 1e-5), ("wheel_ball", 1e-6, 6e-5, 3e-6),
            ("spherical_plain_bearing", 1e-4, 3e-3, 2e-4),
        ):  # fmt: skip
            joint = joint_of(name)
            text = kernel_of(name, error=error)
            _, _, low, high = claims(text)
            R, w = ball_states(low, high, 3000)
            got = gradients_in_c(text, R, w, joint.coefficient)
            exact = joint.derivatives(R, w)
            for of, key in zip(got, ("over_reaction", "over_rate")):
                errors = matrices_off(of, exact[key])
                self.assertLess(errors.max(), most, (name, key))
                self.assertLess(np.quantile(errors, 0.99), usual, (name, key))

    def test_have_gradients_everywhere(self):
        text = kernel_of("wheel_ball", error=1e-6)
        joint = joint_of("wheel_ball")
        _, _, low, high = claims(text)
        # Along the load and beside it.
        for w in ([0, 0, 2.0], [0, 0, -2.0]):
            R = np.array([[0, 0, 2000.0], [2e-6, 0, 2000.0]])
            of, by = (gradients_in_c(text, R, np.array([w, w]), 0.2))
            exact = joint.derivatives(R, w)
            self.assertLess(matrices_off(of, exact["over_reaction"]).max(), 1e-4)
            self.assertLess(matrices_off(by, exact["over_rate"]).max(), 1e-4)
            self.assertLess(matrices_off(of[1], of[0]), 1e-5)
        # Beyond its loads M is proportional to R, and of degree 0 in w always.
        R, w = ball_states(low, high, 300)
        for scale in (high / low, 1, low / high):
            of, by = gradients_in_c(text, scale * R, w, 0.2)
            M, *_ = ball_in_c(text, scale * R, w, 0.2)
            size = np.linalg.norm(M, axis=1) / np.linalg.norm(w, axis=1)
            turned = np.linalg.norm(np.einsum("nij,nj->ni", by, w), axis=1)
            self.assertLess(np.max(turned / size / np.linalg.norm(w, axis=1)), 1e-9)
            if scale != 1:
                along = np.einsum("nij,nj->ni", of, scale * R)
                self.assertLess(off(along, M), 1e-6)
        zero, rate = gradients_in_c(text, R, 0 * w, 0.2)
        self.assertFalse(zero.any() or rate.any())

    # The step of simulator.md: W (w - free) = M(R, w), by Newton's method.
    def test_make_implicit_steps(self):
        joint = joint_of("hip_cocr_uhmwpe")
        text = kernel_of("hip_cocr_uhmwpe", error=1e-6)
        f = joint.coefficient
        random = np.random.default_rng(12)
        counts, held = [], 0
        for _ in range(200):
            R = random.normal(size=3)
            R *= np.exp(random.uniform(np.log(20), np.log(2e4))) / np.linalg.norm(R)
            Q, _ = np.linalg.qr(random.normal(size=(3, 3)))
            W = Q @ np.diag(10 ** random.uniform(-1, 1, 3)) @ Q.T
            free = random.normal(size=3)
            free *= np.linalg.norm(R) * joint.radius * f * 10 ** random.uniform(-1, 1) / np.linalg.norm(W @ free)
            share = ball_in_c(text, R, -W @ free, f)[3]
            if share <= 1:
                held += 1
                continue
            left = lambda w: W @ (w - free) - ball_in_c(text, R, w, f)[0]
            w, count = free * (1 - 1 / share), 0
            # The law's own equation is solved to some 3e-8.
            while np.linalg.norm(left(w)) > 1e-7 * np.linalg.norm(W @ free) and count < 40:
                step = np.linalg.solve(W - gradients_in_c(text, R, w, f)[1], -left(w))
                for _ in range(20):
                    if np.linalg.norm(left(w + step)) <= np.linalg.norm(left(w)):
                        break
                    step /= 2
                w, count = w + step, count + 1
            self.assertLess(count, 40)
            counts.append(count)
            M = joint.solve(R, w).friction_moment
            self.assertLess(np.linalg.norm(W @ (w - free) - M), 2e-6 * np.linalg.norm(M))
        self.assertLess(np.mean(counts), 6)
        self.assertGreater(held, 20)

    def test_flags(self):
        text = kernel_of("hip_cocr_uhmwpe", error=1e-3)
        _, _, low, high = claims(text)
        w = np.array([1.0, 2, 3])
        for R, rate, flag in (
            ([0, 0, 100.0], w, 0), ([0, 0, low / 2], w, 1), ([0, 0, 2 * high], w, 1),
            ([0, 0, 0.0], w, 2), ([0, 0, 100.0], 0 * w, 2), ([0, 0, np.nan], w, 4),
            ([0, 0, 100.0], w * np.nan, 4),
        ):  # fmt: skip
            M, _, got, _ = ball_in_c(text, np.array(R), rate, 0.0587)
            self.assertEqual(got, flag)
            self.assertEqual(np.isnan(M).all(), flag == 4)
            self.assertEqual((M == 0).all(), flag == 2)
        one, two = (
            ball_in_c(text, np.array([0, 0, x * high]), w, 0.0587)[0] for x in (2, 4))  # fmt: skip
        np.testing.assert_allclose(two, 2 * one, rtol=1e-12)

    def test_are_the_same_in_javascript_and_numpy(self):
        joint = joint_of("wheel_ball")
        _, _, low, high = claims(kernel_of("wheel_ball"))
        R, w = ball_states(low, high, 300)
        M, N, flag, used = ball_in_c(kernel_of("wheel_ball"), R, w, joint.coefficient)
        law = in_numpy(kernel_of("wheel_ball", "numpy"))
        # All rounds are run there, so that the last bits differ from C's.
        self.assertLess(off(law["friction"](R, w)[0], M), 1e-5)
        self.assertLess(relative(law["friction_hold"](R, w), used), 1e-12)
        if shutil.which("node") is None:
            self.skipTest("nodejs is missing")
        js = in_node(kernel_of("wheel_ball", "js"), "friction(...x)",
                     np.stack([R, w], 1).tolist())  # fmt: skip
        self.assertLess(off(np.array([x[0] for x in js]), M), 1e-12)
        self.assertLess(relative([x[1] for x in js], N), 1e-12)
        self.assertEqual([x[2] for x in js], flag.tolist())
        js = in_node(kernel_of("wheel_ball", "js"), "friction_gradient(...x)",
                     np.stack([R, w], 1).tolist())  # fmt: skip
        for at in (0, 1):
            in_js = np.array([x[at] for x in js]).reshape(-1, 3, 3)
            exact = gradients_in_c(kernel_of("wheel_ball"), R, w, joint.coefficient)[at]
            of_numpy = law["friction_gradient"](R, w)[at]
            for of, most in ((in_js, 1e-11), (of_numpy, 1e-4)):
                self.assertLess(matrices_off(of, exact).max(), most)

    def test_refusals(self):
        for keys, arguments, message in (
            ({"friction.adhesion_Pa": 1e6}, {}, "the load law of a ball requires"),
            ({"friction.coefficient": 1.5}, {}, "the load law of a ball requires"),
            ({"geometry.radial_clearance_um": 0.0}, {}, "the load law of a ball requires"),
            ({}, {"error": 1e-9}, "must be at least"),
            ({}, {"language": "st"}, "the language st of a ball's load law must be"),
            ({}, {"reaction": (5, 1)}, "above 0, the first one less"),
        ):  # fmt: skip
            joint = joint_of("wheel_ball").replace(keys)
            with self.assertRaisesRegex(libcontact.Error, message):
                joint.kernel(**arguments)


if __name__ == "__main__":
    # Laws are compared at loads that no steel bears.
    unittest.main(warnings="ignore")
