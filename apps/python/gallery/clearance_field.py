"""Pin bearing of 50 mm over the clearances that the fit H7/g6 allows."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from picture import finish

pin = libcontact.Joint(
    kind="pin", diameter_mm=50, hole="H7", shaft="g6", length_mm=40,
    inner={"youngs_modulus_GPa": 206, "poissons_ratio": 0.3},
    outer={"youngs_modulus_GPa": 110, "poissons_ratio": 0.34},
    coefficient=0.12, adhesion_MPa=0.5,
)  # fmt: skip
load = np.geomspace(100, 50e3, 100)
reaction = load[:, None] * [0, 0, 1]

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.5))
pressure, moment = {}, {}
for which in "minimum", "mean", "maximum":
    s = pin.replace({"geometry.clearance": which}).solve(reaction, [1, 0, 0])
    pressure[which] = s.peak_pressure / 1e6
    moment[which] = -s.friction_moment[:, 0] / (load * pin.radius)
for axis, values, name in (
    (left, pressure, "peak pressure, MPa"),
    (right, moment, "moment over ρ R"),
):
    axis.fill_between(
        load, values["minimum"], values["maximum"], alpha=0.25,
        label="clearance 9 to 50 µm")  # fmt: skip
    axis.plot(load, values["mean"], label="mean, 29.5 µm")
    axis.set(xscale="log", xlabel="load, N", ylabel=name, ylim=(0, None))
left.legend()
figure.suptitle("Bearing of 50 mm, H7/g6: what its tolerances leave open")
finish()
