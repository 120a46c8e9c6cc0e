"""Friction of hinges: ball joints and pin joints with clearance.

Arrays in, arrays out, in SI units and radians; degrees only where a name ends
in _deg, and units of files where it ends in one. Shapes of arguments broadcast
by NumPy's rules; vectors are (..., 3).

    >>> import libcontact
    >>> hip = libcontact.Joint.from_file("hip.toml")
    >>> s = hip.solve([0, 0, 2000], [1.7, 0, 1])
    >>> s.half_angle, s.friction_moment

Invalid input raises Error with the message of the programs. Contacts outside
the theory, or beyond the strength of their materials, give a ContactWarning;
Joint.notes() returns the numbers.

Contents:

    Joint, Joints       a joint of a file or keywords; many that differ
    joint.solve()       friction and contact under a reaction: a Solution
    joint.at_rest()     whether it holds
    joint.step()        a step of a simulator
    joint.cycle()       a duty cycle: a Cycle with energy, wear() and wear_in()
    joint.plot(), plot_pressure(), and plot() of results, by matplotlib
    Play                joints with play
    Case, Run, study    separations of bodies, and many of them with scatter
    identify()          friction parameters from measured moments
    half_angle(), pressure(), friction_coefficients()   laws alone
    materials, examples what comes with the package
"""

import enum
import importlib.util
import sys
from typing import TYPE_CHECKING

if importlib.util.find_spec(f"{__name__}._core") is None:
    raise ImportError(
        f"libcontact in {__path__[0]} has no compiled _core for Python "
        f"{sys.version_info.major}.{sys.version_info.minor}: build it by cmake "
        "--build build --target contact_python, for the Python that CMake has "
        "found, or pip install the folder of the project"
    )

from . import _calls, _results, study  # the first two complete _core
from ._case import Case, Event, Outcome, Run
from ._core import (
    Coefficients,
    ContactWarning,
    Error,
    Estimate,
    ForceState,
    Impact,
    MomentSet,
    Play,
    PlayForce,
    Prox,
    Rating,
    RestSolution,
    Solution,
    Step,
    Stuck,
    WearIn,
    WornSeat,
    __version__,
    damping_of_restitution,
    step,
)
from ._examples import examples, materials
from ._joint import (
    Cycle,
    Fit,
    Joint,
    Wear,
    identify,
)
from ._joints import Joints

if TYPE_CHECKING:  # the stub of _core has all keys
    from ._core import (
        Layer,
        Material,
        Wall,
        friction_coefficients,
        half_angle,
        load_parameter,
        pressure,
    )
    from ._core import _HalfAngle as HalfAngleLaw
    from ._core import _Pressure as PressureLaw
else:
    from ._joint import (
        friction_coefficients,
        half_angle,
        load_parameter,
        pressure,
    )

    Layer = Material = Wall = dict
    HalfAngleLaw = PressureLaw = str


class Status(enum.IntEnum):
    """Status of an evaluation, as in Solution.status."""

    OK = 0
    OUT_OF_RANGE = 1
    NOT_CONVERGED = 2
    OUT_OF_SEAT = 3


class ContactState(enum.IntEnum):
    """Whether interference holds a joint's halves together: the values of
    Solution.contact_state."""

    CLOSED = 0
    LIFTED = 1
    ZERO = 2
    CLEARANCE = 3


class State(enum.IntEnum):
    """Motion of a joint's two halves: the values of Solution.state."""

    SLIDING = 0
    RESTING = 1
    UNLOADED = 2


if not TYPE_CHECKING:
    # Removed names, and their replacements.
    _gone = {
        "FinitePin": "write Joint.solve() with tilt, place or axial_velocity",
        "FinitePinSolution": "Solution has its quantities",
        "Seat": "a Joint with a [seat] is in it; Joint.tabulated() for tables",
        "SeatCycle": "Cycle has its quantities",
        "SeatRating": "Joint.pv() and Cycle.rating are a Rating",
        "SeatRestSolution": "RestSolution, whose slip has the seat's quantities",
        "SeatSolution": "Solution has its quantities",
        "SeatStatus": "Status has OUT_OF_SEAT, State UNLOADED",
    }

    def __getattr__(name):
        if name in _gone:
            raise AttributeError(f"libcontact.{name} is gone: {_gone[name]}")
        raise AttributeError(f"module 'libcontact' has no attribute '{name}'")


__all__ = [
    "Case",
    "Coefficients",
    "ContactState",
    "ContactWarning",
    "Cycle",
    "Error",
    "Estimate",
    "Event",
    "Fit",
    "ForceState",
    "HalfAngleLaw",
    "Impact",
    "Joint",
    "Joints",
    "Layer",
    "Material",
    "MomentSet",
    "Outcome",
    "Play",
    "PlayForce",
    "PressureLaw",
    "Prox",
    "Rating",
    "RestSolution",
    "Run",
    "Solution",
    "State",
    "Status",
    "Step",
    "Stuck",
    "Wall",
    "Wear",
    "WearIn",
    "WornSeat",
    "__version__",
    "damping_of_restitution",
    "examples",
    "friction_coefficients",
    "half_angle",
    "identify",
    "load_parameter",
    "materials",
    "pressure",
    "step",
    "study",
]
