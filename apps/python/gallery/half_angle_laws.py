"""Half-angle laws of a steel ball in a bronze seat against the exact one."""

import libcontact
import matplotlib.pyplot as plt
import numpy as np
from libcontact._plots import law_colours
from picture import finish

steel: libcontact.Material = {"youngs_modulus_GPa": 206, "poissons_ratio": 0.3}
bronze: libcontact.Material = {"youngs_modulus_GPa": 110, "poissons_ratio": 0.34}

mu = np.geomspace(1e-3, 30, 200)
exact = libcontact.half_angle(mu, "exact", inner=steel, outer=bronze)

figure, (above, below) = plt.subplots(
    2, 1, sharex=True, figsize=(6, 5), height_ratios=[2, 1])
above.semilogx(mu, np.degrees(exact), color=law_colours["exact"], lw=2, label="exact")
laws: list[libcontact.HalfAngleLaw] = ["fitted", "tanh", "arctan", "hertz"]
for law in laws:
    theta0 = libcontact.half_angle(mu, law, inner=steel, outer=bronze)
    above.semilogx(mu, np.degrees(theta0), "--", color=law_colours[law], label=law)
    below.semilogx(mu, 100 * (theta0 / exact - 1), "--", color=law_colours[law])
above.set(ylabel="half-angle θ₀, deg", ylim=(0, 100),
          title="Half-angle of a steel ball in a bronze seat")
above.legend()
below.set(xlabel="load parameter μ", ylabel="error, %", ylim=(-10, 20))
finish()
