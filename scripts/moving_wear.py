#!/usr/bin/python3
"""Makes moving_wear.csv: holes that wear under a load that swings in them.

Step by step, instant after instant: the load stands at one place of its swing,
the contact is solved on a circle of points, every point wears by its own
pressure (explicitly), and the load goes on to the next place, there and back.
Nothing is shared with the library: the compliances of a disc and of a
hole in an infinite body (Muskhelishvili) are written down again here, and the
contact is a linear system on the points that touch.

    moving_wear.py [POINTS [PLACES [SHARE]]] > moving_wear.csv

POINTS of the circle, PLACES of the swing, and the SHARE of the largest stable
step. The rows are from 960 61 0.7. Among them 0_off is half-way to the end
of the swing (depth_off at its end).
"""
import sys

import numpy as np

RHO, EPS, E, NU = 0.02, 4e-5, 1e11, 0.3
MODULUS = E / (1 - NU**2)  # twice the contact's: two bodies alike


def compliance(count):
    """Matrix from pressures at the points to displacements, m/Pa, without n = 1."""
    k = (1 - 2 * NU) / (2 * (1 - NU))
    n = np.arange(2, count // 2 + 1)
    c = np.zeros(count // 2 + 1)
    c[2:] = 0.5 * ((n - k) + (n + k)) / (n * n - 1.0)
    c[0] = 0.5 * (k + 1 - k)
    c *= 4 * RHO / MODULUS
    row = np.fft.irfft(c, count)
    i = np.arange(count)
    return row[(i[:, None] - i[None, :]) % count]


class Circle:
    def __init__(self, count):
        self.count = count
        self.angle = 2 * np.pi * np.arange(count) / count
        self.lever = np.column_stack((np.cos(self.angle), np.sin(self.angle)))
        self.c = compliance(count)

    def press(self, load, direction, gap, touching):
        """Pressures under P (N/m): u + gap - D.r = 0 where p > 0, else >= 0."""
        force = load / RHO / (2 * np.pi / self.count)
        goal = force * np.array([np.cos(direction), np.sin(direction)])
        for _ in range(100):
            t = np.flatnonzero(touching)
            r = self.lever[t]
            both = np.linalg.solve(self.c[np.ix_(t, t)],
                                   np.column_stack((r, gap[t])))
            shift = np.linalg.solve(r.T @ both[:, :2], goal + r.T @ both[:, 2])
            p = np.zeros(self.count)
            p[t] = both[:, :2] @ shift - both[:, 2]
            open_gap = self.c @ p + gap - self.lever @ shift
            now = np.where(touching, p > 0, open_gap < -1e-15)
            if (now == touching).all():
                return p
            touching = now
        raise RuntimeError("no contact found")

    def half_angle(self, p, direction):
        """Half the arc between the two ends, where p^2 goes to 0."""
        step = 2 * np.pi / self.count
        ends = []
        for side in (1, -1):
            i = int(round(direction / step))
            while p[(i + side) % self.count] > 0:
                i += side
            near, far = (p[(i - j * side) % self.count]**2 for j in (1, 2))
            end = near / (far - near) - 1 if far > near else 1.0
            share = min(max(end, 0.0), 1.0)
            ends.append(side * (i * step - direction) + share * step)
        return sum(ends) / 2


def swing(circle, load, amplitude, places, share, sigmas):
    """Rows at the paths sigma (times rho eps/P) that slid under the load."""
    gap = np.full(circle.count, EPS)
    there = -amplitude + 2 * amplitude * (np.arange(places) + 0.5) / places
    path = np.concatenate((there, there[::-1]))
    largest = share * 2 * 4 * RHO / MODULUS / (circle.count / 2)
    at = {d: np.cos(circle.angle - d) > 0.9 for d in there}
    done = 0.0
    unit = RHO * EPS / load
    for sigma in sigmas:
        # Whole swings, as many as the largest step asks for.
        rest = sigma * unit - done
        swings = max(int(np.ceil(rest / (largest * len(path)))), 4)
        step = rest / swings / len(path)
        for _ in range(swings):
            for d in path:
                p = circle.press(load, d, gap, at[d])
                at[d] = p > 0
                gap += step * p
        done = sigma * unit
        row = [sigma * unit]
        for d in (0.0, amplitude / 2):
            p = circle.press(load, d, gap, np.cos(circle.angle - d) > 0.8)
            row += [np.degrees(circle.half_angle(p, d)), p.max(),
                    2 * np.pi / circle.count * RHO * p.sum() / load]
        worn = gap - EPS
        off = np.interp(amplitude, circle.angle, worn)
        row += [worn.max(), off, worn.sum() * RHO * 2 * np.pi / circle.count]
        yield row


def main():
    chosen = [float(x) for x in sys.argv[1:]]
    count, places, share = (chosen + [960, 61, 0.7][len(chosen):])[:3]
    circle = Circle(int(count))
    print("rho,clearance,E,nu,load,amplitude_deg,sigma,"
          "theta0_deg,p_max,S,theta0_off_deg,p_max_off,S_off,"
          "depth,depth_off,area")
    for load, degrees in ((8e5, 0), (8e5, 20), (8e5, 45), (3e5, 45)):
        rows = swing(circle, load, np.radians(degrees),
                     int(places) if degrees else 1, share, (0.1, 0.3, 1, 3, 10))
        for row in rows:
            print(",".join(f"{x:.7g}" for x in
                           [RHO, EPS, E, NU, load, degrees, *row]), flush=True)


main()
