#!/usr/bin/python3
"""Speed of the engine on whole scenes.

usage: scene_speed.py PROGRAM [--scenes bed,sag_slice_small_sp] [--threads 1,2] [--repeats 3]
                      [--duration SECONDS] [--work build/bench] [--set KEY=VALUE ...]

Each scene is filled and settled once and kept in WORK/settled; every repeat starts from that state.
A result that is not right has no speed: contacts per particle must lie in the expected range and
the energy account must close. The numbers of threads take turns; just before and after each run the
bandwidth of the memory is measured (quern_triad, of the preset bench, with as many threads). Prints
one line a scene and number of threads: best of the repeats, spread (best over worst), the triad's
range and the figures checked; then, pair by pair, the speed of each further number of threads over
that of the first. Ends with 1 if a check fails.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Scene: seconds of the run that are timed, range of contacts per particle, largest ledger error.
SCENES = {
    "bed": (0.02, (4.0, 4.4), 5e-3),
    "sag_slice_small_sp": (0.05, (0.5, 5.0), 5e-3),
}
# What a scene wants to know of its collisions and its charge is left out of what is timed.
PLAIN = ("record.collisions=false", "record.charge_shape=false", "record.classes=false")


def run(program, scene, out, threads, settings):
    command = [program, "run", scene, "--out", out, "--threads", str(threads)]
    for setting in (*PLAIN, *settings):
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(command)}\n{result.stderr}")
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def triad(program, threads):
    """GB/s; None without the program that measures it."""
    measure = os.path.join(os.path.dirname(os.path.abspath(program)), "quern_triad")
    if not os.path.isfile(measure):
        return None
    return float(subprocess.run([measure, str(threads)], capture_output=True, text=True,
                                check=True).stdout)


def range_of(bandwidths):
    found = [b for b in bandwidths if b is not None]
    return f"{min(found):.1f} ... {max(found):.1f} GB/s" if found else "not measured"


def settle(program, name, work, threads, settings=()):
    """The settled checkpoint of a scene, made if it is not there."""
    folder = os.path.join(work, "settled", name)
    checkpoint = os.path.join(folder, "settled", "checkpoint.h5")
    if not os.path.isfile(checkpoint):
        print(f"# settling {name} ...", flush=True)
        scene = os.path.join(ROOT, "apps", "scenes", name + ".toml")
        run(program, scene, folder, threads,
            ["run.duration=1e-3", "run.record_from=0", "output.frames_every=0", *settings])
    return checkpoint


def go_on(program, name, work, threads, duration, settings=()):
    """The summary of a run from the settled state, in WORK/out/NAME."""
    checkpoint = settle(program, name, work, os.cpu_count() or 1, settings)
    scene = os.path.join(ROOT, "apps", "scenes", name + ".toml")
    return run(program, scene, os.path.join(work, "out", name), threads,
               [f"run.duration={duration}", "run.settle=none", "run.start=file",
                f"run.start_file={checkpoint}", "output.frames_every=0",
                f"output.series_every={duration / 10}", *settings])


def measure(options, name, all_threads):
    duration, contacts, ledger = SCENES[name]
    duration = options.duration or duration
    settle(options.program, name, options.work, os.cpu_count() or 1, options.set)
    found = {threads: [] for threads in all_threads}
    bandwidth = {threads: [] for threads in all_threads}
    for _ in range(options.repeats):
        for threads in all_threads:
            bandwidth[threads].append(triad(options.program, threads))
            found[threads].append(
                go_on(options.program, name, options.work, threads, duration, options.set))
            bandwidth[threads].append(triad(options.program, threads))
    all_right = True
    speeds = {t: [s["particle_steps_per_s"] for s in found[t]] for t in all_threads}
    for threads in all_threads:
        last = found[threads][-1]
        best, worst = max(speeds[threads]), min(speeds[threads])
        right = (contacts[0] <= last["contacts_per_particle"] <= contacts[1]
                 and last["ledger_error"] < ledger)
        all_right = all_right and right
        print(f"{name:22} {threads:2} threads  {best / 1e6:7.2f} M particle steps/s  "
              f"spread {best / worst:.2f}  triad {range_of(bandwidth[threads])}  "
              f"{last['contacts_per_particle']:.2f} contacts  "
              f"ledger {last['ledger_error']:.1e}  {last['rebuilds']} rebuilds  "
              f"{last['peak_memory_B'] / last['particles']:.0f} B/particle"
              f"{'' if right else '  NOT RIGHT'}", flush=True)
    first = all_threads[0]
    for threads in all_threads[1:]:
        ratios = [many / one for one, many in zip(speeds[first], speeds[threads])]
        print(f"{name:22} {threads:2} threads over {first}: median {statistics.median(ratios):.2f} "
              f"({', '.join(f'{r:.2f}' for r in ratios)})", flush=True)
    return all_right, last


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {len(names)} processors"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--duration", type=float, help="s; default: by scene")
    parser.add_argument("--work", default=os.path.join(ROOT, "build", "bench"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="for trials with smaller scenes; in a WORK of their own")
    options = parser.parse_args()
    options.work = os.path.abspath(options.work)
    print(f"# {processor()}", flush=True)
    all_right = True
    for name in options.scenes.split(","):
        right, last = measure(options, name, [int(t) for t in options.threads.split(",")])
        all_right = all_right and right
    print(f"# {last['simd_target']}, {last['precision']}, version {last['version']}, "
          f"commit {last['commit']}")
    sys.exit(0 if all_right else 1)


if __name__ == "__main__":
    main()
