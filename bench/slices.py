#!/usr/bin/python3
"""The small SAG slice, all spheres and with its coarse ore as polyhedra, from one steady state.

usage: slices.py PROGRAM [--work build/bench/slices] [--revolutions 1] [--steady 1] [--lead 0.5]
                 [--threads 0]

Fills and turns sag_slice_small_sp for STEADY revolutions, to whole pitches of its lifters: a run that
starts from a file has them where they are at t = 0, and they must not stand in the charge. From that state both slices turn for LEAD
revolutions, in which the charge takes up its motion again (the mill stands while spheres become
polyhedra), and REVOLUTIONS more that are recorded. Then `quern compare` writes WORK/compare.html.
What is done is used again, what was stopped goes on: run it again after an interruption.
"""
import argparse
import json
import os
import subprocess
import sys
import tomllib

import scene_speed
from quern_bench import scene_path


def finished(folder):
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["finished"]
    except FileNotFoundError:
        return False


def turn(options, name, folder, settings):
    if finished(folder):
        return
    if os.path.isfile(os.path.join(folder, "checkpoint.h5")):
        command = [options.program, "resume", folder]
    else:
        command = [options.program, "run", scene_path(name), "--out", folder]
        for setting in settings:
            command += ["--set", setting]
    if options.threads > 0:
        command += ["--threads", str(options.threads)]
    print(f"# {' '.join(command)}", flush=True)
    if subprocess.run(command, check=False).returncode != 0 or not finished(folder):
        sys.exit(f"{folder} is not finished; run this again to go on")


def whole_pitches(revolutions):
    with open(scene_path("sag_slice_small_sp"), "rb") as file:
        lifters = tomllib.load(file)["mill"]["lifters"]["count"]
    return max(1, round(revolutions * lifters)) / lifters


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--work", default="build/bench/slices")
    parser.add_argument("--revolutions", type=float, default=1)
    parser.add_argument("--steady", type=float, default=1)
    parser.add_argument("--lead", type=float, default=0.5)
    parser.add_argument("--threads", type=int, default=0)
    options = parser.parse_args()
    steady = os.path.abspath(os.path.join(options.work, "steady"))
    turn(options, "sag_slice_small_sp", steady,
         [*scene_speed.PLAIN, f"run.revolutions={whole_pitches(options.steady)}", "output.frames_every=0"])
    folders = []
    for name in ("sag_slice_small_sp", "sag_slice_small_ph"):
        folders.append(os.path.join(options.work, name))
        turn(options, name, folders[-1],
             ["run.start=file", f"run.start_file={steady}", "run.settle=none",
              f"run.revolutions={options.lead + options.revolutions}",
              f"run.record_from_revolution={options.lead}", "output.frames_every=0.1",
              "output.checkpoint_every=120"])
    page = os.path.join(options.work, "compare.html")
    subprocess.run([options.program, "compare", *folders, "--out", page], check=True)


if __name__ == "__main__":
    main()
