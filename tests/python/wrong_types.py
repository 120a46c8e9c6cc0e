"""Mistakes that mypy finds: in every line that ends in "# wrong", no other."""

import libcontact
import numpy as np

metal: libcontact.Material = {"youngs_modulus_GPa": 200, "poissons_ratio": 0.3}
ball = libcontact.Joint(
    kind="ball", radius_mm=14, radial_clearance_um=10, coefficient=0.1,
    inner=metal, outer=libcontact.materials["UHMWPE"], half_angle="exact",
    wall={"backing": "rigid", "layer": [{"thickness_mm": 8}]})  # fmt: skip
libcontact.Joint(kind="ball", radius_mmm=14)  # wrong
libcontact.Joint(kind="ball", half_angle="hertzz")  # wrong
libcontact.Joint(kind="ball", inner={"youngs_modulus_GP": 200})  # wrong
libcontact.half_angle(1.0, "hertzz")  # wrong
libcontact.half_angle(1.0, radius_mmm=14)  # wrong
of_law: float = libcontact.half_angle(1.0, "exact", inner=metal, outer=metal)
theta0: float = ball.half_angle(500.0)
several: float = ball.half_angle([500.0, 600.0])  # wrong
s = ball.solve([0, 0, 1], [1, 0, 1], last=None)
ball.solve([0, 0, 1], omega=[1, 0, 1])  # wrong
print(s[s.half_angle > 0.1].reshape(-1).powr)  # wrong
moments = ball.solve(np.ones((9, 3)), [1, 0, 1], fields=("power",))["power"]
ball.solve(np.ones((9, 3)), [1, 0, 1], fields=("powr",))  # wrong
joints = ball.vary({"friction.coefficient": np.linspace(0, 0.1, 9)})
of_each: float = joints.half_angle(500.0)  # wrong
print(ball.step([0, 0, 1], [1, 0, 1], [1, 0, 0], np.eye(3)).solution.power)
ball.step([0, 0, 1], [1, 0, 1], [1, 0, 0], inertia=np.eye(3), lasst=None)  # wrong
