#!/usr/bin/python3
"""Speed of the engine on whole scenes.

usage: scene_speed.py PROGRAM [--scenes bed,sag_slice_small_sp] [--threads 1,2] [--repeats 3]
                      [--work build/bench]

Each scene is filled and settled once and kept in WORK/settled; every repeat starts from that state.
A result that is not right has no speed: contacts per particle must lie in the expected range and
the energy account must close. Prints one line a scene and number of threads: best of the repeats,
spread (worst over best), and the figures checked; ends with 1 if a check fails.
"""

import argparse
import json
import os
import platform
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Scene: seconds of the run that are timed, range of contacts per particle, largest ledger error.
SCENES = {
    "bed": (0.02, (4.0, 4.4), 5e-3),
    "sag_slice_small_sp": (0.05, (0.5, 5.0), 5e-3),
}


def run(program, scene, out, threads, settings):
    command = [program, "run", scene, "--out", out, "--threads", str(threads)]
    for setting in settings:
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(command)}\n{result.stderr}")
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def settle(program, name, work, threads):
    """Folder of the settled checkpoint of a scene, made if it is not there."""
    folder = os.path.join(work, "settled", name)
    checkpoint = os.path.join(folder, "settled", "checkpoint.h5")
    if not os.path.isfile(checkpoint):
        print(f"# settling {name} ...", flush=True)
        scene = os.path.join(ROOT, "apps", "scenes", name + ".toml")
        run(program, scene, folder, threads, ["run.duration=1e-3", "output.frames_every=0"])
    return checkpoint


def measure(program, name, work, threads, repeats):
    duration, contacts, ledger = SCENES[name]
    checkpoint = settle(program, name, work, max(threads, os.cpu_count() or 1))
    scene = os.path.join(ROOT, "apps", "scenes", name + ".toml")
    settings = [f"run.duration={duration}", "run.settle=none", "run.start=file",
                f"run.start_file={checkpoint}", "output.frames_every=0",
                f"output.series_every={duration / 10}"]
    out = os.path.join(work, "out", name)
    found = [run(program, scene, out, threads, settings) for _ in range(repeats)]
    speeds = sorted((s["particle_steps_per_s"] for s in found), reverse=True)
    last = found[-1]
    right = (contacts[0] <= last["contacts_per_particle"] <= contacts[1]
             and last["ledger_error"] < ledger)
    print(f"{name:22} {threads:2} threads  {speeds[0] / 1e6:7.2f} M particle steps/s  "
          f"spread {speeds[0] / speeds[-1]:.2f}  {last['contacts_per_particle']:.2f} contacts  "
          f"ledger {last['ledger_error']:.1e}  {last['rebuilds']} rebuilds  "
          f"{last['peak_memory_B'] / last['particles']:.0f} B/particle"
          f"{'' if right else '  NOT RIGHT'}", flush=True)
    return right, last


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
    parser.add_argument("--work", default=os.path.join(ROOT, "build", "bench"))
    options = parser.parse_args()
    print(f"# {processor()}", flush=True)
    all_right = True
    for name in options.scenes.split(","):
        for threads in options.threads.split(","):
            right, last = measure(options.program, name, os.path.abspath(options.work),
                                  int(threads), options.repeats)
            all_right = all_right and right
    print(f"# {last['simd_target']}, {last['precision']}, version {last['version']}, "
          f"commit {last['commit']}")
    sys.exit(0 if all_right else 1)


main()
