#!/usr/bin/python3
"""Throughput of a sweep: 12 cases of the laboratory mill on all cores against one after another.

usage: sweep_throughput.py QUERN [ROUNDS] [SECONDS]

The same sweep (4 face angles, 3 speeds, SECONDS of the mill, default 2) with the width that quern
chooses and with --at-once 1 --threads 1, in turn; filling included. The tables must be the same
bytes. Prints each round, and the ratio of the best times.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

SCENE = pathlib.Path(__file__).resolve().parents[1] / "apps/scenes/lab_mill_spheres.toml"
SWEEP = """format = 1
scene = "%s"
[set]
run.duration = "%s s"
run.record_from = "%s s"
[[factors]]
key = "mill.lifters.face_angle"
values = ["0 deg", "15 deg", "30 deg", "45 deg"]
[[factors]]
key = "mill.rotation"
values = ["20 rpm", "30 rpm", "40 rpm"]
"""


def timed(quern, sweep, out, *more):
    began = time.monotonic()
    result = subprocess.run([quern, "sweep", sweep, "--out", out, *more], check=True,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    seconds = time.monotonic() - began
    width = [line for line in result.stdout.splitlines() if line.startswith("width")]
    return seconds, (out / "sweep.csv").read_bytes(), width[0] if width else ""


def main():
    quern = str(pathlib.Path(sys.argv[1]).resolve())
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 2
    best = {"all": float("inf"), "one": float("inf")}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        sweep = folder / "sweep.toml"
        sweep.write_text(SWEEP % (SCENE, seconds, seconds / 2), encoding="utf-8")
        for k in range(rounds):
            wide, table, width = timed(quern, sweep, folder / f"all_{k}")
            one, same, _ = timed(quern, sweep, folder / f"one_{k}", "--at-once", "1", "--threads", "1")
            if table != same:
                sys.exit("the tables differ")
            best = {"all": min(best["all"], wide), "one": min(best["one"], one)}
            print(f"round {k + 1}: as chosen {wide:.1f} s, one after another {one:.1f} s, "
                  f"{one / wide:.2f} times; {width}", flush=True)
    print(f"best times: {best['one'] / best['all']:.2f} times the throughput")


if __name__ == "__main__":
    main()
