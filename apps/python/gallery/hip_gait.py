"""A hip over a gait cycle from a CSV file."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from picture import data, finish

# time_s, force on the body, N, and three angles, deg, about Z, X and Y.
time, *columns = np.genfromtxt(
    data / "reference/duty/cycle_hip_in.csv", delimiter=",", skip_header=1).T
force = np.stack(columns[:3], axis=1)
angles = np.radians(np.stack(columns[3:], axis=1))

hip = libcontact.Joint.from_file(data / "joints/hip_cocr_uhmwpe.toml")
cycle = hip.cycle(time, force, angles=angles, sequence="zxy")
s, pv = cycle.solution, cycle.rating

figure, axes = plt.subplots(2, 2, sharex=True, figsize=(8, 4.6))
for axis, values, name in (
    (axes[0, 0], np.linalg.norm(s.reaction, axis=-1), "force, N"),
    (axes[0, 1], np.degrees(s.half_angle), "half-angle θ₀, deg"),
    (axes[1, 0], s.peak_pressure / 1e6, "peak pressure, MPa"),
    (axes[1, 1], pv.pv_max / 1e6, "largest p v, MW/m²"),
):
    axis.plot(cycle.time, values)
    axis.set(ylabel=name, ylim=(0, None))
moment = axes[0, 0].twinx()
moment.plot(cycle.time, np.linalg.norm(s.friction_moment, axis=-1), "C3")
moment.set(ylabel="friction moment, N m", ylim=(0, None))
moment.yaxis.label.set_color("C3")
moment.spines["right"].set_visible(True)
moment.grid(False)
for axis in axes[1]:
    axis.set_xlabel("time, s")
figure.suptitle(f"A hip walks: friction takes {cycle.energy:.2f} J a gait cycle")
finish()
