"""libcontact.mujoco beside the adapter in C++: the same pendulum, loop, words."""

import tempfile
import unittest
from pathlib import Path

import libcontact
import mujoco
import numpy as np
from libcontact.mujoco import HingeFriction

FOLDER = Path(__file__).parent
BALL = FOLDER / "ball.toml"
PIN = FOLDER / "pin.toml"
PENDULUM = """<body><joint name='hip' type='ball'/><inertial mass='5'
    pos='0 0 -.4' diaginertia='.1 .1 .02'/></body>"""


def world(bodies, more="", gravity="0 0 -9.81", dt=1e-3):
    text = f"""<mujoco><compiler angle='radian'/><option timestep='{dt}'
        gravity='{gravity}'/><worldbody>{bodies}</worldbody>{more}</mujoco>"""
    with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
        file.write(text)
        file.flush()
        model = mujoco.MjModel.from_xml_path(file.name)
    return model, mujoco.MjData(model)


class Mujoco(unittest.TestCase):
    def test_pendulum_rests_and_stays(self):
        """Repeats HostMujoco.PendulumRestsAndStaysToTheLastBit."""
        model, data = world(PENDULUM)
        friction = HingeFriction(model)
        friction.add("hip", BALL)
        data.qpos[:2] = np.cos(0.5), np.sin(0.5)
        turned = np.array([[1, 0, 0], [0, np.cos(1), np.sin(1)], [0, -np.sin(1), np.cos(1)]])
        data.qvel[:] = turned @ [0, 1, 0.5]
        while data.time < 60 and not (data.time > 1 and not data.qvel.any()):
            friction.step(data)
        # The adapter in C++ says 43.607 s.
        self.assertAlmostEqual(data.time, 43.607, delta=0.02)
        angles = data.qpos.copy()
        for _ in range(2000):
            friction.step(data)
        np.testing.assert_array_equal(data.qpos, angles)
        self.assertFalse(data.qvel.any())

    def test_the_first_step_lets_go(self):
        """A body on a slope slides if friction cannot hold it."""
        model, data = world(PENDULUM)
        friction = HingeFriction(model)
        friction.add("hip", BALL)
        data.qpos[:2] = np.cos(0.5), np.sin(0.5)
        friction.step(data)
        self.assertTrue(data.qvel.any())

    def test_loop_and_damping_hold(self):
        """A four-bar linkage of pins that an equality closes; one has damping."""
        model, data = world(
            """<body name='a'><joint name='0' type='hinge' axis='0 1 0'
            damping='0.01'/><inertial mass='1' pos='0 0 -.25'
            diaginertia='.02 .02 .002'/><body name='b' pos='0 0 -.5'><joint
            name='1' type='hinge' axis='0 1 0'/><inertial mass='1' pos='.25 0 0'
            diaginertia='.002 .02 .02'/></body></body><body name='c'
            pos='.5 0 0'><joint name='2' type='hinge' axis='0 1 0'/><inertial
            mass='1' pos='0 0 -.25' diaginertia='.02 .02 .002'/></body>""",
            """<equality><connect body1='b' body2='c' anchor='.5 0 0'/>
            </equality>""",
            "0.002 0 -9.81",
        )
        friction = HingeFriction(model)
        for name in "012":
            friction.add(name, PIN)
        for _ in range(2000):
            friction.step(data)
        self.assertLess(abs(data.qpos[0]), 0.1)
        angles = data.qpos.copy()
        for _ in range(500):
            friction.step(data)
        np.testing.assert_array_equal(data.qpos, angles)
        self.assertLessEqual(friction.turns, 3)

    def test_seats_turn_with_their_body(self):
        """A world that is turned moves as it does level, and so do its seats."""
        cup = libcontact.Joint.from_file(libcontact.examples["joints/hip_cup.toml"])

        def moved(quat, gravity):
            model, data = world(
                f"""<body quat='{quat}'><body><joint name='hip' type='ball'/>
                <inertial mass='100' pos='0 0 -.4' diaginertia='5 5 5'/></body>
                </body>""",
                gravity=gravity,
            )
            friction = HingeFriction(model)
            friction.add("hip", cup)
            data.qvel[:] = 0.3, 0.1, 0.5
            for _ in range(20):
                friction.step(data)
            return data.qvel.copy()

        level = moved("1 0 0 0", "0 0 -9.81")
        # By 73.7 deg about x.
        turned = moved(".8 .6 0 0", f"0 {0.96 * 9.81} {-0.28 * 9.81}")
        np.testing.assert_allclose(turned, level, rtol=0, atol=1e-9)
        # A load that the seat does not carry has no friction.
        with self.assertRaisesRegex(libcontact.Error, "no value"):
            moved("0 1 0 0", "0 0 -9.81")

    def test_says_what_is_wrong(self):
        model, _ = world(
            PENDULUM
            + """<body><joint name='rail' type='slide'/><joint name='own'
            type='hinge' frictionloss='1'/><inertial mass='1' pos='0 0 0'
            diaginertia='1 1 1'/></body>"""
        )
        friction = HingeFriction(model)
        for name, file, message in [
            ("knee", BALL, "joint 'knee' must be one of the model: hip, own$"),
            ("rail", BALL, "joint 'rail' must be a ball or hinge"),
            ("own", PIN, "joint 'own' must have no frictionloss beside"),
            ("hip", PIN, "joint 'hip': .* must be a ball joint"),
        ]:
            with self.assertRaisesRegex(ValueError, message):
                friction.add(name, file)
        friction.add("hip", BALL)
        with self.assertRaisesRegex(ValueError, "friction of one file"):
            friction.add("hip", BALL)
        model.opt.integrator = 1
        with self.assertRaisesRegex(ValueError, "must be Euler"):
            friction.step(mujoco.MjData(model))


if __name__ == "__main__":
    unittest.main()
