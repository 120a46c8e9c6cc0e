#!/usr/bin/python3
"""Makes hip_wear_steps.csv: a hip that wears step by step under its cycle.

The seat of cycle_hip.toml is a cloud of points, Fibonacci's, about the middle
of the loads. A pressure at one of them moves all others by a kernel, the sum of
Legendre's series whose terms are the classical ones of a ball and a cavity.
Loads and slip come from cycle_hip_states.csv, 100 instants of a cycle; at
each the seat wears by k p |v| dt with the pressure as it is there, explicitly.
Nothing is shared with the library.

    hip_wear.py [SPACING_DEG...] > hip_wear_steps.csv

The last rows are lines through the rows of all spacings to the power 3/2, at 0:
so the half-angle goes to the exact one before wear. Contacts are read at the
instant of the largest load, load_x_N to load_z_N.
"""
import csv
import pathlib
import sys

import numpy as np
from scipy.linalg import solve
from scipy.optimize import nnls

RHO, EPS = 0.014, 1e-4
BALL, SEAT, K = (230e9, 0.3), (1e9, 0.4), 1e-15  # E, nu; wear, m^2/N
CYCLES = (0, 2e5, 1e6, 5e6)
SPACINGS = (7, 6.5, 6, 5.5, 5, 4.6, 4.3, 4, 3.7, 3.4, 3.2, 3, 2.8)
REACH = np.radians(96)  # points end there, from the middle
FIRST, GROWTH = 0.05, 0.1  # blocks: shares of C_2, of the path
STATES = (pathlib.Path(__file__).parent.parent /
          "data/reference/duty/cycle_hip_states.csv")


def harmonics(n):
    """Displacement by p_n = 1, m/Pa; a shift, n = 1, is free."""
    def k(body):
        return 2 * RHO * (1 - body[1]**2) / body[0]

    v, w = BALL[1], SEAT[1]
    with np.errstate(divide="ignore"):
        ball = ((2 * (1 - v) * n**2 + v * n - 1 + 2 * v) /
                (2 * (1 - v) * (n - 1) * (n**2 + n + 1 + v * (2 * n + 1))))
    cavity = ((2 * (1 - w) * n**2 + (4 - 5 * w) * n + 1 - w) /
              (2 * (1 - w) * (n + 2) * (n**2 + n + 1 - w * (2 * n + 1))))
    return np.where(n == 1, 0, k(BALL) * ball + k(SEAT) * cavity)


def kernel():
    """Displacement at an angle from p dS = 1 on the unit sphere.

    (2n + 1) C_n tends to a + b/n: these two are summed in closed form.
    """
    n = np.arange(1.0, 1500)
    large = 1e6
    a, b = np.linalg.solve(
        [[1, 1 / large], [1, 0.5 / large]],
        [(2 * m + 1) * harmonics(m) for m in (large, 2 * large)])
    rest = (2 * n + 1) * harmonics(n) - a - b / n
    grid = np.linspace(0, 1, 4001)  # sines of half the angle
    x = 1 - 2 * grid**2
    series, one, two = np.zeros_like(x), x, np.ones_like(x)  # P_n, P_(n-1)
    for m, c in zip(n, rest):
        series += c * one
        one, two = ((2 * m + 1) * x * one - m * two) / (m + 1), one

    def at(cosines):
        s = np.sqrt(np.maximum(1 - cosines, 0) / 2)
        closed = harmonics(0.0) - a + a / (2 * s) - b * np.log(s * (1 + s))
        return (closed + np.interp(s, grid, series)) / (4 * np.pi)
    return at


class Seat:
    def __init__(self, spacing, middle):
        count = int(4 * np.pi / spacing**2)
        self.area = 4 * np.pi / count  # on the unit sphere
        i = np.arange(count)
        z = 1 - (2 * i + 1) / count
        r, turn = np.sqrt(1 - z * z), i * np.pi * (3 - np.sqrt(5))
        axes = np.linalg.svd(middle[None])[2]
        axes[0] = middle
        everywhere = np.column_stack(
            (z, r * np.cos(turn), r * np.sin(turn))) @ axes
        self.points = everywhere[z > np.cos(REACH)]
        size, at = len(self.points), kernel()
        c = np.empty((size, size))
        for i in range(size):
            cosines = everywhere @ self.points[i]
            cosines[i] = 0
            u = self.area * at(cosines)
            # An even pressure has to give what it does.
            u[i] = harmonics(0.0) - u[:i].sum() - u[i + 1:].sum()
            c[i] = u[:size]
        self.compliance = ((c + c.T) / 2).astype(np.float32)

    def press(self, load, gap, touching):
        """Pressure and gaps: none pulls, none overlaps."""
        r = self.points
        for _ in range(60):
            some = np.flatnonzero(touching)
            sides = np.column_stack((gap / EPS, r))[some]
            x = solve(self.compliance[np.ix_(some, some)],
                      sides.astype(np.float32), assume_a="pos",
                      overwrite_a=True, check_finite=False).astype(float)
            by_shift = RHO**2 * self.area * r[some].T @ x
            shift = np.linalg.solve(by_shift[:, 1:],
                                    load + EPS * by_shift[:, 0])
            p = np.zeros(len(r))
            p[some] = x[:, 1:] @ shift - EPS * x[:, 0]
            left = self.compliance @ p.astype(np.float32) + gap - r @ shift
            new = np.where(touching, p > -1e-5 * p.max(), left < -1e-5 * EPS)
            if (new == touching).all():
                return (np.maximum(p, 0),
                        np.where(touching, 0, np.maximum(left, 0)), touching)
            touching = new
        raise RuntimeError("no contact found")

    def half_angle(self, load, left, touching):
        """A cap's of this area: to where gaps a s^(3/2) + b s begin; by count."""
        cell = np.sqrt(self.area)
        n = load / np.linalg.norm(load)
        theta = np.arccos(np.clip(self.points @ n, -1, 1))
        x, y = np.linalg.svd(n[None])[2][1:] @ self.points.T
        counted = 2 * np.arcsin(np.sqrt(touching.sum() * self.area /
                                        (4 * np.pi)))
        sectors = int(2 * np.pi * np.sin(counted) / cell / 6)
        sector = np.floor(np.arctan2(y, x) / (2 * np.pi) * sectors)
        edges = []
        for one in np.unique(sector):
            mine = sector == one
            first = theta[mine & ~touching].min()
            near = mine & (np.abs(theta - first - cell / 2) < 2.5 * cell)

            def misfit(edge):
                s = np.maximum(theta[near] - edge, 0) / cell
                return nnls(np.column_stack((s**1.5, s)), left[near] / EPS)[1]

            edges.append(min(first + cell * np.linspace(-2, 2, 161),
                             key=misfit))
        return np.arccos(np.cos(edges).mean()), counted


def cycle():
    """Instants of a cycle: load to the seat, Dw dt, both in its axes."""
    with open(STATES) as file:
        rows = [{k: float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]
    loads = [[-row["R_n_N"] * row["n_" + a] for a in "xyz"] for row in rows]
    turns = [[row["w_" + a + "_rad_per_s"] / len(rows) for a in "xyz"]
             for row in rows]
    return np.array(loads), np.array(turns)


def wear(spacing):
    """A row at each of CYCLES."""
    loads, turns = cycle()
    path = RHO * np.linalg.norm(turns, axis=1)
    middle = path @ loads
    seat = Seat(np.radians(spacing), middle / np.linalg.norm(middle))
    r = seat.points
    slips = RHO * np.linalg.norm(np.cross(turns[:, None], r), axis=2)
    worn = np.zeros(len(r))
    touch = [r @ load > 0.8 * np.linalg.norm(load) for load in loads]
    largest = np.argmax(np.linalg.norm(loads, axis=1))
    first = FIRST * harmonics(2.0) / (K * path.sum())
    done, block = 0.0, 0
    for target in CYCLES:
        while done < target:
            now = min(max(first, GROWTH * done), target - done)
            # Every other instant, the rest in the next block; there and back.
            instants = np.arange(block % 2, len(loads), 2)
            for i in instants[::1 - block // 2 % 2 * 2]:
                p, _, touch[i] = seat.press(loads[i], worn + EPS, touch[i])
                worn += 2 * K * now * slips[i] * p
            done, block = done + now, block + 1
        load = loads[largest]
        p, left, touching = seat.press(load, worn + EPS, touch[largest])
        yield (spacing, done, *load,
               *np.degrees(seat.half_angle(load, left, touching)), p.max(),
               worn.max() * 1e3, worn.sum() * seat.area * RHO**2 * 1e9)


def main():
    def show(row):
        print(",".join(f"{x:.6g}" for x in row), flush=True)

    print("spacing_deg,cycles,load_x_N,load_y_N,load_z_N,theta0_deg,"
          "counted_deg,p_peak_Pa,depth_mm,volume_mm3")
    rows = []
    for spacing in [float(x) for x in sys.argv[1:]] or SPACINGS:
        for row in wear(spacing):
            rows.append(row)
            show(row)
    for cycles in CYCLES:
        some = np.array([row for row in rows if row[1] == cycles])
        show((0, *np.polyfit(some[:, 0]**1.5, some[:, 1:], 1)[1]))


main()
