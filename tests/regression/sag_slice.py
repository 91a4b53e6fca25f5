#!/usr/bin/env python3
"""The whole SAG slice: sag_slice.py QUERN SCENE OUT [KEY=VALUE ...]

Fills the mill, settles the charge and turns it for 20,000 steps, anew, with all processors. Prints the
time from the start until the charge is settled (until OUT/settled holds its state), memory for each
particle, ledger error, overlap warnings and speed. Fails if settling takes 20 minutes or more, if a
particle takes more than 1000 bytes at the peak, or if the run does not finish.
"""
import json
import os
import shutil
import subprocess
import sys
import time

STEPS = 20_000
TIME_STEP = 1e-5          # s, of the scene
LONGEST_SETTLING = 20 * 60  # s
MOST_MEMORY = 1000        # B a particle


def settled_after(process, checkpoint):
    """Seconds until the file is there; None if the run ends before."""
    started = time.monotonic()
    while not os.path.isfile(checkpoint):
        if process.poll() is not None and not os.path.isfile(checkpoint):
            return None
        time.sleep(0.2)
    return time.monotonic() - started


def main():
    quern, scene, out = sys.argv[1:4]
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    settings = [f"run.duration={STEPS * TIME_STEP}", "run.record_from=0", *sys.argv[4:]]
    command = [quern, "run", scene, "--out", out, "--threads", str(os.cpu_count())]
    for setting in settings:
        command += ["--set", setting]
    with open(os.path.join(out, "log"), "w", encoding="utf-8") as log:
        with subprocess.Popen(command, stdout=log, stderr=log) as process:
            settled = settled_after(process, os.path.join(out, "settled", "checkpoint.h5"))
    if settled is None or process.returncode != 0:
        with open(os.path.join(out, "log"), encoding="utf-8") as log:
            print(log.read()[-2000:])
        print(f"error: the run ended with {process.returncode}")
        return 1
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    memory = summary["peak_memory_B"] / summary["particles"]
    print(f"{summary['particles']} particles settled {settled:.0f} s after the start "
          f"(limit {LONGEST_SETTLING}); {summary['steps']} steps, "
          f"{summary['particle_steps_per_s'] / 1e6:.2f} million particle steps/s with "
          f"{summary['threads']} threads, {summary['rebuilds']} rebuilds, {memory:.0f} bytes a particle "
          f"(limit {MOST_MEMORY}), ledger error {summary['ledger_error']:.1e}, "
          f"overlap warnings {summary['overlap_warnings']:g}, power {summary['power_W']:.4g} W")
    right = summary["finished"] and settled < LONGEST_SETTLING and memory <= MOST_MEMORY
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
