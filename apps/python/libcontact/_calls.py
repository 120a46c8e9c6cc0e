"""Wrong calls of the compiled functions, said as Python says them."""

import functools
import inspect
from collections.abc import Callable, Collection
from typing import Any, ParamSpec, TypeVar

from . import _core
from ._examples import near

P = ParamSpec("P")
R = TypeVar("R")


def meant(word: str, known: Collection[str]) -> str:
    """The end of a sentence about a word that is not known."""
    names = near(word, known)
    return f". Did you mean '{names[0]}'?" if names else ""


def unexpected_keyword(
    function: str, keyword: str, known: Collection[str]
) -> TypeError:
    return TypeError(
        f"{function}() got an unexpected keyword argument '{keyword}'"
        + meant(keyword, known)
    )


def with_known_keywords(function: Callable[P, R]) -> Callable[P, R]:
    """A function of the package that suggests the nearest keyword for a misspelt
    one, like the functions of _core."""
    name = function.__qualname__.removesuffix(".__init__")
    known = [k for k in inspect.signature(function).parameters if k != "self"]

    @functools.wraps(function)
    def call(*arguments: P.args, **keywords: P.kwargs) -> R:
        for keyword in keywords:
            if keyword not in known:
                raise unexpected_keyword(name, keyword, known)
        return function(*arguments, **keywords)

    return call


def _refusal(
    name: str,
    function: Callable[..., Any],
    arguments: tuple[Any, ...],
    keywords: dict[str, Any],
) -> TypeError:
    """An error that says why pybind11 refused the arguments."""
    try:
        signature = inspect.signature(function)
    except ValueError:
        return _wrong_types(name, arguments, keywords)
    for keyword in keywords:
        if keyword not in signature.parameters:
            known = [k for k in signature.parameters if k != "self"]
            return unexpected_keyword(name, keyword, known)
    try:
        signature.bind(*arguments, **keywords)
    except TypeError as error:
        return TypeError(f"{name}() {error}")
    # The object itself is no argument for people.
    is_method = next(iter(signature.parameters), "") == "self"
    return _wrong_types(name, arguments[is_method:], keywords)


def _wrong_types(
    name: str, arguments: tuple[Any, ...], keywords: dict[str, Any]
) -> TypeError:
    types = [type(value).__name__ for value in arguments]
    types += [f"{k}: {type(value).__name__}" for k, value in keywords.items()]
    return TypeError(f"{name}() does not take ({', '.join(types)})")


def _checked(
    name: str, function: Callable[..., Any], owner: type | None = None
) -> Callable[..., Any]:
    """owner: the function's class; other classes may have it too."""

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            return function(*arguments, **keywords)
        except TypeError as error:
            text = str(error)
            if "(): incompatible " not in text.partition("\n")[0]:
                raise
        of = f"{type(arguments[0]).__name__}.{name}" if owner else name
        raise _refusal(of, function, arguments, keywords)

    return call


def _checked_init(
    owner: type, init: Callable[..., None]
) -> Callable[..., None]:
    @functools.wraps(init)
    def call(self: Any, *arguments: Any, **keywords: Any) -> None:
        try:
            init(self, *arguments, **keywords)
            return
        except TypeError as error:
            if "incompatible constructor" not in str(error).partition("\n")[0]:
                raise
        raise _wrong_types(owner.__name__, arguments, keywords)

    return call


def _check_calls() -> None:
    """Puts such sentences in the place of pybind11's."""
    for name, value in list(vars(_core).items()):
        if inspect.isbuiltin(value):
            setattr(_core, name, _checked(name, value))
        if not (isinstance(value, type) and value.__module__ == _core.__name__):
            continue
        for member, function in list(vars(value).items()):
            if member == "__init__":
                value.__init__ = _checked_init(value, function)  # type: ignore
            elif callable(function) and not member.startswith("__"):
                setattr(value, member, _checked(member, function, value))


_check_calls()
