#!/usr/bin/python3
"""Makes moving_ball_wear.csv: a lined seat that wears under a load that swings.

Step by step: the ball's load stands at one place of its swing, the seat wears
by p v there (explicitly), and the load goes on to the next place, there and
back. The liner is thin and stands on something rigid, the ball is rigid: a bed
of springs, p = M (D.r - eps - h)/t with M = E (1 - nu)/((1 + nu)(1 - 2 nu)), on
Fibonacci's sphere. Nothing is shared with the library.

    moving_ball_wear.py [POINTS [PLACES [STEPS]]] > moving_ball_wear.csv
"""
import sys

import numpy as np

RHO, EPS, E, NU, T = 0.02, 4e-5, 2e9, 0.3, 4e-4
STIFF = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)) / T  # Pa/m


def sphere(count):
    i = np.arange(count)
    z = 1 - (2 * i + 1) / count
    turn = i * np.pi * (3 - np.sqrt(5))
    r = np.sqrt(1 - z * z)
    points = np.column_stack((r * np.cos(turn), r * np.sin(turn), z))
    return points[points[:, 1] < 0.3]  # loads point towards -y


def press(points, area, load, gap, shift):
    """Newton's method on D: the sum of p r dA is the load."""
    for _ in range(100):
        p = np.maximum(STIFF * (points @ shift - gap), 0)
        rest = load - area * points.T @ p
        if np.linalg.norm(rest) < 1e-10 * np.linalg.norm(load):
            return p, shift
        touching = points[p > 0]
        shift = shift + np.linalg.solve(
            area * STIFF * touching.T @ touching, rest)
    raise RuntimeError("no contact found")


def main():
    chosen = [int(x) for x in sys.argv[1:]]
    count, places, steps = chosen + [40000, 61, 6][len(chosen):]
    points = sphere(count)
    area = 4 * np.pi * RHO**2 / count
    slip = np.hypot(points[:, 0], points[:, 1])  # the swing is about z
    print("rho,clearance,E,nu,t,load,amplitude_deg,path,theta0_deg,p_max,S,"
          "theta0_off_deg,p_max_off,S_off,depth,volume")
    for force, degrees in ((3e4, 0), (3e4, 30), (1e4, 30)):
        swing = np.radians(degrees)
        there = (-swing + 2 * swing * (np.arange(places) + 0.5) / places
                 if degrees else np.zeros(1))
        path = np.concatenate((there, there[::-1]))
        gap = np.full(len(points), EPS)
        shift = np.zeros(3)
        done = 0.0
        for target in (1e-13, 3e-13, 1e-12, 3e-12):
            # A place wears at once by a small part of its displacement.
            rounds = int(np.ceil((target - done) * STIFF * steps / len(path)))
            rounds = max(rounds, 20)
            part = (target - done) / rounds / len(path)
            for _ in range(rounds):
                for turn in path:
                    load = force * np.array([np.sin(turn), -np.cos(turn), 0])
                    p, shift = press(points, area, load, gap,
                                     np.linalg.norm(shift) * load / force
                                     if shift.any() else 3 * EPS * load / force)
                    gap += part * slip * p
            done = target
            row = [RHO, EPS, E, NU, T, force, degrees, target]
            for turn in (0.0, swing / 2):
                load = force * np.array([np.sin(turn), -np.cos(turn), 0])
                p, _ = press(points, area, load, gap,
                             np.linalg.norm(shift) * load / force)
                cap = area * (p > 0).sum() / RHO**2
                row += [np.degrees(np.arccos(1 - cap / (2 * np.pi))), p.max(),
                        area * (p * slip).sum() / force]
            row += [(gap - EPS).max(), area * (gap - EPS).sum()]
            print(",".join(f"{x:.7g}" for x in row), flush=True)


main()
