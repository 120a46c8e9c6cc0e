"""Pressure under a polyethylene liner of several thicknesses."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from picture import data, finish

load = 2000.0  # N
hip = libcontact.Joint.from_file(data / "joints/hip_cocr_uhmwpe.toml")
endless = libcontact.Joint.from_file(
    data / "joints/hip_cocr_uhmwpe_infinite.toml")
theta = np.linspace(-1.2, 1.2, 400)

figure, axis = plt.subplots(figsize=(6, 4))
for i, mm in enumerate([1, 2, 4, 8]):
    liner = hip.replace({"wall.layer[1].thickness_mm": mm})
    axis.plot(np.degrees(theta), liner.pressure(theta, load) / 1e6,
              color=plt.cm.viridis(0.1 + 0.25 * i), label=f"{mm} mm")
axis.plot(np.degrees(theta), endless.pressure(theta, load) / 1e6, "k--",
          label="without end")
axis.set(xlabel="angle from the contact's centre θ, deg", ylabel="p, MPa",
         ylim=(0, None), title=f"A hip under {load:.0f} N, by its liner")
axis.legend(title="polyethylene on a rigid shell")
finish()
