"""Joints from keywords, and functions of laws without a joint."""

import copy
import functools
import tomllib
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._calls import unexpected_keyword, with_known_keywords
from ._files import FileText, toml_text
from ._joints import Joints
from ._plots import plot_cycle, plot_joint, plot_pressure, plot_wear
from ._results import html_table

Key = float | str | Mapping[str, object] | Sequence[object] | None

# Key that a mere text in these tables stands for.
_main_key = {
    "half_angle": "law",
    "pressure": "law",
    "friction": "law",
    "loading": "kind",
}
# Tables of the joint file whose keys are keywords, and the table of each.
_table_of = {
    key: table
    for table in ("geometry", "materials", "friction", "half_angle", "loading")
    for key in _core._joint_keys[table]
    if key != _main_key.get(table)
}


def _check_keywords(
    function: str, keywords: Iterable[str], own: Iterable[str] = ()
) -> None:
    """own: keywords of the function in addition to the keywords of joints."""
    known = [*own, *_table_of, *_core._joint_keys]
    for keyword in keywords:
        if keyword not in known:
            raise unexpected_keyword(function, keyword, known)


def _nested(keywords: Mapping[str, Key]) -> dict[str, Any]:
    """Keywords as the tables of a joint file."""
    tables: dict[str, Any] = {}
    for keyword, value in keywords.items():
        if value is None:
            continue
        if keyword in _main_key and isinstance(value, str):
            value = {_main_key[keyword]: value}
        if keyword in _table_of:
            tables.setdefault(_table_of[keyword], {})[keyword] = value
        elif isinstance(value, Mapping):
            tables.setdefault(keyword, {}).update(value)
        else:
            tables[keyword] = value
    return tables


_any_material = {"youngs_modulus": 1e9, "poissons_ratio": 0.3}
_any_materials = {"inner": _any_material, "outer": _any_material}


def _joint_text(keywords: Mapping[str, Key]) -> str:
    """Keywords as a joint file."""
    tables = _nested(keywords)
    size = {"radius": 1.0, "relative_clearance": 1e-3}
    if keywords.get("kind") == "pin":
        size["length"] = 1.0
    missing = {"geometry": size, "materials": _any_materials}
    if not missing.keys() <= tables.keys():
        # Wrong values come before missing ones.
        Joint._of(toml_text(missing | tables), "", "", ())
    if "materials" not in tables:
        raise _core.Error(
            "a joint requires inner and outer, the two materials, or pair"
        )
    return toml_text(tables)


def _several(keys: Mapping[str, Key], error: Exception) -> Exception:
    """The error; for several numbers in place of one it names the function that
    takes them."""
    text = str(error)
    wants_one = text.endswith(" must be a number")
    for key, value in keys.items():
        if wants_one and f"{key} = " in text and np.ndim(value):  # type: ignore
            return _core.Error(f"{text}; Joint.vary() makes a joint of each")
    return error


class Joint(FileText, _core.Joint):
    """A ball joint or a pin joint: geometry, materials, friction, laws.

        hip = libcontact.Joint(
            kind="ball", radius_mm=14, radial_clearance_um=100,
            inner={"youngs_modulus_GPa": 230, "poissons_ratio": 0.3},
            outer={"youngs_modulus_GPa": 1, "poissons_ratio": 0.4},
            wall={"backing": "rigid", "layer": [{"thickness_mm": 8}]},
            coefficient=0.0587)

    Keywords are the keys of joint files with their units
    (libcontact/docs/reference/joint_file.md): keys of [geometry], [materials]
    and [friction] without their tables; `half_angle`, `pressure`, `friction` (names of laws),
    `loading`, `wall` and `coating` as in the file. All keys are supported.
    Whole tables may be given as dicts.

    A joint is immutable: replace() makes another, vary() many. Joints compare by their
    contents, may be pickled and shared by threads, and survive fork.

    The [seat] or designation of a ball confines its contact wherever the
    direction of the load is known, and the [relief] of a pin is applied;
    without_seat() and without_relief() ignore them.
    """

    _more = (False, False, None)  # without_seat, without_relief, table

    if not TYPE_CHECKING:  # the stub of _core has all keys

        def __init__(
            self, *file: object, kind: str | None = None, **keys: Key
        ) -> None:
            if file:
                raise TypeError(
                    f"Joint() takes keywords; Joint.from_file({file[0]!r}) "
                    "reads a file"
                )
            if kind is None:
                raise TypeError("Joint() requires kind, \"ball\" or \"pin\"")
            _check_keywords("Joint", keys)
            text = _joint_text({"name": "joint", "kind": kind} | keys)
            try:
                self._read(text, "", "", ())
            except _core.Error as error:
                raise _several(keys, error) from None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Joint):
            return NotImplemented
        return self._canonical == other._canonical

    def __hash__(self) -> int:
        return hash(self._canonical)

    def _kept(self) -> tuple[Any, ...]:
        return *self._more[:2], None

    @staticmethod
    def _key_of(keyword: str) -> str:
        _check_keywords("Joint.replace", [keyword])
        if keyword in _table_of:
            return f"{_table_of[keyword]}.{keyword}"
        return keyword

    def without_seat(self) -> "Joint":
        """The joint in an unbounded seat, for comparison, and where results in
        a seat are not available. replace() keeps it unbounded; to_toml() still
        has the seat.
        """
        return self._with(True, self._more[1], None)

    def without_relief(self) -> "Joint":
        """The joint with a straight pin in a straight hole. replace() keeps it
        straight; to_toml() still has the relief.
        """
        return self._with(self._more[0], True, None)

    @with_known_keywords
    def tabulated(
        self,
        loads: tuple[float, float] | None = None,
        table: bytes | None = None,
    ) -> "Joint":
        """The joint with a table of the contacts at the rims of its seat.
        Reading the table takes some 20 us and is accurate to 1e-3 of the load.
        The table is pickled; replace() drops it.

        loads: the least and the largest, N; building the table takes 7 to 20
            s.
        table: `table` of another Joint with the same seat, instead.
        """
        if (loads is None) == (table is None):
            raise _core.Error("tabulated() requires loads or table")
        if loads is not None:
            least, most = loads
            table = self._make_table(least, most)
        return self._with(*self._more[:2], table)

    @property
    def _friction(self) -> dict[str, Any]:
        """In SI units, wherever the file has it."""
        return tomllib.loads(self._canonical).get("friction", {})

    @property
    def friction_law(self) -> str | None:
        """"dry", "viscous" or the name of a friction stress; None without
        friction."""
        friction = self._friction
        dry_or_viscous = "dry" if "coefficient" in friction else "viscous"
        return friction.get("law", dry_or_viscous) if friction else None

    @property
    def coefficient(self) -> float | None:
        """f0 of dry friction; None of other."""
        return self._friction.get("coefficient") if self._is_dry else None

    @property
    def adhesion(self) -> float | None:
        """A of dry friction, Pa; None of other."""
        return self._friction.get("adhesion_Pa", 0.0) if self._is_dry else None

    @property
    def _is_dry(self) -> bool:
        return self.friction_law == "dry"

    def vary(self, keys: Mapping[str, ArrayLike]) -> Joints:
        """Joints that differ by the numbers of some keys.

        keys: names as in replace(), with arrays that broadcast. Laws shared by
            several joints are built once: they do not depend on friction and,
            without walls, on radius and clearance.
        """
        return Joints(self, keys)

    plot = plot_joint
    plot_pressure = plot_pressure

    @with_known_keywords
    def cycle(
        self,
        time: ArrayLike,
        force: ArrayLike,
        *,
        angles: ArrayLike | None = None,
        sequence: str | None = None,
        rates: ArrayLike | None = None,
        period: float | None = None,
        force_on: str = "body",
        force_in: str = "carrier",
        tilt: ArrayLike | None = None,
        place: ArrayLike | None = None,
    ) -> "Cycle":
        """The joint on a duty cycle: one period of force and motion,
        interpolated by periodic cubic splines.

        time: s, (n,), ascending.
        force: N, (n, 3); on "body" or "carrier" and in the axes of either.
            Columns of a DataFrame whose names end in _kN are kN.
        angles: rad, (n, 3), intrinsic rotations of the body about the axes of
            `sequence`, "zxy" or another; of a pin (n,), about z. Columns of a
            DataFrame whose names end in _deg are degrees.
        rates: instead of angles: Dw in axes of the carrier, rad/s, (n, 3).
        period: s; optional for evenly spaced times.
        tilt: slope of a pin's axis in its hole, carrier axes, (3,) or (n, 3).
        place: of the reaction along a pin, m from its middle, () or (n,),
            instead of a tilt, which is then computed.

        A last row that repeats the first is left out, with a RuntimeWarning.
        A [seat] confines the contact of a ball; if it reaches a rim, sums are
        taken over the rows. A pin with a [relief], a tilt or a place is a
        finite-length pin, solved by slices.
        """
        if (angles is None) == (rates is None):
            raise _core.Error("a cycle requires angles or rates")
        motion = _core._numbers(rates if angles is None else angles)  # type: ignore
        if angles is not None:
            motion = _in_si(motion, angles, _ANGLES)
        if angles is not None and self.kind == "pin":
            motion = np.stack([motion, 0 * motion, 0 * motion], axis=-1)
            sequence = "z"
        if angles is not None and sequence is None:
            raise _core.Error("angles requires sequence, such as \"zxy\"")
        if angles is None and sequence is not None:
            raise _core.Error(f"sequence = \"{sequence}\" requires angles")
        force = _in_si(_core._numbers(force), force, _FORCES)
        return Cycle(
            self, time, force, motion, sequence, period, force_on, force_in,
            tilt, place,
        )  # fmt: skip


# Units at the end of a column's name, over SI.
_ANGLES = {"_deg": np.pi / 180}
_FORCES = {"_kN": 1e3, "_MN": 1e6, "_mN": 1e-3, "_lbf": 4.4482216152605}


def _in_si(
    numbers: NDArray[np.float64], given: object, units: dict[str, float]
) -> NDArray[np.float64]:
    """Columns of a DataFrame, or a Series, by the units in their names."""
    names = getattr(given, "columns", [getattr(given, "name", None)])
    factors = [
        next((f for end, f in units.items() if str(name).endswith(end)), 1.0)
        for name in names
    ]
    if all(factor == 1 for factor in factors):
        return numbers
    if units is _ANGLES and 0 < np.nanmax(np.abs(numbers)) < np.pi / 2:
        warnings.warn(
            "the angles of columns named ..._deg reach "
            f"{np.nanmax(np.abs(numbers)):.3g} deg: radians read as degrees?",
            _core.ContactWarning,
            stacklevel=4,
        )
    converted: NDArray[np.float64] = numbers * np.array(factors)
    return converted


class Wear:
    """Wear of one body of a joint on a cycle, by Archard's law: the depth is
    k times the integral of p |v| over the time, k in m^2/N.

    Attributes: `points`, unit vectors from the joint's centre in the body's
    axes, (n, 3), each of the area `cell_area`, m^2; `pv_integral` there, Pa m,
    and `cross_shear`, (n,); the same of the deepest point, `deepest_point`,
    `deepest_pv_integral`, `deepest_cross_shear`; `volume_defect`, the sum over
    the points against the exact integral, minus 1.
    """

    body: str
    points: NDArray[np.float64]
    pv_integral: NDArray[np.float64]
    cross_shear: NDArray[np.float64]
    cell_area: float
    volume_defect: float
    plot = plot_wear
    deepest_point: NDArray[np.float64]
    deepest_pv_integral: float
    deepest_cross_shear: float

    def __init__(self, attributes: dict[str, Any]) -> None:
        self.__dict__.update(attributes)

    @property
    def _place(self) -> str:
        return "(" + ", ".join(f"{x:.4g}" for x in self.deepest_point) + ")"

    def __repr__(self) -> str:
        return (
            f"libcontact.Wear of the {self.body} at {len(self.points)} points: "
            f"{self.deepest_pv_integral:.6g} Pa m at the deepest, {self._place}"
        )

    def _repr_html_(self) -> str:
        lines = [
            ["deepest_pv_integral", "Pa m", f"{self.deepest_pv_integral:.6g}"],
            ["deepest_point", "", self._place],
            ["deepest_cross_shear", "", f"{self.deepest_cross_shear:.6g}"],
            ["cell_area", "m^2", f"{self.cell_area:.6g}"],
            ["volume_defect", "", f"{self.volume_defect:.2g}"],
        ]
        title = f"libcontact.Wear of the {self.body} at {len(self.points)} points"
        return html_table(title, [], lines)


class _Made:
    """Mixed into a class of _core: pickled by its arguments."""

    def __init__(self, *state: Any) -> None:
        super().__init__(*state)
        self._state = copy.deepcopy(state)

    def __reduce__(self) -> str | tuple[Any, ...]:
        if not hasattr(self, "_state"):  # __init__() did not run
            return super().__reduce__()
        return type(self), self._state


class Cycle(_Made, _core.Cycle):
    """A joint on a duty cycle, see Joint.cycle(). It may be pickled."""

    plot = plot_cycle

    @property
    def mean_heat(self) -> float:
        """Mean power of friction, W."""
        return self.energy / self.period

    @with_known_keywords
    def wear(self, body: str = "body", points: int = 2000) -> Wear:
        """Wear map of one of the bodies. Nearer to a rim of the [seat] than
        report_distance the pressure at that distance is used, because wear at
        a rim is unknown.

        body: "body" or "carrier".
        points: number of points of equal area.
        """
        if not isinstance(body, str):
            raise TypeError(
                f'body = {body!r} must be "carrier" or "body"; wear_in() and plot() '
                "of the result take a wear coefficient, m^2/N: 1e-9 of one in "
                "mm^3/(N m)"
            )
        return Wear(self._wear(body, points))


class Fit(_Made, _core.Fit):
    """Friction parameters that fit measured moments, see identify(). It may be
    pickled, and is fitted again when unpickled."""

    def __getitem__(self, parameter: str) -> _core.Estimate:
        return self.parameters[parameter]

    def __contains__(self, parameter: str) -> bool:
        return parameter in self.parameters

    def __iter__(self) -> Iterator[str]:
        return iter(self.parameters)


@with_known_keywords
def identify(
    joint: Joint,
    reaction: ArrayLike,
    angular_velocity: ArrayLike,
    moment: ArrayLike,
    *,
    sigma: ArrayLike = 1.0,
    parameters: str | Sequence[str] = ("coefficient", "adhesion"),
    huber: bool = False,
    profile: bool = False,
    level: float = 0.95,
) -> Fit:
    """Friction parameters of a joint from moments measured while it slides.

    reaction: R on the body, N, (..., 3).
    angular_velocity: Dw, body against carrier, rad/s, (..., 3).
    moment: that turns the joint, -M_t . Dw/|Dw|, N m, (...); or M_t on the
        body, (..., 3).
    sigma: standard errors of the moments; 1: unknown. Only their ratios
        matter.
    parameters: of "coefficient", "adhesion" (Pa), "clearance" (m), "drag" (N
        m, independent of the load), "offset" (N m, does not change sign with
        Dw).
    huber: Huber's loss, which limits the effect of outliers.
    profile: add intervals by refitting.
    level: probability of the intervals.
    """
    names = [parameters] if isinstance(parameters, str) else list(parameters)
    return Fit(
        joint, reaction, angular_velocity, moment, sigma, names, huber, profile,
        level,
    )  # fmt: skip


@functools.lru_cache(maxsize=64)
def _cached(text: str) -> Joint:
    return Joint._of(text, "", "", ())


def _unit_joint(keys: Mapping[str, Key]) -> Joint:
    """A joint that has the laws of these keywords; of size 1 unless they say
    otherwise, which only walls heed."""
    size = {"radius": 1.0, "relative_clearance": 1e-3, "length": 1.0}
    if keys["kind"] == "ball":
        del size["length"]
    if any(key.startswith(("radius", "diameter")) for key in keys):
        del size["radius"]
    return _cached(_joint_text({"name": "joint"} | size | dict(keys)))


def _law_joint(law: str, keys: Mapping[str, Key]) -> Joint:
    """The same, where one law counts."""
    if not {"inner", "outer", "pair"}.isdisjoint(keys):
        return _unit_joint(keys)
    joint = _unit_joint(_any_materials | keys)
    if law in _core._material_laws:
        raise _core.Error(
            f'law "{law}" requires inner and outer, the two materials, or pair'
        )
    return joint


def half_angle(
    load_parameter: ArrayLike,
    law: "_core._HalfAngle" = "fitted",
    *,
    kind: str = "ball",
    **keys: Key,
) -> NDArray[np.float64]:
    """theta0 of the contact by a law, rad; NaN where it has none.

    load_parameter: mu of a ball, lambda of a pin, (...).
    law: "hertz", "arctan", "tanh", "blend", "paper", "fitted" or "exact".
    keys: `inner` and `outer`, the materials, and others of Joint.
    """
    _check_keywords("half_angle", keys, ["law"])
    joint = _law_joint(
        law,
        {"kind": kind, "half_angle": law, "pressure": _pressure_for(keys)}
        | keys,
    )
    return joint._half_angle(load_parameter)


def load_parameter(
    half_angle: ArrayLike,
    law: "_core._HalfAngle" = "fitted",
    *,
    kind: str = "ball",
    **keys: Key,
) -> NDArray[np.float64]:
    """The inverse of half_angle().

    half_angle: theta0, rad, (...).
    """
    _check_keywords("load_parameter", keys, ["law"])
    joint = _law_joint(
        law,
        {"kind": kind, "half_angle": law, "pressure": _pressure_for(keys)}
        | keys,
    )
    return joint._load_parameter(half_angle)


def _pressure_for(keys: Mapping[str, Key]) -> str:
    """A pressure law that is cheap to make for a half-angle alone."""
    return "exact" if {"wall", "coating"} & keys.keys() else "cosine"


def pressure(
    theta: ArrayLike,
    half_angle: ArrayLike,
    pressure: "_core._Pressure" = "exact",
    *,
    kind: str = "ball",
    **keys: Key,
) -> NDArray[np.float64]:
    """Contact pressure by a law, in R_n/rho^2 (ball) or P/rho (pin).

    theta: angle from the contact's centre, rad, (...).
    half_angle: theta0, rad, (...).
    pressure: "cosine", "sqrt_tan", "sqrt_theta", "worn", "mixture" or
        "exact"; the last two depend on the materials `inner` and `outer`.
    keys: others of Joint.
    """
    _check_keywords("pressure", keys, ["pressure"])
    joint = _law_joint(pressure, {"kind": kind, "pressure": pressure} | keys)
    return joint._pressure(theta, half_angle)


def friction_coefficients(
    theta0: ArrayLike,
    alpha: ArrayLike,
    pressure: "_core._Pressure" = "cosine",
    **keys: Key,
) -> _core.Coefficients:
    """Coefficients of a ball's friction: chi, sigma_Y and sigma_Z as
    attributes `force`, `sliding` and `spinning`.

    theta0: half-angle of the contact, rad, (...).
    alpha: slip axis angle, rad, (...): 0 sliding, pi/2 spinning.
    pressure, keys: as in pressure().
    """
    _check_keywords("friction_coefficients", keys, ["pressure"])
    joint = _law_joint(pressure, {"kind": "ball", "pressure": pressure} | keys)
    return joint._friction_coefficients(theta0, alpha)
