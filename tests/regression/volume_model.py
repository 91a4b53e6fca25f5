#!/usr/bin/env python3
"""The energy-conserving reference in the lab mill: volume_model.py QUERN SCENE OUT [SECONDS] [KEY=VALUE ...]

Settles the charge with the scene's own law, then turns it for SECONDS (default 1) with
normal_model = "volume", k_V = 3e4 Pa, in steps of 1e-6 s. What is finished in OUT is not repeated.
Prints what the normal forces did beyond the change of their potential, over the dissipation: it is to
be below 1e-4, where the default law has some percent. The force of a flat face jumps to k_V times its
area at the first touch; stiffer faces take shorter steps (share about (k_V dt^1.4)^2).
"""
import os
import sys

import runs

LIMIT = 1e-4


def main():
    quern, scene, out = sys.argv[1:4]
    seconds = sys.argv[4] if len(sys.argv) > 4 else "1"
    settled = os.path.join(out, "settled")
    runs.run_once(quern, scene, settled, ["run.duration=0.001 s", "run.record_from=0 s"])
    summary = runs.run_once(quern, scene, os.path.join(out, "turned"), [
        "run.start=file", f"run.start_file={os.path.abspath(settled)}/settled",
        "contact.normal_model=volume", "contact.volume_stiffness=3e4 Pa", "run.time_step=1e-6 s",
        f"run.duration={seconds} s", "run.record_from=0 s", "output.frames_every=0", *sys.argv[5:]])
    share = summary["model_work_share"]
    print(f"{summary['time_s']:g} s turned, {summary['contacts_per_particle']:.2f} contacts a particle: "
          f"dissipation {summary['dissipation_J']:.4g} J, model work {summary['model_work_J']:.3g} J, "
          f"share {share:.2g}; ledger error {summary['ledger_error']:.1g}")
    return 0 if abs(share) < LIMIT and summary["ledger_error"] < 1e-3 else 1


if __name__ == "__main__":
    sys.exit(main())
