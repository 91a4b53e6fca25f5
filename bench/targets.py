#!/usr/bin/python3
"""Every SIMD target of this CPU on the same scenes.

usage: targets.py PROGRAM [--scenes bed,sag_slice_small_sp] [--targets AVX3,AVX2,SSE4] [--threads 1]
                  [--steps 1000] [--repeats 5] [--work build/bench] [--set KEY=VALUE ...]

Each scene begins settled (kept in WORK/settled). The targets, by default all that `quern info`
lists, take turns with `quern bench --target`, which measures the triad before and after. A turn
counts if none of its triads was below 20 GB/s. All targets must find the same contacts a particle:
they differ in rounding only. Prints the speed of each and its ratio to the first, turn by turn,
with the range. Writes bench/results/simd_targets.txt; with --set, a trial, it only prints. Ends
with 1 if contacts differ.
"""

import argparse
import os
import re
import subprocess
import sys

import quern_bench
import scene_speed

CONTACTS = 0.02  # share by which targets may differ


def targets_of(program):
    said = subprocess.run([program, "info"], capture_output=True, text=True, check=True).stdout
    return re.search(r"^SIMD targets .*:(.*)$", said, re.MULTILINE)[1].split()


def take_turns(options, scene):
    """By target, what each repeat has found."""
    start = quern_bench.settled(options.program, scene, options.work, os.cpu_count() or 1,
                                options.set)
    found = {target: [] for target in options.targets}
    for _ in range(options.repeats):
        for target in options.targets:
            found[target].append(quern_bench.figures(
                options.program, quern_bench.scene_path(scene), start, threads=options.threads,
                steps=options.steps, repeats=1, target=target))
    return found


def show(say, options, scene, found):
    """Whether all targets have found the same."""
    first = found[options.targets[0]]
    contacts = {t: quern_bench.contacts(found[t][0]) for t in options.targets}
    say(f"\n{scene}: {first[0]['particles']:.0f} particles, {options.threads} threads, "
        f"{options.steps} steps a turn")
    say("  target    million particle steps/s   over the first        counted  contacts  "
        "triad, GB/s")
    all_right = True
    for target in options.targets:
        speeds = [f["particle_steps_per_s"] / 1e6 for f in found[target]]
        ratios = [(f["particle_steps_per_s"] / one["particle_steps_per_s"],
                   quern_bench.counts(f) and quern_bench.counts(one))
                  for f, one in zip(found[target], first)]
        good = [ratio for ratio, right in ratios if right]
        shown = quern_bench.spread(good or [ratio for ratio, _ in ratios])
        right = abs(contacts[target] / contacts[options.targets[0]] - 1) < CONTACTS
        all_right = all_right and right
        triads = [b for f in found[target] for b in quern_bench.triads(f)]
        say(f"  {target:9} {quern_bench.spread(speeds):25}  {shown:20}  {len(good):6}  "
            f"{contacts[target]:8.3f}  {min(triads):.1f} ... {max(triads):.1f}"
            f"{'' if right else '  DIFFERS'}")
    return all_right


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--scenes", default="bed,sag_slice_small_sp")
    parser.add_argument("--targets", help="the first is what the others are compared with")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--steps", type=int, default=1000, help="of a turn, after a tenth untimed")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--work", default=os.path.join(scene_speed.ROOT, "build", "bench"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="for trials with smaller scenes; in a WORK of their own")
    options = parser.parse_args()
    options.work = os.path.abspath(options.work)
    options.targets = (options.targets.split(",") if options.targets
                       else targets_of(options.program))
    report, all_right = quern_bench.Report(), True
    for scene in options.scenes.split(","):
        found = take_turns(options, scene)
        if not report.lines:
            report.say_where(found[options.targets[0]][0])
            report.say("# median (least ... largest) of the turns; ratios: of those that count, if "
                       "any does")
        all_right = show(report.say, options, scene, found) and all_right
    if not options.set:
        report.write("simd_targets.txt")
    sys.exit(0 if all_right else 1)


if __name__ == "__main__":
    main()
