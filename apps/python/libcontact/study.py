"""Studies on any executor of concurrent.futures: threads, Dask, MPI.

A study is divided into parts of its runs. On each worker the program
hinge-study computes a part and returns the bytes of a journal. From all
journals hinge-study writes the results, which are bit-identical to the study
on one machine. If a part is lost with its worker, the executor or a repeated
call computes it again.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> import libcontact.study
    >>> with ThreadPoolExecutor() as executor:
    ...     print(libcontact.study.run("study.toml", executor, ["--csv", "rows.csv"]))

Workers need hinge-study, beside their Python or on their PATH, and the study's
files by the same name.
"""

import os
import shutil
import subprocess
import sysconfig
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, as_completed
from pathlib import Path

from ._calls import with_known_keywords
from ._core import Error

__all__ = ["compute_part", "run"]


def _hinge_study(*arguments: str) -> str:
    places = os.pathsep.join([sysconfig.get_path("scripts"), os.environ["PATH"]])
    program = shutil.which("hinge-study", path=places)
    if program is None:
        raise Error(
            "hinge-study must be beside this Python, where pip install puts it, "
            "or on the PATH"
        )
    done = subprocess.run(
        [program, *arguments], text=True, capture_output=True, check=False
    )
    # 1: runs or a picture failed, and the rest is there.
    if done.returncode not in (0, 1):
        raise Error(done.stderr.strip() or f"hinge-study: {done.returncode}")
    return done.stdout


def compute_part(study: str, choice: Sequence[str], rows: str) -> bytes:
    """The journal of some rows, "A:B"."""
    with tempfile.TemporaryDirectory() as folder:
        journal = Path(folder) / "part"
        # On one thread: executors have a worker for each.
        part = ["--rows", rows, "--jobs", "1", "--journal", str(journal)]
        _hinge_study(study, *choice, *part)
        return journal.read_bytes()


@with_known_keywords
def run(
    study: str | os.PathLike[str],
    executor: Executor,
    options: Sequence[str] = (),
    *,
    runs: int | None = None,
    seed: int | None = None,
    part: int = 100,
    folder: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> str:
    """Runs a study by an executor; returns the table for people.

    study    study file
    options  of hinge-study, for the results: ["--csv", "rows.csv"]
    runs, seed  instead of the file's
    part     rows of a part
    folder   where parts are kept that are done; STUDY.parts
    progress  called after each part with how many are done and all
    """
    name = os.fspath(study)
    choice = [
        word
        for option, value in (("--runs", runs), ("--seed", seed))
        if value is not None
        for word in (option, str(value))
    ]
    kept = Path(folder or Path(name).stem + ".parts")
    kept.mkdir(parents=True, exist_ok=True)
    ranges = _hinge_study(name, *choice, "--parts", str(part)).split()
    files = {rows: kept / rows.replace(":", "-") for rows in ranges}
    futures = {
        executor.submit(compute_part, name, choice, rows): file
        for rows, file in files.items()
        if not file.exists()
    }
    left = len(futures)
    for future in as_completed(futures):
        # Whole or not at all, whenever this program is killed.
        unfinished = futures[future].with_suffix(".unfinished")
        unfinished.write_bytes(future.result())
        unfinished.rename(futures[future])
        left -= 1
        if progress:
            progress(len(files) - left, len(files))
    parts = [str(file) for file in files.values()]
    return _hinge_study(
        name,
        *choice,
        *options,
        "--journal",
        str(kept / "journal"),
        "--merge",
        *parts,
    )
