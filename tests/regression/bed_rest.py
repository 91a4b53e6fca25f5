#!/usr/bin/env python3
"""How much a packing at rest still moves: bed_rest.py QUERN SCENE OUT [KEY=VALUE ...]

Three runs, each from the end of the one before: the scene settles; it stands STAND seconds with
tangential damping, whatever the scene says, no drag, and a friction of 0.3, so that under a higher
one of its own hardly a contact is near sliding; what still swings is taken by a drag for 0.2 s, and
then it stands OWN seconds under its own law. Prints the median, mean and largest kinetic
energy of a particle, turning included, after each, and fails if the last median is above 1e-13 J.
`stand` and `own` (s) may be given among the settings; a run that is finished is not repeated.
"""
import os
import sys

import h5py
import numpy as np

import runs

LIMIT = 1e-13   # J
FRICTION = 0.3  # while it stands


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
    stand, own = given.pop("stand", "0.6"), given.pop("own", "0.35")
    common = ["output.series_every=5 ms", *(f"{key}={value}" for key, value in given.items())]
    plan = {
        "settle": ["run.duration=10 ms"],
        "stand": ["contact.tangential_damping=true", f"contact.sliding_friction={FRICTION}",
                  f"run.duration={stand} s"],
        "own": ["run.relax=0.25 s", f"run.duration={own} s"],
    }
    before, median = None, np.inf
    for name, settings in plan.items():
        start = [] if before is None else ["run.start=file", f"run.start_file={before}"]
        folder = os.path.abspath(os.path.join(out, name))
        summary = runs.run_once(quern, scene, folder, settings + common + start,
                                threads=os.cpu_count())
        energy = energies(folder, density_of(scene))
        median = np.median(energy)
        print(f"{name}: {summary['particles']} particles, {summary['contacts_per_particle']:.2f} "
              f"contacts each; kinetic energy of a particle: median {median:.1e} J, "
              f"mean {energy.mean():.1e} J, largest {energy.max():.1e} J", flush=True)
        before = folder
    return 0 if median < LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
