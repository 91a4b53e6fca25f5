#!/usr/bin/env python3
"""Whether the energy account of a whole run closes: ledger.py QUERN SCENE OUT LIMIT [KEY=VALUE ...]

Runs the scene anew with these settings and all processors. Prints what the walls put in, what was
dissipated, the account's error and the numerical loss; fails if the run does not finish or if the
error is not below LIMIT.
"""
import os
import shutil
import sys

import runs

TOLD = ("precision", "steps", "power_W", "wall_work_J", "dissipation_J", "ledger_error",
        "numerical_loss", "overlap_warnings")


def main():
    quern, scene, out, limit = sys.argv[1:5]
    shutil.rmtree(out, ignore_errors=True)  # never what another build left
    summary = runs.run_once(quern, scene, out, sys.argv[5:], threads=os.cpu_count())
    print(", ".join(f"{name} {summary[name]}" for name in TOLD) + f"; limit of the error {limit}")
    return 0 if summary["finished"] and summary["ledger_error"] < float(limit) else 1


if __name__ == "__main__":
    sys.exit(main())
