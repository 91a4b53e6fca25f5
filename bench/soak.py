#!/usr/bin/python3
"""A soak: the small SAG slice turns for as long as wanted; is the ledger error flat, and the memory?

usage: soak.py PROGRAM [--minutes 15] [--steady FOLDER] [--work build/bench/soak] [--threads 1]

Starts from a steady state (that of slices.py, made here if FOLDER has none), records collisions, wear,
classes and maps, writes frames and a checkpoint a minute, and ends the run by SIGTERM; run again it
goes on. Samples memory and the size of the folder every five seconds. Writes results/soak.txt and
results/soak.svg: ledger error and memory over the turns, with the slopes of straight lines through the
second half, after which the ledger and lists have found their level.
"""
import argparse
import json
import os
import signal
import subprocess
import sys
import time
import tomllib

import h5py
import numpy as np

import scene_speed
import slices
from quern_bench import scene_path

RESULTS = os.path.join(scene_speed.ROOT, "bench", "results")
SETTINGS = ["run.settle=none", "run.start=file", "run.revolutions=100000", "run.record_from=0",
            "record.collisions=true", "record.classes=true", "record.charge_shape=true",
            "record.snapshots_every=0.1", "wear.flow_pressure=5e9", "output.series_every=0.01",
            "output.frames_every=1", "output.checkpoint_every=60"]
EVERY = 5  # s


def command_of(options):
    if os.path.isfile(os.path.join(options.work, "checkpoint.h5")):
        command = [options.program, "resume", options.work]
    else:
        settings = [*SETTINGS, f"run.start_file={options.steady}"]
        command = [options.program, "run", scene_path("sag_slice_small_sp"), "--out", options.work]
        command += [text for setting in settings for text in ("--set", setting)]
    return command + ["--threads", str(options.threads)]


def memory_of(process):
    """MB of the process that lie in memory now."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as file:
        for line in file:
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) * 1024e-6
    return float("nan")


def series(folder, name):
    with h5py.File(os.path.join(folder, "run.h5"), "r") as file:
        return file["series"][name][:]


def last_time(folder):
    """Mill time of the last row, s; None while the file is being written."""
    try:
        times = series(folder, "time")
        return float(times[-1]) if len(times) and np.isfinite(times[-1]) else None
    except (OSError, KeyError):
        return None


def soak(options, samples):
    """Appends (mill time, MB) while the program runs."""
    process = subprocess.Popen(command_of(options), stdout=subprocess.DEVNULL)
    end = time.monotonic() + 60 * options.minutes
    while process.poll() is None and time.monotonic() < end:
        time.sleep(EVERY)
        at = last_time(options.work)
        if at is not None and process.poll() is None:
            samples.append((at, memory_of(process)))
    if process.poll() is None:
        process.send_signal(signal.SIGTERM)
    if process.wait() != 0:
        sys.exit(f"error: the run ended with {process.returncode}")


def rate_of_turning():
    """Turns a second."""
    with open(scene_path("sag_slice_small_sp"), "rb") as file:
        return float(tomllib.load(file)["mill"]["rotation"].split()[0]) / 60


def slope(x, y):
    """Of a straight line through the second half, with its standard error."""
    half = x >= 0.5 * (x[0] + x[-1])
    (rise, _), covariance = np.polyfit(x[half], y[half], 1, cov=True)
    return rise, np.sqrt(covariance[0, 0])


def draw(turns, error, memory_turns, memory):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "quern"
    import matplotlib.pyplot as plt
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained")
    above.semilogy(turns, np.maximum(error, 1e-16), linewidth=0.6)
    above.set_ylabel("ledger error")
    below.plot(memory_turns, memory, ".", markersize=3)
    below.set_ylim(bottom=0)
    below.set_ylabel("memory, MB")
    below.set_xlabel("turns of the mill")
    figure.savefig(os.path.join(RESULTS, "soak.svg"), metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--minutes", type=float, default=15)
    parser.add_argument("--steady", default="build/bench/slices/steady")
    parser.add_argument("--work", default="build/bench/soak")
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    options.steady = os.path.abspath(options.steady)
    slices.turn(options, "sag_slice_small_sp", options.steady,
                [*scene_speed.PLAIN, f"run.revolutions={slices.whole_pitches(1)}",
                 "output.frames_every=0"])
    kept = os.path.join(options.work, "samples.json")
    samples = []
    if os.path.isfile(kept):
        with open(kept, encoding="utf-8") as file:
            samples = json.load(file)
    soak(options, samples)
    with open(kept, "w", encoding="utf-8") as file:
        json.dump(samples, file)
    with open(os.path.join(options.work, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    turn = rate_of_turning()
    turns, error = turn * series(options.work, "time"), series(options.work, "ledger_error")
    at, memory = np.array(samples).T
    growth, of_growth = slope(at * turn, memory)
    drift, of_drift = slope(turns, error)
    folder = sum(os.path.getsize(os.path.join(path, name))
                 for path, _, names in os.walk(options.work) for name in names)
    lines = [
        f"# bench/soak.py, quern {summary['version']}, commit {summary['commit']}, "
        f"{summary['precision']}, {summary['threads']} threads, {summary['simd_target']}",
        f"sag_slice_small_sp, {summary['particles']} spheres: {turns[-1]:.2f} turns, "
        f"{summary['steps']} steps, everything recorded",
        f"ledger error   {error[-1]:.1e} at the end, {np.max(error):.1e} at most; "
        f"{drift:.1e} +- {of_drift:.0e} a turn",
        f"memory         {memory[0]:.1f} MB at first, {memory[-1]:.1f} MB at the end, "
        f"{np.max(memory):.1f} MB at most; {growth:.2f} +- {of_growth:.2f} MB a turn",
        f"numerical loss {summary['numerical_loss']:.1e}, deep contacts "
        f"{summary['overlap_warnings']}; folder {folder * 1e-6:.0f} MB"]
    print("\n".join(lines))
    with open(os.path.join(RESULTS, "soak.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    draw(turns, error, at * turn, memory)


if __name__ == "__main__":
    main()
