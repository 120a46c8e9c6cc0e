"""Puts the docstrings of the package into its stub, where editors look:

    document_stub.py STUB >DOCUMENTED

Of a function with overloads the first has it."""

import ast
import inspect
import sys
from collections.abc import Iterator
from pathlib import Path

import libcontact
from libcontact import _core

Definition = ast.ClassDef | ast.FunctionDef


def definitions(body: list[ast.stmt], of: object) -> Iterator[tuple[Definition, str]]:
    """Definitions that have a docstring, each with it."""
    before = ""
    for node in body:
        if not isinstance(node, Definition):
            continue
        value = inspect.getattr_static(of, node.name, None)
        if value is None and of is _core:
            value = getattr(libcontact, node.name, None)
        doc = value and getattr(value, "__doc__", None)
        is_special = node.name.startswith("_")
        if doc and node.name != before and not is_special and value is not dict:
            yield node, inspect.cleandoc(doc)
        before = node.name
        if isinstance(node, ast.ClassDef) and value is not None and value is not dict:
            yield from definitions(node.body, value)


def documented(text: str) -> str:
    lines = text.splitlines()
    found = list(definitions(ast.parse(text).body, _core))
    for node, doc in sorted(found, key=lambda pair: -pair[0].lineno):
        first = node.body[0]
        indent = " " * (node.col_offset + 4)
        quoted = [line and indent + line for line in f'"""{doc}"""'.splitlines()]
        is_empty = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        line = lines[first.lineno - 1]
        if is_empty and line[first.col_offset :].startswith("..."):
            head, tail = line[: first.col_offset], line[first.col_offset + 3 :]
            lines[first.lineno - 1 : first.lineno] = [(head + tail.lstrip()).rstrip(), *quoted]
        elif isinstance(node, ast.ClassDef):
            lines[node.lineno : node.lineno] = quoted
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(documented(Path(sys.argv[1]).read_text()), end="")
