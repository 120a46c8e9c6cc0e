"""Pictures of joints and results by matplotlib, if it is installed.

Notebooks show the figures; elsewhere call matplotlib.pyplot.show().
"""

import textwrap
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

if TYPE_CHECKING:
    from ._joint import Cycle, Joint, Wear

Floats = NDArray[np.float64]

#: The look of plots/style.gp.
colours = (
    "#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#888888",
)  # fmt: skip
#: Colours of laws, in all pictures.
law_colours = {
    "exact": colours[5], "fitted": colours[0], "tanh": colours[2],
    "arctan": colours[3], "hertz": colours[1], "blend": colours[4],
    "paper": colours[6], "cosine": colours[0], "worn": colours[1],
    "sqrt_tan": colours[2], "sqrt_theta": colours[3], "mixture": colours[4],
}  # fmt: skip
_palette = (
    (0, "#e9e9e9"), (0.002, "#dbe6f3"), (0.25, "#92b4dc"), (0.5, "#f7d06b"),
    (0.75, "#ee7a3a"), (1, "#a11021"),
)  # fmt: skip
_style = {
    "figure.constrained_layout.use": True,
    "axes.edgecolor": "#555555",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "grid.color": "#e4e4e4",
    "lines.linewidth": 2,
    "font.size": 9,
    "axes.titlesize": 10,
}


class _Paper:
    """Axes one below the other, or the caller's."""

    def __init__(self, panels: int, axes: Any, size: tuple[float, float]) -> None:
        try:
            from matplotlib import pyplot
        except ImportError as error:
            raise ImportError(
                "plot() requires matplotlib: python3-matplotlib of Debian, or "
                "pip install matplotlib"
            ) from error
        if axes is None:
            with pyplot.rc_context(_style):
                _, axes = pyplot.subplots(panels, sharex=True, figsize=size)
        self.axes = list(np.atleast_1d(axes).flat)
        if len(self.axes) != panels:
            raise _core.Error(
                f"axes of {len(self.axes)} panels must be {panels}, as of "
                f"matplotlib.pyplot.subplots({panels})"
            )


def _shown(values: Floats, unit: str) -> tuple[Floats, str]:
    """Numbers and their unit with a prefix that leaves them short."""
    if unit in ("", "1", "-"):
        return values, ""
    if unit.startswith("rad"):
        return np.degrees(values), unit.replace("rad", "deg", 1)
    if unit == "m^2":
        return values * 1e6, "mm²"
    most = np.max(np.abs(values), initial=0, where=np.isfinite(values))
    prefixes = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"))
    size = most if most > 0 else 1.0
    factor, prefix = next(((f, p) for f, p in prefixes if size >= f), (1e-9, "n"))
    return values / factor, prefix + unit.replace("^2", "²")


def _label(name: str, unit: str) -> str:
    return f"{name}, {unit}" if unit else name


def _length(values: ArrayLike, rows: int) -> Floats:
    """The values, or the lengths of vectors."""
    array = np.asarray(values, dtype=float)
    return np.asarray(np.linalg.norm(array, axis=-1)) if array.ndim > rows else array


def _column(of: Any, key: str) -> tuple[Floats, str]:
    """A quantity of results, in a row, and its label with the unit."""
    units = {k: unit for k, _, unit, *_ in of._quantities}
    if key not in units:
        from ._calls import meant

        raise _core.Error(
            f"quantity '{key}' must be an attribute of "
            f"{type(of).__name__}{meant(key, units)}"
        )
    # p v is a power on an area in tables, and a pressure times a speed here.
    unit = "Pa m/s" if key.startswith("pv") else units[key]
    values, unit = _shown(_length(getattr(of, key), len(of.shape)), unit)
    return values.ravel(), _label(key.replace("_", " "), unit)


def _title(axis: Any, text: str, width: int = 58) -> None:
    axis.set_title(textwrap.fill(text, width), loc="left")


def _ends(axis: Any, curves: Iterable[tuple[Floats, Floats, str, str]]) -> None:
    """Names of curves at their ends, in their colours, none on another."""
    placed: list[float] = []
    low, high = axis.get_ylim()
    for x, y, name, colour in curves:
        known = np.flatnonzero(np.isfinite(y))
        if not known.size:
            continue
        end = (y[known[-1]] - low) / (high - low)
        while any(abs(end - other) < 0.09 for other in placed):
            end -= 0.09 if end > 0.5 else -0.09
        placed.append(end)
        axis.annotate(
            f" {name}", (1, end), xycoords="axes fraction", color=colour,
            va="center", annotation_clip=False,
        )  # fmt: skip


def plot_solution(
    self: Any,
    x: str | ArrayLike | None = None,
    quantities: Sequence[str] = ("friction_moment", "half_angle", "peak_pressure"),
    axes: Any = None,
) -> list[Any]:
    """A panel for each quantity over the rows; returns the axes.

    x: an attribute, whose lengths are taken of a vector, or numbers of the rows'
        shape. None: the reaction if it grows from row to row, or the row.
    quantities: attributes; of vectors the length.
    axes: of matplotlib, as many; None makes a figure.
    """
    if not self.shape or not self:
        raise _core.Error("plot() requires several rows")
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    if x is None:
        reaction = _length(self.reaction, len(self.shape)).ravel()
        x = "reaction" if np.all(np.diff(reaction) > 0) else "row"
    if isinstance(x, str):
        across, label = (
            (np.arange(np.prod(self.shape), dtype=float), "row")
            if x == "row"
            else _column(self, x)
        )
    else:
        label = ""
        across = np.broadcast_to(np.asarray(x, float), self.shape).ravel()
    paper = _Paper(len(names), axes, (6, 1 + 1.5 * len(names)))
    for axis, name, colour in zip(paper.axes, names, colours):
        values, its_label = _column(self, name)
        axis.plot(across, values, color=colour)
        axis.set_ylabel(its_label)
        if np.nanmin(values) >= 0:
            axis.set_ylim(0, None)
    paper.axes[-1].set_xlabel(label)
    return paper.axes


def plot_joint(
    joint: "Joint", load: ArrayLike, axes: Any = None, points: int = 100
) -> list[Any]:
    """Friction torque, half-angle and pressures of the joint that turns, for
    loads up to one; returns the axes.

    load: N; a vector on the body is in the seat, a number in a seat without
        end. A pin turns about z, a ball about an axis across the load.
    axes: of matplotlib, three, or two without friction; None makes a figure.
    """
    given = np.asarray(load, float)
    towards = given if given.ndim else np.array([given, 0, 0])
    size = np.linalg.norm(towards)
    if given.shape not in ((), (3,)) or not 0 < size < np.inf:
        raise _core.Error("load must be above 0 N, a number or a vector")
    of = joint if given.ndim else joint.without_seat()
    across = np.array([0.0, 0.0, 1.0])
    if joint.kind == "ball":
        across = np.cross(towards, np.eye(3)[np.argmin(np.abs(towards))])
    # Not 0, where nothing is pressed.
    loads = size * np.linspace(1 / points, 1, points)
    s = of.solve(loads[:, None] * (towards / size), across)
    x, unit = _shown(loads, "N")
    has_friction = joint.friction_law is not None
    paper = _Paper(2 + has_friction, axes, (6, 6 if has_friction else 4.2))
    *friction, angle, pressure = paper.axes
    for axis in friction:
        textbook = np.asarray(s.textbook_moment)
        if np.all(textbook > 0):  # NaN of other friction than dry
            y, name = _length(s.friction_moment, 1) / textbook, "torque / (f₀ R ρ)"
            axis.axhline(1, color=colours[6], ls="--", lw=1.2)
            axis.annotate("textbook ", (x[-1], 1), ha="right", va="bottom",
                          color=colours[6])  # fmt: skip
        else:
            y, name = np.asarray(s.moment_coefficient), "torque / (R ρ)"
        axis.plot(x, y, color=colours[0])
        axis.set_ylabel(name)
    angle.plot(x, np.degrees(s.half_angle), color=colours[2])
    angle.set(ylabel="half-angle θ₀, deg", ylim=(0, None))
    peak, mean = s.peak_pressure / 1e6, s.normal_force / s.contact_area / 1e6
    pressure.plot(x, peak, color=colours[1])
    pressure.plot(x, mean, color=colours[5])
    pressure.set(ylabel="pressure, MPa", ylim=(0, None), xlabel=_label("load", unit))
    _ends(pressure, ((x, peak, "peak", colours[1]), (x, mean, "mean", colours[5])))
    _title(paper.axes[0], joint.name)
    return paper.axes


def plot_cycle(cycle: "Cycle", axes: Any = None) -> list[Any]:
    """Force, friction moment, half-angle, peak pressure and p v over the time of
    a cycle; returns the axes.

    axes: of matplotlib, five; None makes a figure.
    """
    s = cycle.solution
    keys = ("reaction", "friction_moment", "half_angle", "peak_pressure")
    columns = [_column(s, key) for key in keys] + [_column(cycle.rating, "pv_max")]
    paper = _Paper(len(columns), axes, (6, 7.5))
    for axis, (values, label), colour in zip(paper.axes, columns, colours):
        axis.plot(cycle.time, values, color=colour)
        axis.set(ylabel=label.replace(", ", ",\n"), ylim=(0, None))
    paper.axes[-1].set_xlabel("time, s")
    joint = cycle._state[0]
    _title(
        paper.axes[0], f"{joint.name}: friction takes {cycle.energy:.3g} J a cycle"
    )
    return paper.axes


def _frame(eye: Floats) -> tuple[Floats, Floats]:
    """Directions to the right and up for a view along -eye: Z is up, or Y."""
    up = np.eye(3)[2 if abs(eye[2]) < 0.9 else 1]
    right = np.cross(up, eye)
    right /= np.linalg.norm(right)
    return right, np.cross(eye, right)


def _colour_map() -> Any:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("libcontact", _palette)


def plot_pressure(
    joint: "Joint", contact: Any, axes: Any = None, points: int = 240
) -> list[Any]:
    """The pressure over the contact; returns the axes.

    contact: a single Solution of the joint, whose pressures are mapped, for a
        ball in its seat, seen from outside, for a pin over angle and length. Or
        a normal force, N: the pressure over the angle from its direction.
    axes: of matplotlib, one; None makes a figure.
    """
    if not isinstance(contact, _core.Solution):
        return _profile(joint, contact, axes)
    if contact.shape:
        raise _core.Error("plot_pressure() requires a single row: solution[0]")
    paper = _Paper(1, axes, (4.6, 4))
    axis = paper.axes[0]
    if joint.kind == "ball":
        side = 1.0 if joint.get("inner_body", "body") == "carrier" else -1.0
        eye = side * np.asarray(contact.normal)
        right, top = _frame(eye)
        wide = 1.05 * np.sqrt(2)  # the half of the sphere towards the eye
        x, y = np.meshgrid(*2 * [np.linspace(-wide, wide, points)])
        # Lambert's projection: equal in area.
        r = np.hypot(x, y)
        t = 2 * np.arcsin(np.minimum(r / 2, 1))
        out = np.sin(t) / np.where(r > 0, r, 1)
        places = (
            np.cos(t)[..., None] * eye
            + (out * x)[..., None] * right
            + (out * y)[..., None] * top
        )
        p = np.where(r <= np.sqrt(2), joint.pressures(contact, places), np.nan)
        turn = np.linspace(0, 2 * np.pi, 200)
        for degrees in (30, 60, 90):
            away = 2 * np.sin(np.radians(degrees) / 2)
            axis.plot(away * np.cos(turn), away * np.sin(turn), color="#555555",
                      lw=1.2 if degrees == 90 else 0.5)  # fmt: skip
            axis.annotate(f"{degrees}°", (0, -away), ha="center", va="bottom",
                          fontsize=7, color="#555555")  # fmt: skip
        axis.set(aspect="equal", xticks=[], yticks=[])
        axis.grid(False)
        for spine in axis.spines.values():
            spine.set_visible(False)
        _title(axis, f"{joint.name}, seen against the load", 40)
    else:
        phi = np.linspace(-180, 180, points)
        z = np.linspace(-0.5, 0.5, points // 2) * joint.length
        x, y = np.meshgrid(phi, z)
        rho = joint.radius
        places = np.stack(
            [rho * np.cos(np.radians(x)), rho * np.sin(np.radians(x)), y], -1
        )
        places /= np.linalg.norm(places, axis=-1, keepdims=True)
        p, y = joint.pressures(contact, places), 1e3 * y
        axis.set(xlabel="angle from X towards Y, deg", ylabel="along the axis, mm",
                 xticks=range(-180, 181, 90),
                 ylim=(1e3 * z[0], 1e3 * z[-1]))  # fmt: skip
        _title(axis, joint.name, 40)
    # Towards a rim the model's pressure is infinite: beside it all is the
    # largest away from rims, as peak_pressure is.
    p = np.where(np.isfinite(p), p, np.nan) / 1e6
    drawn = axis.pcolormesh(
        x, y, np.where(p > 0, p, np.nan), cmap=_colour_map(), vmin=0,
        vmax=contact.peak_pressure / 1e6, shading="nearest", zorder=0.5,
    )  # fmt: skip
    axis.figure.colorbar(drawn, ax=axis, label="pressure, MPa", shrink=0.85)
    return paper.axes


def _profile(joint: "Joint", load: ArrayLike, axes: Any) -> list[Any]:
    given = np.asarray(load, float)
    if given.ndim or not 0 < given < np.inf:
        raise _core.Error(
            "contact must be a Solution, as solve() returns, or a normal force above 0 N"
        )
    force = float(given)
    theta0 = joint.half_angle(force)
    theta = np.linspace(-theta0, theta0, 201)
    p = joint.pressure(np.abs(theta), force) / 1e6
    paper = _Paper(1, axes, (6, 3.4))
    axis = paper.axes[0]
    axis.fill_between(np.degrees(theta), p, color=colours[0], alpha=0.15, lw=0)
    axis.plot(np.degrees(theta), p, color=colours[0])
    mean = joint.mean_pressure(force) / 1e6
    axis.axhline(mean, color=colours[6], ls="--", lw=1.2)
    axis.annotate("mean", (0, mean), ha="center", va="bottom", color=colours[6])
    axis.set(xlabel="angle from the load, deg", ylabel="pressure, MPa",
             ylim=(0, None))  # fmt: skip
    value, unit = _shown(np.array(force), "N")
    _title(axis, f"{joint.name} under {value:.4g} {unit}")
    return paper.axes


def plot_wear(
    wear: "Wear", k: float | None = None, axes: Any = None, cycles: float = 1e6
) -> list[Any]:
    """Draws the wear of a body, seen against the deepest point; returns the axes.

    k: m^2/N, for the depth; without it the integral of p |v| is drawn.
    axes: of matplotlib, one; None makes a figure.
    cycles: how many, for the depth.
    """
    paper = _Paper(1, axes, (4.6, 4))
    axis = paper.axes[0]
    what = f"depth in {cycles:.3g} cycles" if k else "∫ p |v| dt"
    values, unit = (
        _shown(wear.pv_integral * k * cycles, "m")
        if k
        else _shown(wear.pv_integral, "Pa m")
    )
    eye = np.asarray(wear.deepest_point)
    _title(axis, f"wear of the {wear.body}")
    if np.ptp(wear.points[:, 2]) == 0:  # a pin's, on a circle
        angle = np.degrees(np.arctan2(wear.points[:, 1], wear.points[:, 0]))
        order = np.argsort(angle)
        axis.plot(angle[order], values[order], color=colours[0])
        axis.set(xlabel="angle from X towards Y, deg", ylabel=_label(what, unit),
                 xticks=range(-180, 181, 90), ylim=(0, None))  # fmt: skip
        return paper.axes
    right, top = _frame(eye)
    seen = (values > 0) & (wear.points @ eye > 0)
    places, values = wear.points[seen], values[seen]
    out = np.sqrt(2 / (1 + places @ eye))  # Lambert's projection
    drawn = axis.scatter(out * (places @ right), out * (places @ top), c=values,
                         s=9, cmap=_colour_map(), vmin=0)  # fmt: skip
    turn = np.linspace(0, 2 * np.pi, 200)
    axis.plot(np.sqrt(2) * np.cos(turn), np.sqrt(2) * np.sin(turn),
              color="#555555", lw=1.2)  # fmt: skip
    axis.plot(0, 0, "+", color="#333333", ms=9)
    axis.set(aspect="equal", xticks=[], yticks=[])
    for spine in axis.spines.values():
        spine.set_visible(False)
    axis.figure.colorbar(drawn, ax=axis, label=_label(what, unit), shrink=0.85)
    return paper.axes
