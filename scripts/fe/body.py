"""Elastic bodies between two circles by finite elements of eight nodes.

A half in plane strain, or a body of revolution about the load: t is the angle
from the load, 0 to pi, x = r sin t across it, y = r cos t along it. mm, N, MPa.
numpy alone: the stiffness of a polar mesh, angle by angle, has blocks on three
diagonals, and is eliminated in them.
"""
import numpy as np

GAUSS = np.polynomial.legendre.leggauss(3)
# Nodes of an element: corners, then middles, as (columns, rows) of half steps.
PLACES = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]


def shape(a, b):
    """Serendipity functions at (a, b) of the square -1 to 1, and slopes."""
    n, da, db = np.zeros(8), np.zeros(8), np.zeros(8)
    for i, (x, y) in enumerate([(-1, -1), (1, -1), (1, 1), (-1, 1)]):
        n[i] = (1 + x * a) * (1 + y * b) * (x * a + y * b - 1) / 4
        da[i] = x * (1 + y * b) * (2 * x * a + y * b) / 4
        db[i] = y * (1 + x * a) * (x * a + 2 * y * b) / 4
    for i, y in [(4, -1), (6, 1)]:
        n[i], da[i], db[i] = (1 - a * a) * (1 + y * b) / 2, -a * (1 + y * b), \
            y * (1 - a * a) / 2
    for i, x in [(5, 1), (7, -1)]:
        n[i], da[i], db[i] = (1 + x * a) * (1 - b * b) / 2, \
            x * (1 - b * b) / 2, -b * (1 + x * a)
    return n, da, db


def halved(corners):
    """Corners of elements with the middles between them."""
    all_ = np.empty(2 * len(corners) - 1)
    all_[::2] = corners
    all_[1::2] = (corners[1:] + corners[:-1]) / 2
    return all_


class Body:
    """@param radii, angles  of the elements' corners, increasing
    @param materials  (E, nu) of each row of elements
    @param round      whether it is a body of revolution"""

    def __init__(self, radii, angles, materials, is_round):
        self.r, self.t = halved(radii), halved(angles)
        self.round = is_round
        self.rows, self.columns = len(radii) - 1, len(angles) - 1
        # A column's nodes one after the other; none in the middle of elements.
        self.number = -np.ones((len(self.t), len(self.r)), int)
        count = 0
        for i in range(len(self.t)):
            step = 1 + i % 2
            here = np.arange(0, len(self.r), step)
            self.number[i, here] = count + np.arange(len(here))
            count += len(here)
        at_t, at_r = np.nonzero(self.number >= 0)
        order = np.argsort(self.number[at_t, at_r])
        self.node_t = self.t[at_t[order]]
        radius = self.r[at_r[order]]
        self.x = radius * np.sin(self.node_t)
        self.x[(self.node_t == 0) | (self.node_t == np.pi)] = 0
        self.y = radius * np.cos(self.node_t)
        self.elements = np.array(
            [[self.number[2 * i + a, 2 * j + b] for a, b in PLACES]
             for i in range(self.columns) for j in range(self.rows)])
        self.dofs = np.empty((len(self.elements), 16), int)
        self.dofs[:, ::2] = 2 * self.elements
        self.dofs[:, 1::2] = 2 * self.elements + 1
        of = np.tile(np.array(materials, float), (self.columns, 1))
        self.set_stiffness(of[:, 0], of[:, 1])

    def set_stiffness(self, e, nu):
        lame, shear = e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))
        x, y = self.x[self.elements], self.y[self.elements]
        d = np.zeros((len(x), 4, 4))
        d[:, :3, :3] = lame[:, None, None]
        for k in range(3):
            d[:, k, k] += 2 * shear
        d[:, 3, 3] = shear
        k = np.zeros((len(x), 16, 16))
        volume = np.zeros((len(x), 8))
        for a, wa in zip(*GAUSS):
            for b, wb in zip(*GAUSS):
                n, da, db = shape(a, b)
                xa, ya, xb, yb = x @ da, y @ da, x @ db, y @ db
                area = xa * yb - ya * xb
                nx = (np.outer(yb, da) - np.outer(ya, db)) / area[:, None]
                ny = (np.outer(xa, db) - np.outer(xb, da)) / area[:, None]
                weight = wa * wb * area
                g = np.zeros((len(x), 4, 16))
                g[:, 0, ::2], g[:, 1, 1::2] = nx, ny
                g[:, 3, ::2], g[:, 3, 1::2] = ny, nx
                if self.round:
                    weight = weight * (x @ n) * 2 * np.pi
                    g[:, 2, ::2] = n / (x @ n)[:, None]
                k += np.swapaxes(g, 1, 2) @ (d @ g) * weight[:, None, None]
                volume += weight[:, None] * n
        self.stiffness = k
        self.volume = np.bincount(self.elements.ravel(), volume.ravel())

    def circle(self, is_outer):
        """Nodes along one of the two circles."""
        return self.number[:, -1 if is_outer else 0]

    def circle_matrix(self, is_outer):
        """∫ N_i N_j ds along a circle, of the half or of the whole turn."""
        nodes = self.circle(is_outer)
        matrix = np.zeros((len(nodes), len(nodes)))
        for j in range(0, len(nodes) - 2, 2):
            three = [j, j + 1, j + 2]
            x, y = self.x[nodes[three]], self.y[nodes[three]]
            for a, w in zip(*np.polynomial.legendre.leggauss(5)):
                n = np.array([a * (a - 1), 2 - 2 * a * a, a * (a + 1)]) / 2
                slope = np.array([a - .5, -2 * a, a + .5])
                ds = w * np.hypot(slope @ x, slope @ y)
                if self.round:
                    ds *= 2 * np.pi * (n @ x)
                matrix[np.ix_(three, three)] += ds * np.outer(n, n)
        return matrix

    def forces(self, u):
        """Forces on the nodes that displacements ask for."""
        force = np.einsum("kij,kj->ki", self.stiffness, u[self.dofs])
        return np.bincount(self.dofs.ravel(), force.ravel())

    def solve(self, forces, fixed):
        """Displacements under columns of forces, some of them held at 0."""
        starts = np.append(self.number[0, 0],
                           self.number[1::2, 0].tolist() + [len(self.x)]) * 2
        first = np.searchsorted(starts, 2 * self.elements[:, 0], "right") - 1
        held = np.zeros(2 * len(self.x), bool)
        held[fixed] = True
        load = np.where(held[:, None], 0, forces)
        solved, before, coupling = [], None, None
        count = len(starts) - 1
        blocks = [np.zeros((starts[k + 1] - starts[k],) * 2)
                  for k in range(count)]
        below = [None] + [np.zeros((starts[k + 1] - starts[k],
                                    starts[k] - starts[k - 1]))
                          for k in range(1, count)]
        for k, stiffness, dof in zip(first, self.stiffness, self.dofs):
            stiff = np.where(held[dof][:, None] | held[dof], 0, stiffness)
            here = dof < starts[k + 1]
            there = ~here
            a, b = dof[here] - starts[k], dof[there] - starts[k + 1]
            blocks[k][np.ix_(a, a)] += stiff[np.ix_(here, here)]
            blocks[k + 1][np.ix_(b, b)] += stiff[np.ix_(there, there)]
            below[k + 1][np.ix_(b, a)] += stiff[np.ix_(there, here)]
        for k in range(count):
            part = slice(starts[k], starts[k + 1])
            diagonal = blocks[k] + np.diag(1. * held[part])
            right = load[part]
            if k:
                diagonal = diagonal - below[k] @ coupling
                right = right - below[k] @ before
            ahead = below[k + 1].T if k + 1 < count else np.zeros((len(right), 0))
            both = np.linalg.solve(diagonal, np.hstack([ahead, right]))
            coupling, before = both[:, :ahead.shape[1]], both[:, ahead.shape[1]:]
            solved.append((coupling, before))
        u = np.zeros_like(load)
        after = None
        for k in reversed(range(count)):
            coupling, mine = solved[k]
            if after is not None:
                mine = mine - coupling @ after
            u[starts[k]:starts[k + 1]] = after = mine
        return u
