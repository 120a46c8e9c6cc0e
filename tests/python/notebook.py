"""notebook.py FILE.ipynb [--write]: runs the cells of a notebook in a Python of
their own and compares the texts they print with those that the file has; with
--write puts texts and pictures into it. As nbconvert --execute does, which is not
in every installation."""

import ast
import base64
import contextlib
import io
import json
import os
import sys
from pathlib import Path

import matplotlib.pyplot as plt


def lines(text):
    return text.splitlines(keepends=True)


def outputs_of(source, names):
    """Output of a cell in a notebook."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    value = None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        if last and not source.rstrip().endswith(";"):
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        elif last:
            exec(compile(ast.Module([last], []), "cell", "exec"), names)
    shown = []
    if printed.getvalue():
        shown.append({"output_type": "stream", "name": "stdout",
                      "text": lines(printed.getvalue())})  # fmt: skip
    if value is not None:
        data = {"text/plain": lines(repr(value))}
        if hasattr(value, "_repr_html_"):
            data["text/html"] = lines(value._repr_html_())
        shown.append({"output_type": "execute_result", "metadata": {},
                      "execution_count": None, "data": data})  # fmt: skip
    for number in plt.get_fignums():
        picture = io.BytesIO()
        plt.figure(number).savefig(picture, format="png", dpi=72)
        shown.append({"output_type": "display_data", "metadata": {}, "data": {
            "image/png": base64.b64encode(picture.getvalue()).decode()}})  # fmt: skip
    plt.close("all")
    return shown


def texts(outputs):
    """Output that must be the same on every machine: all except pictures."""
    return [o.get("text") or o["data"].get("text/plain", "picture") for o in outputs]


def main(file, write=""):
    notebook = json.loads(Path(file).read_text(encoding="utf-8"))
    os.chdir(Path(file).parent)
    names = {"__name__": "__main__"}
    failed = False
    cells = [c for c in notebook["cells"] if c["cell_type"] == "code"]
    for number, cell in enumerate(cells, 1):
        new = outputs_of("".join(cell["source"]), names)
        if not write and texts(new) != texts(cell["outputs"]):
            failed = True
            print(f"cell {number}: {texts(cell['outputs'])}\nnow    {texts(new)}")
        cell["outputs"] = new
        cell["execution_count"] = number
        for output in new:
            if "execution_count" in output:
                output["execution_count"] = number
    if write:
        Path(Path(file).name).write_text(
            json.dumps(notebook, indent=1, ensure_ascii=False) + "\n",
            encoding="utf-8")
    sys.exit(failed)


main(*sys.argv[1:])
