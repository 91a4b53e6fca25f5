#!/usr/bin/env python3
"""The lab mill against an independent solver: lab_reference.py QUERN SCENE GOLDEN.json OUT [SEEDS]

Runs the scene with seeds 1 ... SEEDS (default 8; none is dropped), prints the mean over seeds beside
the reference with the standard error of each, and fails if a figure is neither within its band
(power 1 %, kinetic energy 2 %, contacts 2 %, centre 0.5 mm) nor within two combined standard errors.
"""
import json
import math
import os
import subprocess
import sys

BANDS = {  # name: (relative, absolute)
    "power_W": (0.01, 0),
    "kinetic_energy_J": (0.02, 0),
    "rotational_energy_J": (0.02, 0),
    "contacts_per_particle": (0.02, 0),
    "center_of_mass_x_m": (0, 0.5e-3),
    "center_of_mass_y_m": (0, 0.5e-3),
}


def run_seed(quern, scene, out, seed):
    folder = os.path.join(out, f"seed{seed}")
    subprocess.run(
        [quern, "run", scene, "--out", folder, "--threads", "1", "--set", f"run.seed={seed}"],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def mean_and_error(values):
    n = len(values)
    mean = sum(values) / n
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / (n - 1) / n)


def main():
    quern, scene, golden, out = sys.argv[1:5]
    seeds = int(sys.argv[5]) if len(sys.argv) > 5 else 8
    with open(golden, encoding="utf-8") as file:
        reference = json.load(file)
    runs = [run_seed(quern, scene, out, seed) for seed in range(1, seeds + 1)]
    print(f"{seeds} seeds; quern {runs[0]['version']} {runs[0]['commit']}, {runs[0]['simd_target']}")
    print(f"{'figure':24} {'quern':>12} {'+-':>9} {'reference':>12} {'+-':>9} {'difference':>12} sigma")
    good = True
    for name, (relative, absolute) in BANDS.items():
        mean, error = mean_and_error([run[name] for run in runs])
        want, want_error = reference[name]["mean"], reference[name]["se"]
        difference = mean - want
        sigma = abs(difference) / math.hypot(error, want_error)
        band = relative * abs(want) + absolute
        fine = abs(difference) <= band or sigma <= 2
        good = good and fine
        shown = f"{100 * difference / want:+.2f} %" if relative else f"{1e3 * difference:+.3f} mm"
        print(f"{name:24} {mean:12.6g} {error:9.2g} {want:12.6g} {want_error:9.2g} {shown:>12} "
              f"{sigma:5.2f} {'' if fine else 'OUTSIDE'}")
    worst = max(run["ledger_error"] for run in runs)
    print(f"largest ledger error {worst:.1e}, numerical loss {runs[0]['numerical_loss']:.1e}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
