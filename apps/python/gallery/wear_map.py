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
for axis, body, name in (
    (axes[0], "carrier", "seat (carrier)"), (axes[1], "body", "head (body)"),
):  # fmt: skip
    wear = cycle.wear(body, points=4000)
    # Seen along Y, from where the load comes.
    z, x = wear.points[:, 2], wear.points[:, 0]
    seen = wear.pv_integral > 0
    dots = axis.scatter(
        z[seen], x[seen], c=wear.pv_integral[seen] / 1e3, s=9, cmap="magma")
    axis.plot(wear.deepest_point[2], wear.deepest_point[0], "c+", ms=10)
    axis.add_patch(plt.Circle((0, 0), 1, fill=False, color="0.6"))
    axis.set(title=name, xlabel="z/ρ", ylabel="x/ρ", aspect="equal")
    figure.colorbar(dots, ax=axis, shrink=0.8, label="∫ p v dt, kPa m")
figure.suptitle("Wear of a hip in a gait cycle: times k it is the depth")
finish()
