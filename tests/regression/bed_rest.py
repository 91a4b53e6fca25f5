#!/usr/bin/env python3
"""How much a settled packing still moves: bed_rest.py QUERN SCENE OUT [KEY=VALUE ...]

Settles the scene with a long calm, lets it stand under its own law and prints the median, mean and
largest kinetic energy of a particle, turning included. Fails if the median is above 1e-13 J.
`stand` and `calm` (s) may be given among the settings; a run that is finished is not repeated.
"""
import os
import sys

import h5py
import numpy as np

import runs

LIMIT = 1e-13  # J


def energies(folder, density):
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        last = file["final_particles"]
        radius = last["radius"][:].astype(float)
        v2 = (last["velocity"][:].astype(float) ** 2).sum(axis=1)
        w2 = (last["spin"][:].astype(float) ** 2).sum(axis=1)
    mass = density * 4 / 3 * np.pi * radius**3
    return 0.5 * mass * v2 + 0.2 * mass * radius**2 * w2


def density_of(scene):
    with open(scene, encoding="utf-8") as file:
        line = next(text for text in file if text.startswith("density"))
    return float(line.split('"')[1].split()[0])


def main():
    quern, scene, out = sys.argv[1:4]
    given = dict(text.split("=", 1) for text in sys.argv[4:])
    calm, stand = given.pop("calm", "0.8"), given.pop("stand", "0.4")
    settings = [f"run.calm={calm} s", f"run.duration={stand} s", "output.series_every=5 ms",
                *(f"{key}={value}" for key, value in given.items())]
    summary = runs.run_once(quern, scene, out, settings, threads=os.cpu_count())
    energy = energies(out, density_of(scene))
    print(f"{summary['particles']} particles, {summary['contacts_per_particle']:.2f} contacts each, "
          f"{stand} s after settling: kinetic energy of a particle: median {np.median(energy):.1e} J, "
          f"mean {energy.mean():.1e} J, largest {energy.max():.1e} J")
    return 0 if np.median(energy) < LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
