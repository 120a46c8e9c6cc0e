"""Printing and indexing of results."""

import html
import itertools
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._plots import plot_solution

#: Numbers that are words of an enumeration here alone.
_words = {"contact_state": "ContactState"}

#: As many rows are printed.
_most = 4


def _word(number: Any, words: str) -> str:
    import libcontact

    return str(getattr(libcontact, words)(number).name)


def _text(value: Any, words: str = "", digits: int = 6) -> str:
    """A number, a vector or a word for people."""
    if words:
        return _word(value, words)
    if np.ndim(value):
        return "(" + ", ".join(_text(x, "", digits) for x in value) + ")"
    return f"{value:.{digits}g}"


def columns_of(
    shape: tuple[int, ...],
) -> tuple[list[str], list[tuple[int, ...]], list[str]]:
    """Headings and places of the printed rows, and the text for the others."""
    places = list(itertools.islice(np.ndindex(*shape), _most))
    heads = [", ".join(map(str, p)) for p in places] if shape else [""]
    is_whole = len(places) == np.prod(shape, dtype=int)
    return heads, places, [] if is_whole else ["..."]


def _table(self: Any) -> tuple[list[str], list[list[str]]]:
    """Headings and lines, a quantity each: key, unit, values; those that are
    NaN in all rows are left out."""
    heads, places, rest = columns_of(self.shape)
    digits = 4 if self.shape else 6
    lines = []
    for key, _, unit, _, words in self._quantities:
        words = words or _words.get(key, "")
        values = getattr(self, key)
        shown = [values[p] if p else values for p in places]
        if shown and np.isnan(shown).all():
            continue
        line = [_text(value, words, digits) for value in shown]
        lines.append([key, unit, *line, *rest])
    return ["", "", *heads, *rest], lines


def _title(self: Any) -> str:
    of = f" of shape {self.shape}" if self.shape else ""
    return f"libcontact.{type(self).__name__}{of}"


def aligned(lines: Sequence[Sequence[str]]) -> str:
    """Lines of a table, whose first column is on the left."""
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join(
        "  ".join(
            cell.ljust(width) if k < 2 else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths))
        ).rstrip()
        for line in lines
    )


def html_table(
    title: str, heads: Sequence[str], lines: Sequence[Sequence[str]]
) -> str:
    def row(cells: Sequence[str], tag: str) -> str:
        inside = "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells)
        return f"<tr>{inside}</tr>"

    body = "".join(row(line, "td") for line in lines)
    head = row(heads, "th") if any(heads) else ""
    return f"<table><caption>{html.escape(title)}</caption>{head}{body}</table>"


def _repr(self: Any) -> str:
    heads, lines = _table(self)
    shown = [heads, *lines] if self.shape else lines
    return _title(self) + "\n" + aligned(shown)


def _repr_html(self: Any) -> str:
    return html_table(_title(self), *_table(self))


def _len(self: Any) -> int:
    if not self.shape:
        raise TypeError("len() of a single row")
    return int(self.shape[0])


def _bool(self: Any) -> bool:
    return 0 not in self.shape


def _numbered(self: Any) -> NDArray[np.uintp]:
    """The numbers of the rows in their shape."""
    size = np.prod(self.shape, dtype=int)
    return np.arange(size, dtype=np.uintp).reshape(self.shape)


def _getitem(self: Any, index: Any) -> Any:
    return self._rows(_numbered(self)[index])


def _iter(self: Any) -> Iterator[Any]:
    if not self.shape:
        raise TypeError("iteration over a single row")
    return (self[i] for i in range(self.shape[0]))


def reshape(self: Any, *shape: Any) -> Any:
    """The same rows in another shape, as numpy.reshape() has it."""
    return self._rows(_numbered(self).reshape(*shape))


def to_dict(self: Any) -> dict[str, NDArray[Any]]:
    """All quantities as columns of the rows' shape, vectors as three (NAME_x,
    NAME_y, NAME_z): pandas.DataFrame(s.reshape(-1).to_dict())."""
    columns: dict[str, NDArray[Any]] = {}
    for key, *_ in self._quantities:
        values = getattr(self, key)
        if np.ndim(values) == len(self.shape):
            columns[key] = values
        else:
            for k, end in enumerate("xyz"):
                columns[f"{key}_{end}"] = values[..., k]
    return columns


def to_xarray(self: Any, dims: Sequence[str] | None = None) -> Any:
    """An xarray.Dataset of all quantities with their units and meanings; parts
    of vectors are along "part".

    dims: names of the rows' dimensions; "dim_0" and so on if it is None.
    """
    names = tuple(dims or (f"dim_{i}" for i in range(len(self.shape))))
    import xarray

    variables = {}
    for key, _, unit, meaning, _ in self._quantities:
        values = getattr(self, key)
        is_vector = np.ndim(values) > len(self.shape)
        variables[key] = (
            (*names, "part") if is_vector else names,
            values,
            {"long_name": meaning, "units": unit},
        )
    return xarray.Dataset(variables, coords={"part": list("xyz")})


def _cycle_lines(self: Any) -> list[list[str]]:
    return [
        [key, unit, _text(getattr(self, key))]
        for key, _, unit, *_ in self._quantities
    ]


def _cycle_title(self: Any) -> str:
    return f"libcontact.{type(self).__name__} of {len(self.time)} rows"


def _cycle_repr(self: Any) -> str:
    return _cycle_title(self) + "\n" + aligned(_cycle_lines(self))


def _cycle_html(self: Any) -> str:
    return html_table(_cycle_title(self), [], _cycle_lines(self))


def _fit_table(self: Any) -> tuple[list[str], list[list[str]]]:
    """Lines of hinge-identify's report."""
    columns = {key: column for key, column, _, _ in self._parameters}
    names = {key: name for key, _, name, _ in self._parameters}
    meanings = {key: meaning for key, *_, meaning in self._parameters}
    has_profile = any(np.isfinite(e.profile).any() for e in self.parameters.values())

    def line(symbol: str, value: Any, meaning: str) -> list[str]:
        numbers = [float(value), *[np.nan] * (5 if has_profile else 3)]
        if isinstance(value, _core.Estimate):
            numbers[1:4] = [value.standard_error, *value.interval]
            numbers[4:] = value.profile if has_profile else ()
        cells = ["" if np.isnan(x) else f"{x:.6g}" for x in numbers]
        return [symbol, meaning, *cells]

    lines = [line(columns[k], e, meanings[k]) for k, e in self.parameters.items()]
    for key, symbol, meaning in self._quantities:
        if key == "condition":
            for (i, a), (j, b) in itertools.combinations(
                enumerate(self.parameters), 2
            ):
                name = f"correlation_{names[a]}_{names[b]}"
                lines.append(line(name, self.correlation[i, j], "of their errors"))
        value = getattr(self, key)
        if np.ndim(value) == 0:
            lines.append(line(symbol, value, meaning))
    heads = ["", "", "value", "standard_error", "low", "high"]
    return heads + ["profile_low", "profile_high"] * has_profile, lines


def _fit_repr(self: Any) -> str:
    heads, lines = _fit_table(self)
    end = "" if self.converged else ", which has not converged"
    return f"libcontact.Fit{end}\n" + aligned([heads, *lines])


def _fit_html(self: Any) -> str:
    return html_table("libcontact.Fit", *_fit_table(self))


def _attach() -> None:
    manners = {
        "__repr__": _repr,
        "_repr_html_": _repr_html,
        "__len__": _len,
        "__bool__": _bool,
        "__getitem__": _getitem,
        "__iter__": _iter,
        "reshape": reshape,
        "to_dict": to_dict,
        "to_xarray": to_xarray,
    }
    for of in vars(_core).values():
        if isinstance(of, type) and hasattr(of, "_rows"):
            for name, function in manners.items():
                setattr(of, name, function)
    _core.Solution.plot = plot_solution  # type: ignore
    _core.Cycle.__repr__ = _cycle_repr  # type: ignore
    _core.Cycle._repr_html_ = _cycle_html  # type: ignore
    _core.Fit.__repr__ = _fit_repr  # type: ignore
    _core.Fit._repr_html_ = _fit_html  # type: ignore


_attach()
