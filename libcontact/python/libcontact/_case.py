"""Separations: cases of hinge-separation and what comes of them."""

import json
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from os import PathLike, fspath
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._files import FileText, toml_text


class Event(NamedTuple):
    """Something that happened."""

    time: float  #: s
    body: str
    what: str


@dataclass(frozen=True)
class Outcome:
    """What has come of a run."""

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
    units as in case files (libcontact's apps/separation/case_file.md). Nothing
    of a case changes: replace() makes another. Cases compare by what they say,
    and may be pickled; one in another process finds its joint files in the
    same folder.
    """

    def __init__(
        self,
        tables: Mapping[str, object],
        folder: str | PathLike[str] = "",
    ) -> None:
        """folder: what the names of joint files are relative to."""
        self._read(toml_text(tables), "", fspath(folder), ())

    def run(
        self,
        *,
        clearance: bool = True,
        progress: Callable[[float, float], object] | None = None,
    ) -> Outcome:
        """Moves the bodies to the end of the case. Ctrl-C ends it.

        clearance: whether to work out distances between bodies.
        progress: called ten times a second with the time and the end, s.

        A run that fails on its way gives a RuntimeWarning and what has come of
        it by then.
        """
        columns, table, events, summary, failure = self._run(
            clearance, progress
        )
        if failure:
            warnings.warn(failure, RuntimeWarning, stacklevel=2)
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
