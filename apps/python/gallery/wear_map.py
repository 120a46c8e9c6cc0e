"""Wear map of a hip's seat and head over a gait cycle."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from picture import data, finish

time, *columns = np.genfromtxt(
    data / "reference/duty/cycle_hip_in.csv", delimiter=",", skip_header=1).T
hip = libcontact.Joint.from_file(data / "joints/hip_cocr_uhmwpe.toml")
cycle = hip.cycle(
    time, np.stack(columns[:3], axis=1),
    angles=np.radians(np.stack(columns[3:], axis=1)), sequence="zxy",
)  # fmt: skip

figure, axes = plt.subplots(1, 2, figsize=(8, 3.8))
# k of the seat and of the head, m^2/N.
for axis, body, k in ((axes[0], "carrier", 1e-15), (axes[1], "body", 1e-18)):
    cycle.wear(body, points=6000).plot(k, axes=axis)
figure.suptitle("Wear of a hip in a gait cycle, seen against its deepest place")
finish()
