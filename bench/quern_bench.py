"""`quern bench` as the scripts here run it, and what they print and keep.

Needs the program and Python alone. The program itself refuses a result that is not right: a fatal
bit, an open energy account, nothing that touches.
"""

import json
import os
import statistics
import subprocess
import sys

import scene_speed

LEAST_TRIAD = 20  # GB/s; with less, other jobs have the memory
PAIRS = ("sphere_pairs", "polyhedron_spheres", "polyhedron_pairs")
KINDS = (*PAIRS, "sphere_walls", "polyhedron_walls")


def figures(program, scene, settings, **options):
    """What `quern bench --json` prints; options: threads, steps, repeats, target."""
    command = [program, "bench", scene, "--json"]
    for key, value in options.items():
        command += [f"--{key}", str(value)]
    for setting in settings:
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(command)}\n{result.stderr[-2000:]}")
    return json.loads(result.stdout)


def scene_path(name):
    return os.path.join(scene_speed.ROOT, "apps", "scenes", name + ".toml")


def settled(program, name, work, threads, settings=()):
    """Settings with which a scene begins settled; its state is made in WORK if it is not there."""
    checkpoint = scene_speed.settle(program, name, work, threads, settings)
    return [*settings, "run.duration=1", "run.record_from=0", "run.settle=none", "run.start=file",
            f"run.start_file={checkpoint}"]


def triads(found):
    """GB/s before and after."""
    return [1e-9 * found[f"triad_{when}_B_per_s"] for when in ("before", "after")]


def counts(found):
    return min(triads(found)) >= LEAST_TRIAD


def contacts(found):
    """Touching particles a particle, walls not counted."""
    return 2 * sum(found[kind + "_touching"] for kind in PAIRS)


def spread(values):
    return f"{statistics.median(values):.2f} ({min(values):.2f} ... {max(values):.2f})"


def result_path(name):
    folder = os.path.join(scene_speed.ROOT, "bench", "results")
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name)


class Report:
    """Lines for the screen, and for a file of bench/results."""

    def __init__(self):
        self.lines = []

    def say(self, line):
        print(line, flush=True)
        self.lines.append(line)

    def say_where(self, found):
        """The machine, what ran on it, and how."""
        self.say(f"# {scene_speed.processor()}; quern {found['version']}, "
                 f"commit {found['commit']}, {found['precision']}")
        script = os.path.relpath(os.path.abspath(sys.argv[0]), scene_speed.ROOT)
        self.say(f"# {' '.join([script, *sys.argv[1:]])}")

    def write(self, name):
        with open(result_path(name), "w", encoding="utf-8") as file:
            file.write("\n".join(self.lines) + "\n")
