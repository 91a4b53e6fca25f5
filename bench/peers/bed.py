#!/usr/bin/python3
"""The settled bed in quern and in LAMMPS, from the same state, in turns.

usage: bed.py PROGRAM [--lammps lmp] [--steps 200] [--warm 100] [--repeats 3] [--work build/bench]
              [--set KEY=VALUE ...]                                  (needs lammps, python3-h5py)

quern settles the bed (WORK/settled/bed, shared with scene_speed.py) and takes one step more;
positions, velocities and spins of that run go to LAMMPS, which starts without the springs of the
contacts and takes WARM steps before the STEPS that are timed. Both run on one processor. First the
two must agree: contacts of a particle with particles within 0.2, kinetic energy of a particle below
a thousandth of m g d in both, else there is no speed to compare. Prints a row a repeat with the
bandwidth before and after (see scene_speed.py), million particle steps a second and their ratio,
then medians with ranges.
"""

import argparse
import os
import re
import statistics
import subprocess
import sys
import tomllib

import h5py
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import scene_speed  # noqa: E402

DECK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bed.lammps")
DENSITY, TIME_STEP, GRAVITY = 4500, 1e-5, 9.81  # of apps/scenes/bed.toml and the deck
CONTACTS_AGREE, REST = 0.2, 1e-3


def hand_over(folder, data):
    """Writes LAMMPS's data file; the number of particles, and m g d of one in J."""
    with open(os.path.join(folder, "scene.toml"), "rb") as file:
        domain = tomllib.load(file)["domain"]
    low, high = (np.array([float(text.split()[0]) for text in domain[k]]) for k in ("low", "high"))
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        last = file["final_particles"]
        x, v, w = (last[name][:].astype(float) for name in ("position", "velocity", "spin"))
        diameter = 2 * last["radius"][:].astype(float)
    x[:, :2] = low[:2] + np.mod(x[:, :2] - low[:2], high[:2] - low[:2])
    with open(data, "w", encoding="utf-8") as out:
        out.write(f"quern's settled bed\n\n{len(x)} atoms\n1 atom types\n\n")
        for axis, a, b in zip("xyz", low, high):
            out.write(f"{a:.9g} {b:.9g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for k, (p, d) in enumerate(zip(x, diameter)):
            out.write(f"{k + 1} 1 {d:.9g} {DENSITY} {p[0]:.15g} {p[1]:.15g} {p[2]:.15g}\n")
        out.write("\nVelocities\n\n")
        for k, row in enumerate(np.hstack([v, w])):
            out.write(f"{k + 1} {' '.join(f'{value:.9g}' for value in row)}\n")
    d = float(np.median(diameter))
    return len(x), DENSITY * np.pi / 6 * d**3 * GRAVITY * d


def run_lammps(options, data, particles):
    """Particle steps a second, contacts a particle, kinetic energy of a particle in J."""
    command = [options.lammps, "-in", DECK, "-log", "none", "-var", "data", data,
               "-var", "warm", str(options.warm), "-var", "steps", str(options.steps)]
    result = subprocess.run(command, capture_output=True, text=True, check=False,
                            env={**os.environ, "OMP_NUM_THREADS": "1"})
    loops = re.findall(r"Loop time of (\S+) on", result.stdout)
    rows = re.findall(r"^ *\d+ +\d+ +\S+ +\S+ +\S+ *$", result.stdout, re.MULTILINE)
    if result.returncode != 0 or len(loops) != 2 or not rows:
        sys.exit(f"error: {' '.join(command)}\n{result.stdout[-2000:]}{result.stderr}")
    _, _, kinetic, turning, contacts = map(float, rows[-1].split())
    return particles * options.steps / float(loops[1]), contacts, (kinetic + turning) / particles


def run_quern(options, duration):
    """As run_lammps()."""
    s = scene_speed.go_on(options.program, "bed", options.work, 1, duration, options.set)
    energy = (s["kinetic_energy_J"] + s["rotational_energy_J"]) / s["particles"]
    return s["particle_steps_per_s"], s["contacts_per_particle"], energy


def spread(values):
    return f"{statistics.median(values):.2f} ({min(values):.2f} ... {max(values):.2f})"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--lammps", default="lmp")
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--warm", type=int, default=100)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--work", default=os.path.join(scene_speed.ROOT, "build", "bench"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    options = parser.parse_args()
    options.work = os.path.abspath(options.work)
    print(f"# {scene_speed.processor()}", flush=True)
    run_quern(options, TIME_STEP)
    data = os.path.join(options.work, "bed.data")
    particles, lift = hand_over(os.path.join(options.work, "out", "bed"), data)
    found = []
    for k in range(options.repeats):
        before = scene_speed.triad(options.program, 1)
        ours = run_quern(options, options.steps * TIME_STEP)
        theirs = run_lammps(options, data, particles)
        after = scene_speed.triad(options.program, 1)
        if k == 0:
            print(f"{particles} particles; contacts of one {ours[1]:.2f}, LAMMPS {theirs[1]:.2f}; "
                  f"kinetic energy of one {ours[2]:.1e} J, LAMMPS {theirs[2]:.1e} J "
                  f"({REST} m g d = {REST * lift:.1e} J)")
            if abs(ours[1] - theirs[1]) > CONTACTS_AGREE or max(ours[2], theirs[2]) > REST * lift:
                sys.exit("error: not the same bed at rest: no speeds")
            print("triad, GB/s       quern   LAMMPS   ratio   (million particle steps a second)")
        found.append((ours[0] / 1e6, theirs[0] / 1e6))
        print(f"{scene_speed.range_of([before, after]):16}  {ours[0] / 1e6:6.2f}  "
              f"{theirs[0] / 1e6:7.2f}  {ours[0] / theirs[0]:6.2f}", flush=True)
    print(f"quern {spread([f[0] for f in found])}, LAMMPS {spread([f[1] for f in found])}, "
          f"ratio {spread([f[0] / f[1] for f in found])}")


if __name__ == "__main__":
    main()
