"""Many joints that differ by some numbers."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._results import columns_of, html_table

if TYPE_CHECKING:
    from ._joint import Joint


class Joints(_core.Joints):
    """Joints that differ by some numbers, an array of them: Joint.vary().

        fits = hip.vary({"geometry.radial_clearance_um": [50, 100, 150]})
        fits.peak_pressure(2000)  # (3,)
        fits.solve(np.ones((7, 1, 3)), [1, 0, 1]).power  # (7, 3)

    Functions are the same as in Joint; their arguments broadcast against the
    joints. A ContactWarning refers to the first joint outside its limits. Each
    joint with a [seat] is in its own seat, without a table.
    """

    def __init__(self, joint: "Joint", keys: Mapping[str, ArrayLike]) -> None:
        if not keys:
            raise _core.Error("vary() requires keys")
        names = [joint._here(key) for key in keys]
        arrays = np.broadcast_arrays(*map(_numbers, keys, keys.values()))
        settings = tuple(s for s in joint._settings if s[0] not in names)
        super().__init__(
            joint._text, joint._source, joint._folder, settings, names,
            np.stack(arrays, axis=-1), *joint._more[:2],
        )  # fmt: skip
        self._joint = joint
        self._keys = dict(zip(keys, arrays))
        for array in arrays:
            array.flags.writeable = False

    @property
    def joint(self) -> "Joint":
        """The joint from which they differ."""
        return self._joint

    @property
    def varied(self) -> dict[str, NDArray[np.float64]]:
        """The numbers of the keys, in the joints' shape."""
        return dict(self._keys)

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("len() of a single joint")
        return int(self.shape[0])

    def __getitem__(self, index: Any) -> Any:
        """A Joint, or some of them."""
        chosen = {key: values[index] for key, values in self._keys.items()}
        if any(np.ndim(value) for value in chosen.values()):
            return Joints(self._joint, chosen)
        return self._joint.replace(chosen)

    def __iter__(self) -> Iterator[Any]:
        return (self[i] for i in range(len(self)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Joints):
            return NotImplemented
        return (
            self._joint == other._joint
            and self._keys.keys() == other._keys.keys()
            and all(
                np.array_equal(values, other._keys[key])
                for key, values in self._keys.items()
            )
        )

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> str | tuple[Any, ...]:
        if not hasattr(self, "_joint"):  # __init__() did not run
            return super().__reduce__()
        return Joints, (self._joint, self._keys)

    def _repr_html_(self) -> str:
        heads, places, rest = columns_of(self.shape)
        lines = [
            [key, *(f"{values[place]:.6g}" for place in places), *rest]
            for key, values in self._keys.items()
        ]
        title = f"libcontact.Joints {self._joint.name!r} of shape {self.shape}"
        return html_table(title, ["", *heads, *rest], lines)

    def __repr__(self) -> str:
        ranges = ", ".join(f"{key} {_range(v)}" for key, v in self._keys.items())
        return (
            f"<libcontact.Joints {self._joint.name!r} of shape {self.shape}, {ranges}>"
        )


def _range(values: NDArray[np.float64]) -> str:
    ends = (np.min(values), np.max(values)) if values.size else ()
    return " to ".join(dict.fromkeys(f"{x:g}" for x in ends)) or "none"


def _numbers(key: str, given: ArrayLike) -> NDArray[np.float64]:
    try:
        return np.array(_core._numbers(given))
    except TypeError as error:
        raise TypeError(f"{key}: {error}") from None
