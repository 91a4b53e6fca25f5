#!/usr/bin/python3
"""Two scenes of the same mill, step by step in turns: what the second costs beside the first.

usage: compare_scenes.py PROGRAM FIRST.toml SECOND.toml [--exchange] [--turn 0.5] [--steps 2000]
                         [--repeats 5] [--threads 1] [--work build/bench/compare]

Settles FIRST, turns it for TURN seconds; SECOND likewise, from its own filling or, with --exchange,
from FIRST's settled state with its shapes exchanged and relaxed. Then both go on from there for STEPS
steps, REPEATS times in turns. Prints the ratio of their times with its range, the touching pairs of
each kind, and what a touching pair costs (all that is done for its kind, pairs that do not touch
included, over the pairs that touch). What is settled and turned in WORK is used again, what was
stopped goes on.
"""
import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tomllib

import h5py

import scene_speed

# Stage: its contacts, of the means read from run.h5.
CONTACTS = {
    "sphere_pairs": lambda m: m["pairs"] - m["polyhedron_sphere"] - m["polyhedron_pair"],
    "polyhedron_spheres": lambda m: m["polyhedron_sphere"],
    "polyhedron_pairs": lambda m: m["polyhedron_pair"],
    "sphere_walls": lambda m: m["walls"] - m["polyhedron_wall"],
    "polyhedron_walls": lambda m: m["polyhedron_wall"],
}


def call(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(command)}\n{result.stderr}")


def turned(options, scene, folder, start=()):
    """The folder gets the state after TURN seconds with STEPS steps to go."""
    with open(scene, "rb") as file:
        run = tomllib.load(file)["run"]
    last = options.steps * float(run["time_step"].split()[0])
    record = "record_from_revolution" if "record_from_revolution" in run else "record_from"
    settings = [f"run.duration={options.turn + last}", f"run.{record}=0", "output.frames_every=0",
                f"output.series_every={last / 10}", *scene_speed.PLAIN, *start]
    done = os.path.join(folder, "turned")
    if not os.path.isfile(done):
        command = [options.program, "run", scene, "--out", folder]
        for setting in settings:
            command += ["--set", setting]
        if os.path.isfile(os.path.join(folder, "checkpoint.h5")):
            command = [options.program, "resume", folder]
        command += ["--threads", str(os.cpu_count()), "--until", str(options.turn)]
        print(f"# {os.path.basename(scene)}: getting ready ...", flush=True)
        call(*command)
        with open(done, "w", encoding="utf-8") as file:
            file.write("\n")


def means(folder, start):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        late = file["series/time"][:] > start + 1e-9
        mean = lambda name: file["series/" + name][:][late].mean() if name in file["series"] else 0.0
        found = {"pairs": mean("contacts_per_particle") * summary["particles"] / 2,
                 "walls": mean("wall_contacts")}
        for kind in ("polyhedron_sphere", "polyhedron_pair", "polyhedron_wall"):
            found[kind] = mean(kind + "_contacts")
    return summary, found


def measure(options, folder, scratch):
    """Seconds a step, and the summary with the mean numbers of contacts, of STEPS steps from there."""
    shutil.rmtree(scratch, ignore_errors=True)
    shutil.copytree(folder, scratch)
    call(options.program, "resume", scratch, "--threads", str(options.threads))
    summary, contacts = means(scratch, options.turn)
    return summary["particles"] / summary["particle_steps_per_s"], summary, contacts


def report(name, seconds, summary, contacts, options):
    particles = summary["particles"]
    print(f"{name}: {summary['spheres']} spheres, {summary['polyhedra']} polyhedra, "
          f"{summary['simd_target']}, {options.threads} threads")
    print(f"  {particles / statistics.median(seconds) / 1e6:.3g} million particle steps/s, "
          f"{1e6 * statistics.median(seconds):.4g} us a step "
          f"({1e6 * min(seconds):.4g} ... {1e6 * max(seconds):.4g}); "
          f"{100 * summary['rebuild_s'] / (statistics.median(seconds) * options.steps):.0f} % rebuilds")
    for stage, count in CONTACTS.items():
        touching, busy = count(contacts), summary.get(stage + "_busy_s", 0)
        if busy == 0 or touching < 0.5:
            continue
        cost = busy / options.steps / touching
        print(f"  {stage.replace('_', ' '):20} {touching:10.0f} touching {1e6 * cost:8.3f} us each")
    motion = summary["motion_busy_s"] / options.steps / particles
    print(f"  {'motion':20} {particles:10d} bodies   {1e6 * motion:8.3f} us each", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("first")
    parser.add_argument("second")
    parser.add_argument("--exchange", action="store_true")
    parser.add_argument("--turn", type=float, default=0.5)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--work", default="build/bench/compare")
    options = parser.parse_args()
    names = [os.path.splitext(os.path.basename(s))[0] for s in (options.first, options.second)]
    folders = [os.path.join(options.work, name) for name in names]
    turned(options, options.first, folders[0])
    start = []
    if options.exchange:
        start = ["run.start=file", f"run.start_file={os.path.abspath(folders[0])}/settled"]
    turned(options, options.second, folders[1], start)
    scratch = os.path.join(options.work, "scratch")
    found = [[], []]
    for _ in range(options.repeats):
        for side in (0, 1):
            found[side].append(measure(options, folders[side], scratch))
    for side in (0, 1):
        _, summary, contacts = found[side][-1]
        report(names[side], [f[0] for f in found[side]], summary, contacts, options)
    ratios = [b[0] / a[0] for a, b in zip(*found)]
    print(f"time of {names[1]} over {names[0]}: {statistics.median(ratios):.3f} "
          f"({', '.join(f'{r:.3f}' for r in ratios)})")


main()
