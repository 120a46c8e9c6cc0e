"""What joints and cases have in common: both are a TOML text with settings."""

import json
import numbers
import tomllib
from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any, Self

from . import _core

type_of_settings = tuple[tuple[str, str], ...]


def value_text(value: object) -> str:
    """A value as TOML."""
    if isinstance(value, Mapping):
        inside = (f"{key_text(k)} = {value_text(v)}" for k, v in value.items())
        return "{" + ", ".join(inside) + "}"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, Iterable):
        return "[" + ", ".join(value_text(v) for v in value) + "]"
    raise TypeError(f"{value!r} is no number, text, list or dict")


def key_text(key: str) -> str:
    is_bare = key.replace("_", "").isalnum() and key.isascii()
    return key if is_bare else json.dumps(key, ensure_ascii=False)


def toml_text(tables: Mapping[str, object]) -> str:
    """Tables as TOML, a line for each key of the top."""
    lines = (f"{key_text(k)} = {value_text(v)}\n" for k, v in tables.items())
    return "".join(lines)


def walk(tables: Any, key: str) -> tuple[Any, str]:
    """Follows a key such as body[2].hinge.joint[1].friction as far as the file
    has it: what is there, and the rest, which another file has that is named
    there."""
    rest = key
    while rest:
        step, _, behind = rest.partition(".")
        name, _, which = step.partition("[")
        if name not in tables:
            if isinstance(tables, Mapping) and not {"file", "pair"}.isdisjoint(
                tables
            ):
                return tables, rest
            raise KeyError(key)
        tables = tables[name]
        if which:
            tables = among(tables, which.removesuffix("]"), key)
        rest = behind
        if rest and not isinstance(tables, Mapping):
            raise KeyError(key)
    return tables, ""


def among(tables: Any, which: str, key: str) -> Any:
    """The one of several tables that has this number or name."""
    for number, table in enumerate(tables, 1):
        if which == str(number) or table.get("name") == which:
            return table
    raise KeyError(key)


def is_of_file(tables: Any, key: str) -> bool:
    return bool(walk(tables, key)[1])


def value_at(
    tables: Any, folder: Path, settings: type_of_settings, key: str
) -> Any:
    """The value of a key.

    tables: of a file that has its own settings already.
    settings: those of files that it names count.
    """
    found, rest = walk(tables, key)
    if not rest:
        return found
    kind = "file" if "file" in found else "pair"
    walked = [(walk(tables, k), value) for k, value in settings]
    its_own = tuple((r, v) for (table, r), v in walked if table is found and r)
    path = folder / found[kind]
    text = _core._file_toml(kind, path, its_own)
    return value_at(tomllib.loads(text), path.parent, its_own, rest)


class FileText:
    """Mixed into a class of _core that is made of these four."""

    _text: str
    _source: str
    _folder: str
    _settings: type_of_settings

    # Of the class of _core.
    _toml: str
    _canonical: str

    def _read(
        self, text: str, source: str, folder: str, settings: type_of_settings
    ) -> None:
        super().__init__(text, source, folder, settings)  # type: ignore
        self._text = text
        self._source = source
        self._folder = folder
        self._settings = settings

    @classmethod
    def _of(cls, *state: Any) -> Self:
        self = cls.__new__(cls)
        self._read(*state)
        return self

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Self:
        """Reads a file. Messages name its lines."""
        text = Path(path).read_text(encoding="utf-8")
        return cls._of(text, str(path), str(Path(path).absolute().parent), ())

    def replace(self, keys: Mapping[str, object]) -> Self:
        """The same with other values of some keys.

        keys: names as in the file, with its tables: "geometry.radius_mm",
            "wall.layer[1].thickness_mm", "body[booster].mass_t". A key takes
            the place of the same one in another unit. Keys of files that the
            file names are keys of the table that names them.
        """
        settings = dict(self._settings)
        for key, value in keys.items():
            settings.pop(key, None)
            settings[key] = value_text(value)
        return self._of(
            self._text, self._source, self._folder, tuple(settings.items())
        )

    def __getitem__(self, key: str) -> Any:
        """The value of a key, in its unit; a table as a dict.

        key: as in replace(). KeyError if the file leaves it out, or has it in
            another unit.
        """
        return value_at(
            self.to_dict(), Path(self._folder), self._settings, key
        )

    def to_dict(self) -> dict[str, Any]:
        """The file as nested dicts, but for files that it names."""
        return tomllib.loads(self._toml)

    def to_toml(self) -> str:
        """The file as TOML, with its replaced keys, but for files that it
        names."""
        return toml_text(self.to_dict())

    def _identity(self) -> tuple[object, ...]:
        tables = self.to_dict()
        of_files = [s for s in self._settings if is_of_file(tables, s[0])]
        return type(self), self._canonical, self._folder, sorted(of_files)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, FileText):
            return NotImplemented
        return self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._canonical)

    def __reduce__(self) -> tuple[Any, ...]:
        state = (self._text, self._source, self._folder, self._settings)
        return type(self)._of, state

    # Nothing of it changes.
    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: object) -> Self:
        return self

    def __repr__(self) -> str:
        return f"<libcontact.{type(self).__name__} {self.name!r}>"  # type: ignore
