#!/usr/bin/env python3
"""Packings of spheres and polyhedra in a box: box_packing.py QUERN SCENE OUT [SEEDS] [KEY=VALUE ...]

Runs four mixtures with seeds 1 ... SEEDS (default 3), two runs at a time; what is finished in OUT is not
repeated. Prints for each mixture the height of the highest point and the mean height of the top
surface, the heights to be expected for packed fractions of 0.56, 0.60 and 0.64, the packed fraction
below the mean height, and the kinetic energy at the end. Fails if a particle is missing, if a mean
fraction is outside 0.56 ... 0.64, or if it is not smooth in the mixture: a middle one more than 0.015
off the line between its neighbours (sizes of 1:1.3 and other shapes change it by 0.01 or so, seeds
by 0.005).
"""
import os
import sys

import h5py
import numpy as np

import runs

SIDE = 0.08  # m, of the box
CELLS = 160  # of the height map along a side
MIXTURES = [(0, 300), (50, 250), (100, 200), (140, 160)]  # spheres, polyhedra
EXPECTED = (0.56, 0.60, 0.64)
SMOOTH = 0.015


def turn_of(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def top_of_sphere(x, y, centre, radius):
    height = radius**2 - (x - centre[0]) ** 2 - (y - centre[1]) ** 2
    return np.where(height > 0, centre[2] + np.sqrt(np.maximum(height, 0)), 0)


def top_of_body(x, y, vertex, triangle):
    """Upper end of vertical lines in a convex body: the lowest of its upward faces."""
    a, b, c = (vertex[triangle[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    offset = (normal * a).sum(axis=1)
    upper, lower = np.full(x.shape, np.inf), np.full(x.shape, -np.inf)
    inside = np.ones(x.shape, bool)
    for n, d in zip(normal, offset):
        rest = d - n[0] * x - n[1] * y
        if n[2] > 1e-9:
            upper = np.minimum(upper, rest / n[2])
        elif n[2] < -1e-9:
            lower = np.maximum(lower, rest / n[2])
        else:
            inside &= rest >= 0
    return np.where(inside & (upper >= lower), upper, 0)


def read_charge(folder):
    """Places and radii of spheres; vertices and triangles of polyhedra; radii of all."""
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        place = file["final_particles/position"][:]
        radius = file["final_particles/radius"][:].astype(float)
        bodies = []
        polyhedra = len(file["final_polyhedra/id"])
        first = len(radius) - polyhedra
        for k in range(polyhedra):
            shape = file[f"shapes/{file['final_polyhedra/shape'][k]}"]
            turn = turn_of(file["final_polyhedra/orientation"][k])
            vertex = place[first + k] + radius[first + k] * shape["vertex"][:] @ turn.T
            bodies.append((vertex, shape["triangle"][:]))
        kinetic = file["series/kinetic_energy"][-1]
    return list(zip(place[:first], radius[:first])), bodies, radius, kinetic


def heights(spheres, bodies):
    """Highest point, and mean height of the top surface."""
    middle = (np.arange(CELLS) + 0.5) / CELLS * SIDE
    x, y = np.meshgrid(middle, middle)
    top = np.zeros(x.shape)
    highest = 0.0
    for centre, radius in spheres:
        top = np.maximum(top, top_of_sphere(x, y, centre, radius))
        highest = max(highest, centre[2] + radius)
    for vertex, triangle in bodies:
        columns = np.searchsorted(middle, [vertex[:, 0].min(), vertex[:, 0].max()])
        rows = np.searchsorted(middle, [vertex[:, 1].min(), vertex[:, 1].max()])
        part = np.s_[rows[0]:rows[1], columns[0]:columns[1]]
        top[part] = np.maximum(top[part], top_of_body(x[part], y[part], vertex, triangle))
        highest = max(highest, vertex[:, 2].max())
    return highest, top.mean()


def measure(mixture, folders):
    """Mean fraction of a mixture over its seeds; NaN if a particle is missing."""
    rows = []
    for folder in folders:
        spheres, bodies, radius, kinetic = read_charge(folder)
        if (len(spheres), len(bodies)) != mixture:
            print(f"{folder}: {len(spheres)} spheres and {len(bodies)} polyhedra are left")
            return np.nan
        highest, mean = heights(spheres, bodies)
        volume = (4 / 3 * np.pi * radius**3).sum()
        rows.append((highest, mean, volume / (SIDE * SIDE * mean), kinetic, volume))
    highest, mean, fraction, kinetic, volume = np.mean(rows, axis=0)
    scatter = np.std([row[2] for row in rows], ddof=1) if len(rows) > 1 else np.nan
    expected = " ".join(f"{1e3 * volume / (SIDE * SIDE * f):4.0f}" for f in EXPECTED)
    print(f"{mixture[0]:7} {mixture[1]:9} {1e3 * highest:10.1f} {1e3 * mean:8.1f}   {expected}"
          f"   {fraction:8.4f} +- {scatter:.4f} {kinetic:9.1e}")
    return fraction


def main():
    quern, scene, out = sys.argv[1:4]
    seeds = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    more = sys.argv[5:]
    folders = {(mixture, seed): os.path.join(out, f"{mixture[0]}_{mixture[1]}_seed{seed}")
               for mixture in MIXTURES for seed in range(1, seeds + 1)}
    runs.run_all(quern, scene, {
        (mixture, seed): (folder, [f"run.seed={seed}", f"particles.ball.count={mixture[0]}",
                                   f"particles.ore.count={mixture[1]}", *more])
        for (mixture, seed), folder in folders.items()})
    print("spheres polyhedra highest mm  mean mm   at 0.56 0.60 0.64   fraction            kinetic J")
    fractions = [measure(mixture, [folders[mixture, seed] for seed in range(1, seeds + 1)])
                 for mixture in MIXTURES]
    good = all(EXPECTED[0] <= fraction <= EXPECTED[-1] for fraction in fractions)
    share = [spheres for spheres, _ in MIXTURES]
    for k in range(1, len(MIXTURES) - 1):
        line = np.interp(share[k], [share[k - 1], share[k + 1]], [fractions[k - 1], fractions[k + 1]])
        if not abs(fractions[k] - line) < SMOOTH:
            print(f"not smooth at {MIXTURES[k]}: {fractions[k]:.4f}, its neighbours say {line:.4f}")
            good = False
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
