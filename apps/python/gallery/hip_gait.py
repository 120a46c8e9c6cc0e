"""A hip over a gait cycle from a CSV file."""

import libcontact
import numpy as np
from picture import data, finish

# time_s, force on the body, N, and three angles, deg, about Z, X and Y.
time, *columns = np.genfromtxt(
    data / "reference/duty/cycle_hip_in.csv", delimiter=",", skip_header=1).T
force = np.stack(columns[:3], axis=1)
angles = np.radians(np.stack(columns[3:], axis=1))

hip = libcontact.Joint.from_file(data / "joints/hip_cocr_uhmwpe.toml")
hip.cycle(time, force, angles=angles, sequence="zxy").plot()
finish()
