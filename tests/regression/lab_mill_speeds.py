#!/usr/bin/env python3
"""The lab mill at several speeds: power, shoulder and toe, the energy account, pictures.

usage: lab_mill_speeds.py QUERN SCENE OUT [--speeds 10,20,30,40,50,60] [--steady 20] [--record 10]
                          [--pictures 10,30,60] [--set KEY=VALUE ...]

Turns for `steady` seconds, then records for `record` seconds; two runs at a time, each in OUT/<rpm>rpm.
A run that was stopped goes on, a finished one is not repeated. Prints a table and fails if shoulder or
toe falls from one speed to the next by more than twice the standard error of the difference, if they
do not rise over the whole range, or if a ledger error exceeds 1e-3. Pictures need ParaView.
"""
import argparse
import math
import os
import subprocess
import sys

import runs

LEDGER = 1e-3


def numbers(text):
    return [float(part) for part in text.split(",") if part]


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("quern")
    parser.add_argument("scene")
    parser.add_argument("out")
    parser.add_argument("--speeds", type=numbers, default=[10, 20, 30, 40, 50, 60])
    parser.add_argument("--steady", type=float, default=20)
    parser.add_argument("--record", type=float, default=10)
    parser.add_argument("--pictures", type=numbers, default=[10, 30, 60])
    parser.add_argument("--set", action="append", default=[])
    return parser.parse_args()


def settings_of(rpm, args):
    frames = max(args.record / 20, 0.01)
    return [f"mill.rotation={rpm:g} rpm", f"run.duration={args.steady + args.record:g} s",
            f"run.record_from={args.steady:g} s", "record.charge_shape=true",
            f"output.frames_every={frames:g} s", *args.set]


def known(summary, name):
    return math.nan if summary.get(name) is None else summary[name]


def print_table(found):
    print(f"{'rpm':>5} {'power W':>17} {'shoulder deg':>14} {'toe deg':>14} {'ledger error':>13} "
          f"{'model work':>11} {'contacts':>9} {'steps/s':>8}")
    for rpm, s in found.items():
        row = f"{rpm:5g} {known(s, 'power_W'):9.4f} +- {known(s, 'power_W_standard_error'):.4f}"
        for name in ("shoulder_deg", "toe_deg"):
            row += f" {known(s, name):7.1f} +- {known(s, name + '_standard_error'):3.1f}"
        rate = s["particle_steps_per_s"] / s["particles"]
        row += (f" {s['ledger_error']:13.1e} {known(s, 'model_work_share'):+11.1e}"
                f" {s['contacts_per_particle']:9.3f} {rate:8.0f}")
        print(row)


def rises(found, name):
    """Whether an angle rises with speed, within its errors; NaN does not."""
    angles = [(known(s, name), known(s, name + "_standard_error")) for s in found.values()]
    good = True
    for (low, low_error), (high, high_error) in zip(angles, angles[1:]):
        good = good and high - low > -2 * math.hypot(low_error, high_error)
    (first, first_error), (last, last_error) = angles[0], angles[-1]
    return good and last - first > 2 * math.hypot(first_error, last_error)


def draw(folder, particles):
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "paraview_frames.sh")
    code = subprocess.run([script, folder, str(particles)], stdout=subprocess.DEVNULL,
                          check=False).returncode
    said = {0: f"{folder}/frames.png", 77: "no picture: ParaView or Xvfb is not installed"}
    print(said.get(code, f"{folder}: the picture failed"))
    return code in said


def main():
    args = parse()
    folders = {rpm: os.path.join(args.out, f"{rpm:g}rpm") for rpm in sorted(args.speeds)}
    found = runs.run_all(args.quern, args.scene, {
        rpm: (folder, settings_of(rpm, args)) for rpm, folder in folders.items()})
    print_table(found)
    good = True
    for name in ("shoulder_deg", "toe_deg"):
        if len(found) > 1 and not rises(found, name):
            print(f"{name} does not rise with speed")
            good = False
    for rpm, summary in found.items():
        if not summary["ledger_error"] < LEDGER:
            print(f"{rpm:g} rpm: the energy account is not closed")
            good = False
    for rpm in args.pictures:
        if rpm in folders:
            good = draw(folders[rpm], found[rpm]["particles"]) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
