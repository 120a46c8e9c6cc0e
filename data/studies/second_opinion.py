"""The Sobol' indices of hip.toml, by hinge-study and by OpenTURNS.

OpenTURNS draws runs of its own, has them from libcontact.Joint.solve() and reads
the indices off a polynomial chaos: other numbers, another estimator. What
hinge-study says has to be that within its standard errors.
"""

import json
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import libcontact
import numpy as np
import openturns as ot

RUNS = 600
# All products of four polynomials up to the degree 5: from 300 runs more or up
# to the degree 4 the indices are others by 1e-4 at most.
TERMS = 126
# Standard errors have 7 degrees of freedom (Student): one index of 200 is off by
# more than so many.
APART = 4
# Shares of the variance; with larger errors agreement would say nothing.
LARGEST_ERROR = 0.03
study = Path(__file__).resolve().parent / "hip.toml"
toml = tomllib.loads(study.read_text())
keys = [d["key"] for d in toml["dispersion"]]

make: dict[str, Callable[[dict[str, float]], Any]] = {
    "normal": lambda d: ot.TruncatedNormal(
        d["mean"], d["deviation"], d["low"], d["high"]),
    "triangular": lambda d: ot.Triangular(d["low"], d["mode"], d["high"]),
    "uniform": lambda d: ot.Uniform(d["low"], d["high"]),
}
inputs = ot.ComposedDistribution([make[d["kind"]](d) for d in toml["dispersion"]])
hip = libcontact.Joint.from_file(study.parent / toml["joint"])


def run(numbers: list[float]) -> list[float]:
    """Friction moment and peak pressure."""
    drawn = hip.replace(dict(zip(keys, numbers, strict=True)))
    s = drawn.solve([0, 0, toml["load"]["reaction_N"]], [1, 0, 0])
    return [float(np.linalg.norm(s.friction_moment)), float(s.peak_pressure)]


with tempfile.TemporaryDirectory() as folder:
    said = subprocess.run(
        ["hinge-study", study, "--output", "-", "--journal", f"{folder}/journal"],
        check=True, capture_output=True, text=True)

ot.RandomGenerator.SetSeed(1)
sample = inputs.getSample(RUNS)
outputs = ot.Sample([run(list(numbers)) for numbers in sample])

basis = ot.OrthogonalProductPolynomialFactory(
    [ot.StandardDistributionPolynomialFactory(inputs.getMarginal(i))
     for i in range(len(keys))])
worst = 0.0
largest = 0.0
print("| quantity | input | index | hinge-study | OpenTURNS | in errors |")
print("|---|---|---|---:|---:|---:|")
for i, driven in enumerate(json.loads(said.stdout)["drivers"]):
    chaos = ot.FunctionalChaosAlgorithm(
        sample, outputs.getMarginal(i), inputs, ot.FixedStrategy(basis, TERMS))
    chaos.run()
    indices = ot.FunctionalChaosSobolIndices(chaos.getResult())
    for source in driven["sobol"]:
        place = keys.index(source["source"])
        for name, other in (
            ("first", indices.getSobolIndex(place)),
            ("total", indices.getSobolTotalIndex(place)),
        ):
            value, error = source[name], source[f"{name}_error"]
            errors = abs(value - other) / error
            worst = max(worst, errors)
            largest = max(largest, error)
            print(f"| {driven['quantity']} | {source['source']} | {name} "
                  f"| {value:.2g} +- {error:.2g} | {other:.2g} | {errors:.1f} |")
if worst > APART:
    sys.exit(f"They are further apart than {APART} standard errors.")
if largest > LARGEST_ERROR:
    sys.exit(f"A standard error is above {LARGEST_ERROR}.")
