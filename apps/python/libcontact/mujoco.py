"""Friction of libcontact in balls and hinges of a MuJoCo model.

    >>> friction = HingeFriction(model)
    >>> friction.add("hip", "hip.toml")
    >>> while data.time < 60:
    ...     friction.step(data)  # in place of mujoco.mj_step(model, data)

The adapter of apps/hosts/mujoco in Python, with its limits: Euler's step, and
reactions of the previous step. A hinge held by friction has a rate of exactly
0, and its angles stay bit-identical.
"""

from os import PathLike
from typing import Any

import mujoco
import numpy as np

from ._core import Mechanism
from ._joint import Joint

_joint_type = 3  # mjOBJ_JOINT
_sizes = {1: ("ball", 3, 4), 3: ("pin", 1, 1)}  # by mjtJoint: dofs, of qpos
_linear = 1  # mjCNSTRSTATE_QUADRATIC
_turn_limit = 50


class HingeFriction:
    """Friction of joint files in joints of one model."""

    def __init__(self, model: Any) -> None:
        self._model = model
        self._joints: list[Joint] = []
        self._ids: list[int] = []
        self._mechanism: Mechanism | None = None
        self._has_reactions = False
        self.turns = 0
        """Of friction and constraints in the last step."""

    def add(self, name: str, joint: Joint | str | PathLike[str]) -> None:
        """Friction of a joint, or of a joint file, in a ball or hinge."""
        model = self._model
        if not isinstance(joint, Joint):
            joint = Joint.from_file(joint)
        i = mujoco.mj_name2id(model, _joint_type, name)
        if i < 0:
            names = (
                mujoco.mj_id2name(model, _joint_type, j)
                for j, kind in enumerate(model.jnt_type)
                if int(kind) in _sizes
            )
            known = ", ".join(filter(None, names))
            raise ValueError(f"joint {name!r} must be one of the model: {known}")
        kind, _, _ = _sizes.get(int(model.jnt_type[i]), ("", 0, 0))
        if not kind:
            raise ValueError(f"joint {name!r} must be a ball or hinge")
        if joint.kind != kind:
            raise ValueError(f"joint {name!r}: {joint.name} must be a {kind} joint")
        if np.any(self._of(model.dof_frictionloss, i)):
            raise ValueError(
                f"joint {name!r} must have no frictionloss beside this friction"
            )
        if i in self._ids:
            raise ValueError(f"joint {name!r} must have friction of one file")
        self._joints.append(joint)
        self._ids.append(i)
        self._mechanism = None

    def _of(self, dofs: Any, i: int) -> Any:
        first = int(self._model.jnt_dofadr[i])
        return dofs[first : first + _sizes[int(self._model.jnt_type[i])][1]]

    def step(self, data: Any) -> None:
        """Replaces mujoco.mj_step()."""
        model = self._model
        if model.opt.integrator != 0:
            raise ValueError("the integrator must be Euler")
        if model.opt.enableflags & getattr(
            getattr(mujoco, "mjtEnableBit", None), "mjENBL_SLEEP", 0
        ):
            raise ValueError("bodies must not sleep: friction holds them")
        dt = model.opt.timestep
        likely = data.qvel + dt * data.qacc
        mujoco.mj_checkPos(model, data)
        mujoco.mj_checkVel(model, data)
        mujoco.mj_forward(model, data)
        mujoco.mj_checkAcc(model, data)
        if not self._joints:
            mujoco.mj_Euler(model, data)
            return
        if self._mechanism is None:
            first = [int(model.jnt_dofadr[i]) for i in self._ids]
            self._mechanism = Mechanism(self._joints, first, model.nv)
        mechanism = self._mechanism
        smooth = data.qfrc_smooth.copy()
        force = np.zeros(model.nv)
        damped = self._weigh(data)
        if model.dof_damping.any():
            self._accelerate(data, smooth, damped)
        if not self._has_reactions:  # as if rates stayed as they are
            force = mechanism.hold(data.qvel, data.qvel + dt * data.qacc)
            self._accelerate(data, smooth + force, damped)
            mujoco.mj_rnePostConstraint(model, data)
            self._has_reactions = True
        mechanism.begin(*self._starts(data), data.qvel, likely)
        for self.turns in range(1, _turn_limit + 1):
            force, change = mechanism.turn(data.qvel + dt * data.qacc, force)
            self._accelerate(data, smooth + force, damped)
            if data.nefc == 0 or change <= 1e-8:
                break
            self._weigh(data)
        mujoco.mj_rnePostConstraint(model, data)
        self._finish(data)

    def _starts(self, data: Any) -> tuple[Any, Any, Any]:
        """Vectors of balls in the axes of their body, of hinges in world axes."""
        model = self._model
        reactions, axes, turns = [], [], []
        assert self._mechanism is not None
        on_parent = self._mechanism.seats_on_carrier
        for i, joint, is_on_parent in zip(self._ids, self._joints, on_parent):
            body = model.jnt_bodyid[i]
            reaction = data.cfrc_int[body, 3:]
            turn = np.eye(3)
            if joint.kind == "ball":
                own = data.xmat[body].reshape(3, 3)
                reaction = own.T @ reaction
                if is_on_parent:
                    parent = model.body_parentid[body]
                    turn = own.T @ data.xmat[parent].reshape(3, 3)
            reactions.append(reaction)
            axes.append(data.xaxis[i])
            turns.append(turn)
        return reactions, axes, turns

    def _weigh(self, data: Any) -> Any:
        """Gives the mechanism the mass matrix with damping."""
        model = self._model
        inertia = np.zeros((model.nv, model.nv))
        if hasattr(data, "qM"):  # up to 3.9
            mujoco.mj_fullM(model, inertia, data.qM)
        else:
            mujoco.mj_fullM(model, data, inertia)
        inertia += model.opt.timestep * np.diag(model.dof_damping)
        linear = np.flatnonzero(np.asarray(data.efc_state[: data.nefc]) == _linear)
        rows = np.zeros((len(linear), model.nv))
        for row, k in zip(rows, linear):
            one = np.zeros(data.nefc)
            one[k] = 1
            mujoco.mj_mulJacTVec(model, data, row, one)
        stiffness = np.asarray(data.efc_D)[linear]
        assert self._mechanism is not None
        self._mechanism.weigh(inertia, rows, stiffness, model.opt.timestep)
        return inertia

    def _accelerate(self, data: Any, smooth: Any, damped: Any) -> None:
        model = self._model
        data.qfrc_smooth[:] = smooth
        if data.nefc:
            plain = damped - model.opt.timestep * np.diag(model.dof_damping)
            data.qacc_smooth[:] = np.linalg.solve(plain, smooth)
            mujoco.mj_fwdConstraint(model, data)
        data.qacc[:] = np.linalg.solve(damped, smooth + data.qfrc_constraint)

    def _finish(self, data: Any) -> None:
        """MuJoCo's step; hinges that friction holds stay where they are."""
        assert self._mechanism is not None
        kept = data.qpos.copy()
        mujoco.mj_Euler(self._model, data)
        for i, holds in zip(self._ids, self._mechanism.holds):
            if holds:
                self._of(data.qvel, i)[:] = 0
                first = int(self._model.jnt_qposadr[i])
                count = _sizes[int(self._model.jnt_type[i])][2]
                data.qpos[first : first + count] = kept[first : first + count]
