"""Files shipped with the package, and the materials in them."""

import difflib
import functools
import tomllib
from abc import abstractmethod
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

from . import _core

_data = Path(__file__).parent / "data"
_core._set_shipped_data(_data)
Value = TypeVar("Value")


def near(word: str, known: Collection[str]) -> list[str]:
    """Names that a word may mean: those that it is a part of, as clearance_um
    is, the shortest first, or else up to three like it, the best first."""
    part = word.lower()
    whole = sorted((name for name in known if part in name.lower()), key=len)
    return whole or difflib.get_close_matches(word, known, 3)


class _Named(Mapping[str, Value]):
    """Values by name; a KeyError says which names are like one that there is
    not."""

    @property
    @abstractmethod
    def _all(self) -> Mapping[str, Value]: ...

    def __getitem__(self, name: str) -> Value:
        try:
            return self._all[name]
        except KeyError:
            names = near(str(name), self) or self
            said = f"there is {', '.join(map(repr, names))}"
            raise KeyError(f"{name}: {said}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)


class Examples(_Named[Path]):
    """Files by name."""

    def __init__(self, files: Mapping[str, Path]) -> None:
        self._files = files

    @property
    def _all(self) -> Mapping[str, Path]:
        return self._files

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


class Materials(_Named["_core.Material"]):
    """Materials by name, as Joint's inner and outer take them. Where the
    numbers are from, the files in examples say."""

    @functools.cached_property
    def _all(self) -> Mapping[str, "_core.Material"]:
        texts = (file.read_text() for file in (_data / "materials").glob("*.toml"))
        pairs = [tomllib.loads(text) for text in texts]
        bodies = [pair[body] for pair in pairs for body in ("inner", "outer")]
        named: dict[str, Any] = {b["name"]: MappingProxyType(b) for b in bodies}
        return dict(sorted(named.items()))

    def __repr__(self) -> str:
        return f"<libcontact.materials: {', '.join(self)}>"


materials = Materials()
