#!/usr/bin/python3
"""Cost of a particle step against the number of particles: the lists, caches and memory of a scene.

usage: cost_against_size.py PROGRAM [--families equal,mix,wide,gas] [--steps 500] [--repeats 3]
                            [--small] [--work build/bench]

A column of 10,000 spheres of each family is settled, or stirred, once (kept in WORK/size/FAMILY)
and repeated along x and y up to 1.6 million: a large scene is many copies of a small one, so
contacts and motion of a particle are the same and only the size differs. The copies start without
springs; those at rest get 5 ms for new ones.
All sizes of all families take turns with `quern bench` on one thread, which measures the triad
before and after each. A turn counts if no triad of it was below 20 GB/s; figures are those of the
fastest that counts. Contacts a particle must be the same at all sizes; ends with 1 if they are not.
Writes bench/results/cost_against_size.txt and .svg; with --small, a trial of three sizes, it only
prints. Scenes of all sizes take 0.8 GB in WORK.
"""

import argparse
import os
import subprocess
import sys
from typing import NamedTuple

import h5py
import numpy as np

import quern_bench
import scene_speed

COLUMN = 10_000  # spheres
# Copies along x and y.
COPIES = ((1, 1), (2, 1), (2, 2), (4, 2), (4, 4), (8, 4), (8, 8), (16, 10))
SMALL_COPIES = COPIES[:3]
FROM, LIMIT = 20_000, 1.5  # the goal: from this size on within this ratio


class Family(NamedTuple):
    title: str
    side: float        # m, of the column along x and y, over twice the largest diameter
    height: float      # m, of the domain
    fill: float        # m, height of the loose filling
    particles: str     # amounts of a column, TOML
    speed: float = 0.0          # m/s, of bed and floor along x
    restitution: float = 0.3
    tolerance: float = 0.03     # share by which contacts may differ
    agitation: float = 0.0      # m/s, of a gas: deviation of each component; no floor, no weight


EQUAL = """[[particles]]
name = "ore"
material = "ore"
diameter = "20 mm"
count = 10000
"""
# A fortieth of apps/scenes/sag_slice_sp.toml.
MIX = """[[particles]]
name = "ball"
material = "steel"
diameter = "125 mm"
count = 62

[[particles]]
name = "ore"
material = "ore"
sizes = [
  { from = "15 mm", to = "25 mm", count = 7461 },
  { from = "25 mm", to = "35 mm", count = 1656 },
  { from = "35 mm", to = "45 mm", count = 590 },
  { from = "45 mm", to = "75 mm", count = 167 },
  { from = "75 mm", to = "105 mm", count = 51 },
  { from = "105 mm", to = "150 mm", count = 13 },
]
"""
# Equal masses in equal ratios of sizes.
WIDE = """[[particles]]
name = "ore"
material = "ore"
count = 10000
distribution = { table = [["15 mm", 0.0], ["300 mm", 1.0]] }
"""
FAMILIES = {
    "equal": Family("equal spheres at rest", 0.42, 1.2, 0.8, EQUAL),
    "mix": Family("1:10, the SAG mix, at 4 m/s", 0.5, 2.5, 2.0, MIX, speed=4.0),
    "wide": Family("1:20, at 4 m/s", 0.65, 1.5, 1.1, WIDE, speed=4.0),
    "gas": Family("equal spheres, a gas of 5 % solids", 0.943, 0.943, 0.943, EQUAL,
                  restitution=0.95, tolerance=0.1, agitation=2.0),
}
STIR = 0.1  # s, of a gas
REST = "5 ms"  # of copies at rest; else their energy account would open without the springs

SCENE = """format = 1

[run]
title = "{title}"
settle = "{settle}"
soft_stiffness = {soft}
calm = "0.15 s"
duration = "1 s"
time_step = "1e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "{gravity} m/s^2"]

[domain]
low = ["0 m", "0 m", "{low} m"]
high = ["{length:.9g} m", "{width:.9g} m", "{height} m"]
periodic = {periodic}

[materials.ore]
density = "4500 kg/m^3"

[materials.steel]
density = "7800 kg/m^3"

[contact]
normal_stiffness = "2e7 N/m"
tangential_stiffness = "8e6 N/m"
restitution = {restitution}
sliding_friction = 0.5
{floor}
[fill]
method = "random"
low = ["0 m", "0 m", "0 m"]
high = ["{length:.9g} m", "{width:.9g} m", "{fill} m"]

{particles}"""
FLOOR = """
[[walls]]
name = "floor"
material = "ore"
point = ["0 m", "0 m", "0 m"]
normal = [0, 0, 1]
motion = {{ kind = "translation", axis = [1, 0, 0], rate = "{speed} m/s" }}
"""


def scene_text(family, copies, particles, settle, soft=0.05):
    gas = family.agitation > 0
    return SCENE.format(
        title=family.title, settle=settle, soft=soft, gravity=0 if gas else -9.81,
        low=0 if gas else -0.1,
        length=copies[0] * family.side, width=copies[1] * family.side, height=family.height,
        periodic='["x", "y", "z"]' if gas else '["x", "y"]', restitution=family.restitution,
        floor="" if gas else FLOOR.format(speed=family.speed), fill=family.fill,
        particles=particles)


def species_of(family):
    return [line.split('"')[1] for line in family.particles.splitlines()
            if line.startswith("name")]


def from_csv(family, csv):
    """The family's particles, all from one file."""
    return "\n".join(f'[[particles]]\nname = "{name}"\n'
                     f'material = "{"steel" if name == "ball" else "ore"}"\ncsv = "{csv}"\n'
                     for name in species_of(family))


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def write_csv(path, x, v, diameter, species):
    with open(path, "w", encoding="utf-8") as out:
        out.write("x,y,z,diameter,vx,vy,vz,class\n")
        for p, u, d, s in zip(x.tolist(), v.tolist(), diameter.tolist(), species):
            out.write("%.12g,%.12g,%.12g,%.9g,%.7g,%.7g,%.7g,%s\n" % (*p, d, *u, s))


def write_unstirred(family, path):
    """Spheres of a gas, near the points of a lattice, with random velocities."""
    random = np.random.default_rng(1)
    cells = int(np.ceil(COLUMN ** (1 / 3)))
    spacing = family.side / cells
    points = random.permutation(cells ** 3)[:COLUMN]
    lattice = np.stack(np.unravel_index(points, (cells, cells, cells)), axis=1)
    free = 0.5 * (1 - 0.021 / spacing)  # spheres of 20 mm stay apart
    x = (lattice + 0.5 + random.uniform(-free, free, lattice.shape)) * spacing
    v = random.normal(0, family.agitation, x.shape)
    write_csv(path, x, v - v.mean(axis=0), np.full(COLUMN, 0.02), ["ore"] * COLUMN)


def column(program, name, work):
    """The file with the results of the column's run, made if it is not there."""
    family = FAMILIES[name]
    folder = os.path.join(work, name)
    out, done = os.path.join(folder, "column"), os.path.join(folder, "column_is_done")
    if not os.path.isfile(done):
        print(f"# {name}: getting ready ...", flush=True)
        os.makedirs(folder, exist_ok=True)
        particles, settle, until = family.particles, "until-rest", 0
        if family.agitation > 0:
            write_unstirred(family, os.path.join(folder, "unstirred.csv"))
            particles, settle, until = from_csv(family, "unstirred.csv"), "none", STIR
        scene = os.path.join(folder, "column.toml")
        write(scene, scene_text(family, (1, 1), particles, settle))
        command = [program, "run", scene, "--out", out, "--until", str(until),
                   "--set", "output.frames_every=0"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"error: {' '.join(command)}\n{result.stderr[-2000:]}")
        write(done, "\n")
    return os.path.join(out, "run.h5")


def scene_of(program, name, copies, work):
    """The scene of so many copies of the column, made if it is not there."""
    family = FAMILIES[name]
    results = column(program, name, work)
    stem = os.path.join(work, name, f"{COLUMN * copies[0] * copies[1]}")
    if os.path.isfile(stem + ".toml"):
        return stem + ".toml"
    with h5py.File(results) as file:
        last = file["final_particles"]
        x, v, radius, species = (last[key][:].astype(float) if key != "species" else last[key][:]
                                 for key in ("position", "velocity", "radius", "species"))
    gas = family.agitation > 0
    periodic = 3 if gas else 2
    x[:, :periodic] %= family.side
    if not gas:
        v[:] = (family.speed, 0, 0)
    steps = np.array([(i, j, 0) for i in range(copies[0]) for j in range(copies[1])])
    many = len(steps)
    names = species_of(family)
    write_csv(stem + ".csv", np.concatenate([x + step * family.side for step in steps]),
              np.tile(v, (many, 1)), np.tile(2 * radius, many), [names[s] for s in species] * many)
    settle = "none" if family.speed > 0 or gas else REST
    particles = from_csv(family, os.path.basename(stem) + ".csv")
    write(stem + ".toml", scene_text(family, copies, particles, settle, soft=1))
    return stem + ".toml"


def ns(found):
    return 1e9 / found["particle_steps_per_s"]


def best(turns):
    """The fastest turn, of those that count if any does."""
    return min([f for f in turns if quern_bench.counts(f)] or turns, key=ns)


def show(say, family, found):
    """`found`: by size, the turns. Whether contacts are the same at all sizes."""
    say(f"\n{family.title}")
    say("  particles  ns a particle step  all turns        contacts  listed  steps between  "
        "bytes  triad, GB/s")
    contacts = {size: quern_bench.contacts(best(turns)) for size, turns in found.items()}
    middle = sorted(contacts.values())[len(contacts) // 2]
    all_right = True
    for size, turns in found.items():
        f = best(turns)
        right = abs(contacts[size] / middle - 1) < family.tolerance
        all_right = all_right and right
        times = [ns(turn) for turn in turns]
        triads = quern_bench.triads(f)
        between = f["steps_between_rebuilds"]
        say(f"  {size:9}  {ns(f):18.1f}  {min(times):5.1f} ... {max(times):5.1f}  "
            f"{contacts[size]:8.4f}  {f['sphere_pairs_listed']:6.3f}  "
            f"{'none' if between is None else format(between, '.1f'):>13}  {f['bytes']:5.0f}  "
            f"{min(triads):.1f} ... {max(triads):.1f}"
            f"{'' if quern_bench.counts(f) else '  does not count'}{'' if right else '  DIFFERS'}")
    large = [ns(best(turns)) for size, turns in found.items() if size >= FROM]
    say(f"  most over least from {FROM // 1000}k on: {max(large) / min(large):.2f} "
        f"(goal: at most {LIMIT})")
    return all_right


def plot(found, path):
    import matplotlib  # trials do without
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "quern"  # the same names in each file
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(7, 4.2))
    for name, by_size in found.items():
        axes.plot(list(by_size), [ns(best(turns)) for turns in by_size.values()], "o-",
                  label=FAMILIES[name].title)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("particles")
    axes.set_ylabel("ns a particle step, one thread")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--families", default=",".join(FAMILIES))
    parser.add_argument("--steps", type=int, help="of a turn, after a tenth untimed; default: 500")
    parser.add_argument("--repeats", type=int, help="default: 3, of trials 1")
    parser.add_argument("--small", action="store_true", help="a trial: three sizes, 100 steps")
    parser.add_argument("--work", default=os.path.join(scene_speed.ROOT, "build", "bench"))
    options = parser.parse_args()
    work = os.path.join(os.path.abspath(options.work), "size")
    steps = options.steps or (100 if options.small else 500)
    copies = SMALL_COPIES if options.small else COPIES
    names = options.families.split(",")
    sizes = {COLUMN * a * b: (a, b) for a, b in copies}
    scenes = {(name, size): scene_of(options.program, name, pair, work)
              for name in names for size, pair in sizes.items()}
    found = {name: {size: [] for size in sizes} for name in names}
    for _ in range(options.repeats or (1 if options.small else 3)):
        for (name, size), scene in scenes.items():
            found[name][size].append(quern_bench.figures(
                options.program, scene, [], threads=1, steps=steps, repeats=1))
    report, all_right = quern_bench.Report(), True
    report.say_where(found[names[0]][COLUMN][0])
    report.say(f"# {found[names[0]][COLUMN][0]['simd_target']}, one thread, {steps} steps a turn; "
               "listed: pairs a particle; bytes: a particle and step")
    for name in names:
        all_right = show(report.say, FAMILIES[name], found[name]) and all_right
    if not options.small:
        report.write("cost_against_size.txt")
        plot(found, quern_bench.result_path("cost_against_size.svg"))
    sys.exit(0 if all_right else 1)


if __name__ == "__main__":
    main()
