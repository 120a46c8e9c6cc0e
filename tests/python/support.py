"""Helpers shared by the tests of the Python package."""

import csv
import io
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

source = Path(__file__).resolve().parents[2]
build = Path(os.environ["CONTACT_BUILD"])
hip_file = source / "data/joints/hip_cocr_uhmwpe.toml"
pin_file = source / "data/joints/pin_joint.toml"


def program(name, *arguments):
    """Standard output and standard error of a program."""
    done = subprocess.run(
        [build / "bin" / name, *map(str, arguments)],
        capture_output=True, text=True, cwd=source,
    )  # fmt: skip
    return done.stdout, done.stderr


def table(name, *arguments):
    """Rows of the CSV table that a program prints."""
    return list(csv.DictReader(io.StringIO(program(name, *arguments)[0])))


def columns(file):
    with open(file) as lines:
        rows = list(csv.reader(line for line in lines if line[0] != "#"))
    return dict(zip(rows[0], np.array(
        [[cell or "nan" for cell in row] for row in rows[1:]], dtype=float).T))


def random_rows(n, seed=1):
    """Reactions and angular velocities."""
    random = np.random.default_rng(seed)
    return random.normal(size=(n, 3)) * 1e3, random.normal(size=(n, 3))


def cxx_rows(joint_file, reaction, rate, times=1):
    """Answers of C++, (n, 12), and its processor seconds."""
    done = subprocess.run(
        [build / "tests/joint_rows", joint_file, str(times)],
        input=np.concatenate([reaction, rate], axis=1).tobytes(),
        capture_output=True, check=True,
    )  # fmt: skip
    return np.frombuffer(done.stdout).reshape(-1, 12), float(done.stderr)


def python(code, **options):
    """A Python of its own."""
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, **options
    )
