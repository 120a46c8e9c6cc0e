#!/usr/bin/env python3
"""Check that comments are sentences about the thing they document.

Lists the comment blocks of C, C++ and Python that open with one of OPENINGS, as
FILE:LINE: first line. A block is a run of comment lines, a trailing comment or
a docstring. "Whether" may open the docstring of a bool. Exit status 1 if any
are found. With --count: their number by folder. With --habits, which blocks
nothing: the places in comments and pages where one of HABITS stands in for a
noun, and their numbers.

    scripts/english.py [--count | --habits] [FOLDER...]
"""
import ast
import collections
import io
import pathlib
import re
import sys
import tokenize

OPENINGS = "what whoever who whose whether of where that those".split()
FOLDERS = ["libcontact", "apps", "tests", "scripts", "plots"]
SUFFIXES = (".hpp", ".cpp", ".h", ".c", ".py")

# Words that stand in for a noun: after these no noun of their own comes before.
BEFORE = r"\b(?:of|to|for|by|in|on|at|than|from|with|is|are|and|as|has|says?|beside)\s+"
HABITS = {
    "that of": r"\b(?:that|those)\s+of\b",
    "of which": r"\bof\s+(?:which|whom)\b",
    "what": BEFORE + r"what\b",
    "who": BEFORE + r"who\b|\bwhoever\b",
    "nobody": r"\bnobody\b",
}

# First line of a block: why it may stay.
EXCEPTIONS = {}

# Literals come first: a // inside one is no comment.
TOKEN = re.compile(
    r'R"([^(\s]*)\(.*?\)\1"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"
    r"|(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)",
    re.S,
)
BOOL = re.compile(r"[^;={(]*\b(bool|AssertionResult)\b|.*\)[^;]*-> bool")


def c_comments(text):
    """Place (line and column) and words of each comment but /*parameter*/."""
    for match in TOKEN.finditer(text):
        if match.lastgroup and not re.fullmatch(r"/\*\w+\*/", match.group()):
            column = match.start() - text.rfind("\n", 0, match.start()) - 1
            words = re.sub(r"^(//[/!]?|/\*[*!]?)<?|\*/$", "", match.group())
            yield text.count("\n", 0, match.start()), column, words.strip()


def python_comments(text):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0] - 1, token.start[1], token.string.strip("#! ")


def docstrings(text):
    """Line, words and whether it is a function's, of each docstring."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)):
            if words := ast.get_docstring(node):
                function = isinstance(node, ast.FunctionDef)
                yield node.body[0].lineno - 1, words, function


def documented(lines, line, column):
    """The code before a trailing comment, or below a block."""
    if trailing := lines[line][:column].strip():
        return trailing
    while line < len(lines) and re.match(r"\s*(//|/?\*|#)", lines[line]):
        line += 1
    return " ".join(lines[line : line + 3])


def blocks(path):
    """Line, first line and whether it documents a bool, of each block."""
    text = path.read_text()
    lines = text.split("\n")
    python = path.suffix == ".py"
    comments = python_comments if python else c_comments
    continues = None  # place of a comment that goes on with the last one
    for line, column, words in comments(text):
        trailing = lines[line][:column].strip()
        if trailing or (line, column) != continues:
            first = words.split("\n")[0]
            yield line, first, BOOL.match(documented(lines, line, column))
        continues = line + 1, column
    if python:
        for line, words, function in docstrings(text):
            yield line, words.split("\n")[0], function


def texts(path):
    """Line and text of each comment block and docstring, or of a page's prose."""
    text = path.read_text()
    if path.suffix == ".md":
        code = re.compile(r"^```.*?^```", re.S | re.M)
        yield 0, code.sub(lambda block: "\n" * block[0].count("\n"), text)
        return
    python = path.suffix == ".py"
    block, start, last = "", 0, None
    for line, _, words in (python_comments if python else c_comments)(text):
        if block and line == last + 1:
            block += "\n" + words
        else:
            yield start, block
            block, start = words, line
        last = line + words.count("\n")
    yield start, block
    if python:
        for line, words, _ in docstrings(text):
            yield line, words


def habits(folders):
    """Prints where HABITS are, and how many."""
    found = collections.Counter()
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix not in (*SUFFIXES, ".md"):
                continue
            if "node_modules" in path.parts:
                continue
            for line, text in texts(path):
                for habit, pattern in HABITS.items():
                    for match in re.finditer(pattern, text, re.I):
                        found[habit] += 1
                        at = line + text.count("\n", 0, match.start()) + 1
                        words = " ".join(text[match.start() : match.end() + 40].split())
                        print(f"{path}:{at}: {habit}: {words}")
    print(", ".join(f"{habit}: {number}" for habit, number in found.most_common()))


def is_clumsy(words, about_bool):
    opening = re.match(r"\W*(\w*)", words).group(1).lower()
    if opening == "whether" and about_bool:
        return False
    return opening in OPENINGS and words not in EXCEPTIONS


def main(arguments):
    if "--habits" in arguments:
        habits([a for a in arguments if a != "--habits"] or FOLDERS)
        return 0
    count = "--count" in arguments
    by_folder = collections.Counter()
    total = 0
    for folder in [a for a in arguments if a != "--count"] or FOLDERS:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix not in SUFFIXES:
                continue
            for line, words, about_bool in blocks(path):
                total += 1
                if is_clumsy(words, about_bool):
                    by_folder[str(path.parent)] += 1
                    if not count:
                        print(f"{path}:{line + 1}: {words}")
    if count:
        for folder, number in sorted(by_folder.items()):
            print(f"{number:5} {folder}")
        print(f"{by_folder.total()} of {total} blocks")
    return 1 if by_folder else 0


sys.exit(main(sys.argv[1:]))
