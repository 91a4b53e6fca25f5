#!/usr/bin/python3
"""quern beside LAMMPS and LIGGGHTS on whole scenes, and its narrow phases beside other libraries.

usage: peers.py PROGRAM [--scenes bed,mix_bed,sag_slice_sp,lab_mill_reference] [--repeats 5]
                [--steps N] [--warm N] [--threads 1,2] [--small] [--work build/bench] [--no-kernels]

Each scene is settled, and its mill turned, by quern once (kept in WORK/peers/SCENE/state). All
programs start there and take some hundred steps untimed: the peers get places, velocities and
spins, no springs. Then they take turns, REPEATS times STEPS steps, the bandwidth of the memory
(quern_triad, beside PROGRAM) measured between any two. Where a peer's kinetic energy, contacts or
torque differ from quern's by more than the scene allows, its speed does not count; nor does a row
in which a triad was below 20 GB/s. Ends with 1 if a peer differs. What is compared and how alike
the programs are stands in bench/README.md. Writes bench/results/peers.txt, trials do not.
"""

import argparse
import json
import math
import os
import signal
import statistics
import subprocess
import sys
from typing import NamedTuple

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import scene_speed  # noqa: E402
import states  # noqa: E402
from programs import Peer, Quern  # noqa: E402

PEERS = ("lammps", "liggghts")
PROGRAMS = ("quern", *PEERS)
LEAST_TRIAD = 20  # GB/s
GRAVITY = 9.81


class Agreement(NamedTuple):
    """How far a peer may be from quern: means of the timed steps."""
    contacts: float  # a particle
    kinetic: float   # share of quern's; of a bed at rest instead: m g d a particle, in both
    torque: float | None = None  # share of quern's


class Scene(NamedTuple):
    size: object   # states.Size or states.Column
    small: object
    warm: int      # steps before the timed ones
    steps: int
    small_steps: int
    agreement: Agreement
    at_rest: bool = False
    cylinder: bool = False  # LAMMPS has no lifters


SMALL_BED = tuple(f'{key}.high=["0.3 m", "0.6 m", "{z} m"]' for key, z in
                  (("domain", 1.2), ("fill", 0.8)))
SCENES = {
    "bed": Scene(states.Size(), states.Size(10, SMALL_BED), 200, 200, 200,
                 Agreement(0.2, 1e-3), at_rest=True),
    "mix_bed": Scene(states.Column(16, 0.6, 0.5, 3.8, 16), states.Column(100, 0.31, 0.31, 2.0, 2),
                     600, 100, 100, Agreement(0.3, 0.01)),
    "sag_slice_sp": Scene(states.Size(turn=0.5), states.Size(40, turn=0.3), 600, 200, 1000,
                          Agreement(0.2, 0.03, 0.2), cylinder=True),
    "lab_mill_reference": Scene(states.Size(turn=2.0), states.Size(turn=0.2), 10000, 10000, 10000,
                                Agreement(0.3, 0.15, 0.15), cylinder=True),
}


class Row(NamedTuple):
    triad: list    # GB/s, before, between and after
    results: dict  # program: Result


def disagreement(scene, program, found, lift):
    """Why the speed of a peer does not count, or nothing. `found`: program: [Result]."""
    if program == "quern" or (scene.cylinder and program == "lammps"):
        return []  # without lifters it is another mill: shown, not judged

    def mean(which, what):
        return statistics.mean(getattr(result, what) for result in found[which])

    def apart(what):
        return abs(mean(program, what) / mean("quern", what) - 1)

    allowed, wrong = scene.agreement, []
    if abs(mean(program, "contacts") - mean("quern", "contacts")) > allowed.contacts:
        wrong.append("contacts")
    if scene.at_rest:
        if max(mean(p, "kinetic") for p in (program, "quern")) > allowed.kinetic * lift:
            wrong.append("not at rest")
    elif apart("kinetic") > allowed.kinetic:
        wrong.append("kinetic energy")
    if allowed.torque and apart("torque") > allowed.torque:
        wrong.append("torque")
    return wrong


def steps_of(options, scene):
    """Untimed and timed, the former a multiple of the latter: means of torque are over so many."""
    steps = options.steps or (scene.small_steps if options.small else scene.steps)
    return -(-(options.warm or scene.warm) // steps) * steps, steps


def take_turns(options, name, state):
    """By number of threads, one row a repeat."""
    warm, steps = steps_of(options, SCENES[name])
    contestants = {}
    try:
        for threads in options.threads:
            contestants["quern", threads] = Quern(options.program, state, threads)
            for program in PEERS:
                contestants[program, threads] = Peer(program, name, state, threads, steps)
        for contestant in contestants.values():
            contestant.go(warm)
        rows = {threads: [] for threads in options.threads}
        for _ in range(options.repeats):
            for threads in options.threads:
                row = Row([scene_speed.triad(options.program, threads)], {})
                for program in PROGRAMS:
                    row.results[program] = contestants[program, threads].go(steps)
                    row.triad.append(scene_speed.triad(options.program, threads))
                rows[threads].append(row)
        return rows
    finally:
        for contestant in contestants.values():
            contestant.end()


def spread(values, digits=2):
    return (f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f} ... "
            f"{max(values):.{digits}f})")


def counts(row):
    return min(row.triad) >= LEAST_TRIAD


def print_ratio(say, what, pairs):
    """Of pairs of a row each (ratio, does it count)."""
    good = [ratio for ratio, right in pairs if right]
    say(f"  {what}: " + (f"{spread(good)}, {len(good)} of {len(pairs)} count" if good else
                         f"none counts; all {spread([ratio for ratio, _ in pairs])}"))


def print_results(say, scene, rows, particles, lift):
    """What each program found; the programs that do not agree with quern."""
    wrong = set()
    found = {p: [row.results[p] for row in rows] for p in PROGRAMS}
    for program, results in found.items():
        mean = {what: statistics.mean(getattr(r, what) for r in results)
                for what in ("contacts", "kinetic", "torque")}
        why = disagreement(scene, program, found, lift)
        if why:
            wrong.add(program)
        torque = f", torque {mean['torque']:.4g} Nm" if scene.agreement.torque and\
            not math.isnan(mean['torque']) else ""
        say(f"  {program:9} {mean['contacts']:.3f} contacts a particle, "
            f"{mean['kinetic'] / particles:.4g} J a particle{torque}, "
            f"{results[-1].memory:.0f} B a particle"
            f"{'; DIFFERS: ' + ', '.join(why) if why else ''}")
    return wrong


def print_rows(say, threads, rows):
    say(f"  triad, GB/s        quern    LAMMPS  LIGGGHTS   million particle steps a second, "
        f"{threads} thread{'s' * (threads > 1)} or ranks")
    for row in rows:
        speeds = "  ".join(f"{row.results[p].speed / 1e6:8.2f}" for p in PROGRAMS)
        say(f"  {min(row.triad):4.1f} ... {max(row.triad):4.1f}  {speeds}"
            f"{'' if counts(row) else '   does not count'}")


def compare(say, options, name):
    """Whether the programs agree."""
    scene = SCENES[name]
    size = scene.small if options.small else scene.size
    state = states.state(options.program, name, size, options.work, options.small)
    particles, mass, diameter = states.hand_over(options.program, name, state)
    warm, steps = steps_of(options, scene)
    say(f"\n{name}: {particles} spheres, {steps} steps a run, {warm} before the first"
        f"{'; LAMMPS: a plain cylinder, no lifters' if scene.cylinder else ''}")
    rows = take_turns(options, name, state)
    lift, wrong = particles * mass * GRAVITY * diameter, set()
    for threads, own in rows.items():
        wrong |= print_results(say, scene, own, particles, lift)
        print_rows(say, threads, own)
        for program in PEERS:
            if program not in wrong:
                print_ratio(say, f"quern over {program}", [
                    (row.results["quern"].speed / row.results[program].speed, counts(row))
                    for row in own])
    first = options.threads[0]
    for threads in options.threads[1:]:
        for program in PROGRAMS:
            print_ratio(say, f"{threads} threads over {first}, {program}", [
                (many.results[program].speed / one.results[program].speed,
                 counts(one) and counts(many))
                for one, many in zip(rows[first], rows[threads])])
    return not wrong


def kernels(say, options):
    """us a touching pair, by the programs of bench/kernels, which compare hits and depths first."""
    folder = os.path.join(os.path.dirname(os.path.abspath(options.program)), "bench")
    path = os.path.join(options.work, "kernels.json")
    os.makedirs(options.work, exist_ok=True)
    for name in ("polyhedron_sphere", "polyhedron_polyhedron"):
        command = [os.path.join(folder, f"quern_{name}_bench"), "--benchmark_filter=overlap 1e-3",
                   f"--benchmark_repetitions={options.repeats}",
                   "--benchmark_enable_random_interleaving=true", "--benchmark_out_format=json",
                   f"--benchmark_out={path}", *(["--benchmark_min_time=0.02"] * options.small)]
        before = scene_speed.triad(options.program, 1)
        states.call(*command)
        after = scene_speed.triad(options.program, 1)
        with open(path, encoding="utf-8") as file:
            runs = [r for r in json.load(file)["benchmarks"] if r["run_type"] == "iteration"]
        say(f"\n{name}: us of processor time a touching pair, overlap 1e-3 of the radius; "
            f"triad {scene_speed.range_of([before, after])}")
        found = {}
        for run in runs:
            found.setdefault(run["name"], []).append(1e6 * run["per_pair"])
        for row, values in sorted(found.items()):
            say(f"  {row:45} {spread(values, 3)}")


def commit():
    result = subprocess.run(["git", "-C", scene_speed.ROOT, "describe", "--always", "--dirty"],
                            capture_output=True, text=True, check=False)
    return result.stdout.strip() or "unknown"


def versions():
    result = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}, ", *PEERS],
                            capture_output=True, text=True, check=False)
    return result.stdout.rstrip(", ")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--repeats", type=int, help="default: 5, of trials 2")
    parser.add_argument("--steps", type=int, help="of a run; default: by scene")
    parser.add_argument("--warm", type=int, help="steps before the timed ones; default: by scene")
    parser.add_argument("--threads", default="1", help="of quern; as many ranks of the peers")
    parser.add_argument("--small", action="store_true", help="trial sizes")
    parser.add_argument("--work", default=os.path.join(scene_speed.ROOT, "build", "bench"))
    parser.add_argument("--no-kernels", action="store_true")
    options = parser.parse_args()
    options.repeats = options.repeats or (2 if options.small else 5)
    options.threads = [int(t) for t in options.threads.split(",")]
    options.work = os.path.abspath(options.work)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("error: stopped"))  # no peer stays behind
    if scene_speed.triad(options.program, 1) is None:
        sys.exit(f"error: no quern_triad beside {options.program}; ./dev bench builds it")
    lines = []

    def say(line):
        print(line, flush=True)
        lines.append(line)

    say(f"# {scene_speed.processor()}; quern {commit()}; {versions()}")
    say(f"# ./dev bench peers {' '.join(sys.argv[2:])}".rstrip())
    agree = True
    for name in filter(None, options.scenes.split(",")):
        agree = compare(say, options, name) and agree
    if not options.no_kernels:
        kernels(say, options)
    if not options.small:
        with open(os.path.join(scene_speed.ROOT, "bench", "results", "peers.txt"), "w",
                  encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
    sys.exit(0 if agree else 1)


if __name__ == "__main__":
    main()
