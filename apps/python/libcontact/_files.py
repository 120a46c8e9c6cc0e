"""Base of joints and cases: both are a TOML text with settings."""

import copy
import difflib
import functools
import json
import numbers
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import Any, Self

from . import _core

type_of_settings = tuple[tuple[str, str], ...]


def value_text(value: object) -> str:
    """A value as TOML."""
    if getattr(value, "ndim", None) == 0:
        value = value.item()  # type: ignore
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
            if isinstance(tables, Mapping) and _file_of(tables):
                return tables, rest
            raise _absent(key, tables, rest)
        tables = tables[name]
        if which:
            tables = among(tables, which.removesuffix("]"), key)
        rest = behind
        if rest and not isinstance(tables, Mapping):
            raise KeyError(key)
    return tables, ""


def _absent(key: str, tables: Any, rest: str) -> KeyError:
    """An error that names the nearest keys in place of one that is absent."""
    known = list(dotted(tables))
    near = difflib.get_close_matches(rest, known, 1)
    said = f"there is {near[0]}" if near else f"there are {', '.join(known)}"
    before = key.removesuffix(rest).removesuffix(".")
    return KeyError(f"{key}: {f'in {before} ' if before else ''}{said}")


def among(tables: Any, which: str, key: str) -> Any:
    """The one of several tables that has this number or name."""
    for number, table in enumerate(tables, 1):
        if which == str(number) or table.get("name") == which:
            return table
    names = [table["name"] for table in tables if "name" in table]
    near = difflib.get_close_matches(which, names, 1) or names
    said = f": {', '.join(near)}" if near and not which.isdigit() else ""
    raise KeyError(f"{key}: there are {len(tables)}{said}")


def dotted(tables: Mapping[str, Any], before: str = "") -> Iterator[str]:
    """All keys of tables in tables, as "wall.layer[1].thickness_mm"."""
    for name, value in tables.items():
        if isinstance(value, Mapping):
            yield from dotted(value, f"{before}{name}.")
        elif isinstance(value, list) and value and isinstance(value[0], Mapping):
            for number, table in enumerate(value, 1):
                yield from dotted(table, f"{before}{name}[{number}].")
        else:
            yield before + name


def _file_of(table: Mapping[str, Any]) -> str | None:
    """The key by which a table names a file that has its keys."""
    return next(
        (k for k in ("file", "pair") if isinstance(table.get(k), str)), None
    )


def with_files(tables: Any, folder: Path, settings: type_of_settings) -> Any:
    """Tables including the tables of the files that they name.

    tables: of a file that has its own settings already.
    settings: the ones for files that it names count.
    """
    walked = [(walk(tables, key), value) for key, value in settings]

    def whole(found: Any) -> Any:
        if isinstance(found, list):
            return [whole(value) for value in found]
        if not isinstance(found, dict):
            return found
        inside = {name: whole(value) for name, value in found.items()}
        kind = _file_of(found)
        if kind is None:
            return inside
        its_own = tuple((r, v) for (table, r), v in walked if table is found and r)
        path = _core._named_file(folder, kind, found[kind])
        text = _core._file_toml(kind, path, its_own)
        return with_files(tomllib.loads(text), path.parent, its_own) | inside

    return whole(tables)


def without_names(tables: Any) -> Any:
    """Tables of with_files() that name no files. The friction of a pair of
    materials applies to the joint, unless it has its own."""
    if isinstance(tables, list):
        return [without_names(value) for value in tables]
    if not isinstance(tables, dict):
        return tables
    inside = {name: without_names(value) for name, value in tables.items()}
    if _file_of(inside) == "file":
        del inside["file"]
    materials = inside.get("materials", {})
    if _file_of(materials) == "pair":
        names = ("inner", "outer", "liner")
        bodies = {name: materials[name] for name in names if name in materials}
        own = {"friction": materials["friction"]} if "friction" in materials else {}
        return own | inside | {"materials": bodies}
    return inside


def _frozen(value: Any) -> Any:
    """Equal for equal tables, whatever the order of their keys."""
    if isinstance(value, dict):
        return frozenset((name, _frozen(inside)) for name, inside in value.items())
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


class FileText:
    """Base beside a class of _core, which is made of these members."""

    _text: str
    _source: str
    _folder: str
    _settings: type_of_settings
    _more: tuple[Any, ...] = ()  # arguments of one class alone

    # Members of the class of _core.
    _toml: str
    _canonical: str

    def _read(
        self, text: str, source: str, folder: str, settings: type_of_settings,
        *more: Any,
    ) -> None:  # fmt: skip
        more = more or self._more
        super().__init__(text, source, folder, settings, *more)  # type: ignore
        self._text = text
        self._source = source
        self._folder = folder
        self._settings = settings
        self._more = more

    def _with(self, *more: Any) -> Self:
        """The same file with other values of _more."""
        state = self._text, self._source, self._folder, self._settings
        return self._of(*state, *more)

    def _kept(self) -> tuple[Any, ...]:
        """Values of _more that stay when keys are replaced."""
        return self._more

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

    @staticmethod
    def _key_of(keyword: str) -> str:
        """The key of a file that a keyword stands for."""
        return keyword

    def replace(
        self, keys: Mapping[str, object] | None = None, /, **keywords: object
    ) -> Self:
        """A copy with other values of some keys.

        keys: names as in the file, with its tables: "geometry.radius_mm",
            "wall.layer[1].thickness_mm", "body[booster].mass_t". A key takes
            the place of the same one in another unit. Keys of files that the
            file names are keys of the table that names them.
        keywords: keywords of Joint(): replace(radius_mm=16).
        """
        settings = dict(self._settings)
        named = {self._key_of(k): value for k, value in keywords.items()}
        for key, value in (dict(keys or {}) | named).items():
            key = self._here(key)
            settings.pop(key, None)
            settings[key] = value_text(value)
        return self._of(
            self._text, self._source, self._folder, tuple(settings.items()),
            *self._kept(),
        )  # fmt: skip

    def _here(self, key: str) -> str:
        """A key of a pair's friction, which is the joint's where to_dict() has
        put it."""
        before, materials, behind = key.partition("materials.friction.")
        if materials and before + "materials.friction" not in self:
            return f"{before}friction.{behind}"
        return key

    @functools.cached_property
    def _tables(self) -> dict[str, Any]:
        """Includes the tables of the files that it names."""
        tables = tomllib.loads(self._toml)
        return with_files(tables, Path(self._folder), self._settings)  # type: ignore

    def __getitem__(self, key: str) -> Any:
        """The value of a key, in its unit; a table as a dict.

        key: as in replace(). KeyError if the file leaves it out, or has it in
            another unit.
        """
        if not isinstance(key, str):
            raise KeyError(key)
        found, rest = walk(self._tables, self._here(key))
        if rest:
            raise _absent(key, found, rest)
        return copy.deepcopy(found)

    def get(self, key: str, default: Any = None) -> Any:
        """The value of a key; `default` if the file leaves it out."""
        try:
            return self[key]
        except KeyError:
            return default

    def __contains__(self, key: str) -> bool:
        """Whether the file has a key or a table."""
        return self.get(key) is not None

    def keys(self) -> list[str]:
        """All keys, as in replace(), including keys of files that it names."""
        return list(dotted(self._tables))

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def to_dict(self) -> dict[str, Any]:
        """The file as nested dicts, with the tables of files that it names in
        the place of their names."""
        return without_names(self._tables)  # type: ignore

    def to_toml(self) -> str:
        """The file as TOML that needs no other file, with its replaced keys."""
        return toml_text(self.to_dict())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(_frozen(self.to_dict()))

    def __reduce__(self) -> tuple[Any, ...]:
        tables = tomllib.loads(self._toml)
        if self._tables == tables:  # it names no files
            state = self._text, self._source, self._folder, self._settings
        else:
            state = self.to_toml(), "", "", ()
        return type(self)._of, (*state, *self._more)

    # Nothing of it changes.
    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: object) -> Self:
        return self

    def __repr__(self) -> str:
        return f"<libcontact.{type(self).__name__} {self.name!r}>"  # type: ignore
