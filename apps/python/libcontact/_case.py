"""Separations: cases of hinge-separation and their outcomes."""

import json
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from os import PathLike, fspath
from typing import Any, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._calls import with_known_keywords
from ._files import FileText, toml_text
from ._results import html_table


class Event(NamedTuple):
    """An event of a run."""

    time: float  #: s
    body: str
    what: str


@dataclass(frozen=True)
class Outcome:
    """Results of a run."""

    #: Columns of the history by their names, "time_s", "stage.angle_deg", ...;
    #: modes are words.
    history: dict[str, NDArray[Any]] = field(repr=False)
    events: list[Event]
    #: As hinge-separation --output has it.
    summary: dict[str, Any] = field(repr=False)
    #: "", or why the run has come no further.
    failure: str


class Case(FileText, _core.Case):
    """A separation: bodies on hinges with friction, forces, events.

    Made from a file (from_file()) or from its tables as dicts, with keys and
    units as in case files (libcontact/docs/reference/case_file.md). A case is
    immutable: replace() makes another. Cases compare by their contents, and may
    be pickled; one in another process finds its joint files in the
    same folder.
    """

    def __init__(
        self,
        tables: Mapping[str, object],
        folder: str | PathLike[str] = "",
    ) -> None:
        """folder: base of the names of joint files."""
        self._read(toml_text(tables), "", fspath(folder), ())

    @with_known_keywords
    def run(
        self,
        *,
        clearance: bool = True,
        progress: Callable[[float, float], object] | None = None,
    ) -> Outcome:
        """Runs the case to its end. Ctrl-C stops it.

        clearance: whether to work out distances between bodies.
        progress: called ten times a second with the time and the end, s.

        A run that fails gives a RuntimeWarning and the results so far. Joints
        whose contact is outside the theory, or beyond the strength of its
        materials, give a ContactWarning.
        """
        of_run, notes = _core._run(self, clearance, progress)
        _warn_of_contacts(notes)
        outcome = _outcome(*of_run)
        if outcome.failure:
            warnings.warn(outcome.failure, RuntimeWarning, stacklevel=3)
        return outcome


RunStatus = Literal["running", "finished", "failed"]


class Run(_core.Run):
    """A running case, for loops that query it or simulate something else with
    it.

        run = Run(case)
        while run.advance_to(run.time + 0.1) == "running":
            print(run["stage.angle_deg"], run["stage.x_m", "stage.y_m"])

    Stops and queries do not change the later motion, which is bit-identical:
    at the end it has the outcome of Case.run().

    Values are named by the columns of the history
    (libcontact/docs/reference/separation_output.md), in the units of their
    names. Of each body NAME: NAME.x_m, NAME.vx_m_per_s and so on, of the centre of mass in inertial axes;
    NAME.qw to NAME.qz, the unit quaternion that turns the body's axes into
    inertial ones; NAME.wx_rad_per_s and so on in the body's axes. Of its hinge:
    NAME.mode and the loads of hinge, lock and friction on the body, in inertial
    axes: NAME.reaction_x_N, NAME.lock_reaction_x_N, NAME.friction_moment_x_N_m
    and so on.

    Runs share no data: each may have its own thread.

    copy.copy(run) is a run that continues from here bit-identically. Copying
    restarts the steps of both runs, as save() does.
    """

    @with_known_keywords
    def __init__(self, case: Case, *, clearance: bool = True) -> None:
        """At the start. clearance: whether to work out distances."""
        super().__init__(case, clearance)

    def __repr__(self) -> str:
        return (
            f"<libcontact.Run at {self.time:.6g} s of {self.end_time:.6g} s, "
            f"{self.status}>"
        )

    def _repr_html_(self) -> str:
        """With the events so far."""
        lines = [[f"{e.time:.6g}", e.body, e.what] for e in self.events]
        return html_table(repr(self)[1:-1], ["t, s", "body", "event"], lines)

    def __copy__(self) -> Self:
        """A run that continues from here bit-identically."""
        made = type(self).__new__(type(self))
        _core.Run.__init__(made, self)
        made.__dict__.update(self.__dict__)
        return made

    @with_known_keywords
    def advance_to(
        self,
        time: float,
        *,
        progress: Callable[[float, float], object] | None = None,
    ) -> RunStatus:
        """Advances to a time, s, or to the end of the case, whichever is
        first, with all events before. An exception, by Ctrl-C or progress(),
        stops the run; it may then be continued.

        progress: as in Case.run().

        "running": it has reached the time; "finished": it has reached the end
        of the case; "failed", with a RuntimeWarning: it cannot continue, see
        message. At the end it warns of contacts as Case.run() does.
        """
        status = self._advance_to(time, progress)
        if status != "running":
            _warn_of_contacts(self._contact_notes)
        if status == "failed":
            warnings.warn(self.message, RuntimeWarning, stacklevel=3)
        return status

    @property
    def inputs(self) -> dict[str, float]:
        """Loads from outside the case by their names, 0 at the start: of each
        body NAME NAME.applied_force_x_N to _z_N at its centre of mass and
        NAME.applied_moment_x_N_m to _z_N_m, in the body's axes; of a body on an
        axis NAME.applied_hinge_moment_N_m about it, with the opposite one on
        the body that carries the hinge, until that breaks. A carrier that is
        fixed or driven has none."""
        return dict(zip(*self._inputs))

    def set_inputs(self, values: Mapping[str, float]) -> None:
        """Sets some of the inputs: they act from `time` on, constant until they
        are set again; values at `time` are those before. save() keeps them."""
        numbers = list(self._inputs[1])
        for name, value in values.items():
            numbers[self._input(name)] = value
        self._set_inputs(numbers)

    def __getitem__(self, column: str | Iterable[str]) -> Any:
        """The present value of a column: a number, or the word of a mode; for
        several columns the array of their numbers.

        column: its name, or several names.
        """
        if not isinstance(column, str):
            return self.values()[[self._index(name) for name in column]]
        value = self.values()[self._index(column)]
        return _core._modes[int(value)] if column.endswith(".mode") else value

    @property
    def events(self) -> list[Event]:
        """Events so far."""
        return [Event(*event) for event in self._events]

    def outcome(self) -> Outcome:
        """Results so far. Their history has rows at the case's output
        times and events; Case.run() adds one where a run fails."""
        return _outcome(*self._outcome())


def _warn_of_contacts(notes: list[str]) -> None:
    for note in notes:
        warnings.warn(note, _core.ContactWarning, stacklevel=4)


def _outcome(
    columns: list[str],
    table: NDArray[np.float64],
    events: list[tuple[float, str, str]],
    summary: str,
    failure: str,
) -> Outcome:
    return Outcome(
        {name: _column(name, table[:, i]) for i, name in enumerate(columns)},
        [Event(*event) for event in events],
        json.loads(summary),
        failure,
    )


def _column(name: str, numbers: NDArray[np.float64]) -> NDArray[Any]:
    if name.endswith(".mode"):
        return np.array(_core._modes).take(numbers.astype(int))
    return numbers.copy()
