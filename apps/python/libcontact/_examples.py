"""Files that come with the package, and the materials in them."""

import difflib
import functools
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from . import _core

_data = Path(__file__).parent / "data"
Value = TypeVar("Value")


def _known(all_of: Mapping[str, Value], name: str) -> Value:
    """The one of this name, or a KeyError that says which are like it."""
    try:
        return all_of[name]
    except KeyError:
        lower = str(name).lower()
        near = [known for known in all_of if lower in known.lower()]
        near = near or difflib.get_close_matches(str(name), all_of, 3)
        said = f"there is {', '.join(map(repr, near or all_of))}"
        raise KeyError(f"{name}: {said}") from None


class Examples(Mapping[str, Path]):
    """Files by name."""

    def __init__(self, files: Mapping[str, Path]) -> None:
        self._all = files

    def __getitem__(self, name: str) -> Path:
        return _known(self._all, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __repr__(self) -> str:
        return f"<libcontact.examples: {', '.join(self)}>"


examples = Examples(
    {
        f"{folder}/{file.name}": file
        for folder in ("backings", "cases", "duty", "joints", "materials", "studies")
        for file in sorted((_data / folder).glob("*.*"))
    }
)
"""Joints, pairs of materials, cases, studies and cycles, by the names of their
files in the source's data/: Joint.from_file(examples["joints/pin_joint.toml"])."""


class Materials(Mapping[str, "_core.Material"]):
    """Materials by name, as Joint's inner and outer take them. Where the
    numbers are from, the files in examples say."""

    @functools.cached_property
    def _all(self) -> dict[str, Any]:
        texts = (file.read_text() for file in (_data / "materials").glob("*.toml"))
        pairs = [tomllib.loads(text) for text in texts]
        bodies = [pair[body] for pair in pairs for body in ("inner", "outer")]
        named = {body["name"]: MappingProxyType(body) for body in bodies}
        return dict(sorted(named.items()))

    def __getitem__(self, name: str) -> "_core.Material":
        material: "_core.Material" = _known(self._all, name)
        return material

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __repr__(self) -> str:
        return f"<libcontact.materials: {', '.join(self)}>"


materials = Materials()
