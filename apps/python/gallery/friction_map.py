"""Friction coefficients of a ball over half-angle and slip axis angle."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from picture import finish

theta0_deg = np.linspace(1, 120, 120)
alpha_deg = np.linspace(0, 90, 91)
c = libcontact.friction_coefficients(
    np.radians(theta0_deg), np.radians(alpha_deg)[:, None])

figure, axes = plt.subplots(1, 3, sharey=True, figsize=(9, 3.2))
for axis, values, name in zip(
    axes,
    (c.force, c.sliding, c.spinning),
    ("friction force χ", "sliding moment σ_Y", "spinning moment σ_Z"),
):
    filled = axis.contourf(theta0_deg, alpha_deg, values, 12, cmap="viridis")
    lines = axis.contour(
        theta0_deg, alpha_deg, values, 6, colors="white", linewidths=0.6)
    axis.clabel(lines, lines.levels[1:], fontsize=7)
    axis.set(title=name, xlabel="half-angle θ₀, deg")
    axis.grid(False)
    figure.colorbar(filled, ax=axis)
axes[0].set_ylabel("slip axis angle α, deg\n0: sliding, 90: spinning")
finish()
