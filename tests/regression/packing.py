#!/usr/bin/env python3
"""Solid fraction of a packing in a box: packing.py QUERN SCENE OUT [SEEDS]

Runs the scene with seeds 1 ... SEEDS (default 3) and prints for each the height of the highest
particle, the mean height of the top surface, and the solid fraction below that mean. Fails if a
fraction is outside 0.58 ... 0.64, or if a particle is missing.
"""
import os
import subprocess
import sys

import h5py
import numpy as np

SIDE = 0.08   # m, of the box
CELLS = 160   # of the height map along a side


def mean_top(position, radius):
    centre = (np.arange(CELLS) + 0.5) / CELLS * SIDE
    x, y = np.meshgrid(centre, centre)
    top = np.zeros((CELLS, CELLS))
    for p, r in zip(position, radius):
        d2 = (x - p[0]) ** 2 + (y - p[1]) ** 2
        over = d2 < r * r
        top[over] = np.maximum(top[over], p[2] + np.sqrt(r * r - d2[over]))
    return top.mean()


def main():
    quern, scene, out = sys.argv[1:4]
    seeds = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    good = True
    for seed in range(1, seeds + 1):
        folder = os.path.join(out, f"seed{seed}")
        subprocess.run([quern, "run", scene, "--out", folder, "--threads", "1",
                        "--set", f"run.seed={seed}"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with h5py.File(os.path.join(folder, "run.h5")) as file:
            position = file["final_particles/position"][:]
            radius = file["final_particles/radius"][:].astype(float)
        height = mean_top(position, radius)
        fraction = (4 / 3 * np.pi * radius**3).sum() / (SIDE * SIDE * height)
        fine = len(radius) == 300 and 0.58 <= fraction <= 0.64
        good = good and fine
        print(f"seed {seed}: {len(radius)} particles, highest {1e3 * (position[:, 2] + radius).max():.1f}"
              f" mm, mean {1e3 * height:.1f} mm, fraction {fraction:.3f}{'' if fine else ' OUTSIDE'}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
