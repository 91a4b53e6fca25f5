#!/usr/bin/python3
"""Scaling with threads, beside what the serial share of one thread predicts.

usage: scaling.py PROGRAM SCENE ... [--threads 1,2,4,8,16] [--repeats 3] [--steps 1000]
                  [--work build/bench] [--set KEY=VALUE ...]

Needs PROGRAM, this folder, apps/scenes and Python alone, so that it runs on a machine with many
cores that has nothing else. A SCENE is a name in apps/scenes. It is settled with the most threads
(kept in WORK/settled; sag_slice_sp takes a quarter of an hour on two). Then the numbers of threads
take turns with `quern bench`, which measures the triad with as many threads before and after. All
must find the same contacts, lists and energy to the last bit. Prints, by number of threads: speed,
its ratio to one thread turn by turn and that over the threads, the serial share of a step as
measured there, what Amdahl's law makes of the serial share of one thread, and the same if each
thread takes whole tasks. Writes bench/results/scaling.txt; with --set, a trial, it only prints.
Ends with 1 if a result differs.

--set is for smaller scenes and shorter settling (run.settle=0.2); in a WORK of its own.
"""

import argparse
import math
import os
import statistics
import sys

import quern_bench
import scene_speed

# Figures of a run that no number of threads may change.
SAME = (["ledger_error", "sphere_pairs_slots", "steps_between_rebuilds", "tasks"]
        + [f"{kind}_{what}" for kind in quern_bench.KINDS for what in ("listed", "touching")])


def take_turns(options, scene):
    """By number of threads, what each repeat has found."""
    start = quern_bench.settled(options.program, scene, options.work, max(options.threads),
                                options.set)
    found = {threads: [] for threads in options.threads}
    for _ in range(options.repeats):
        for threads in options.threads:
            found[threads].append(quern_bench.figures(
                options.program, quern_bench.scene_path(scene), start, threads=threads,
                steps=options.steps, repeats=1))
    return found


def differences(found):
    """(threads, figure) of all that is not as in the first turn."""
    first = next(iter(found.values()))[0]
    return sorted({(threads, key) for threads, turns in found.items() for turn in turns
                   for key in SAME if turn[key] != first[key]})


def speed_up(serial, threads):
    return 1 / (serial + (1 - serial) / threads)


def show(say, options, scene, found):
    """Whether all have found the same."""
    one = found[1]
    serial = statistics.median(f["serial_fraction"] for f in one)
    tasks = one[0]["tasks"]
    say(f"\n{scene}: {one[0]['particles']:.0f} particles, {options.steps} steps a turn, "
        f"{one[0]['simd_target']}, {quern_bench.contacts(one[0]):.3f} contacts a particle, "
        f"{tasks:.0f} tasks a step")
    say("  threads  million particle steps/s  over one thread       efficiency  serial, %  Amdahl  "
        "in tasks  triad, GB/s")
    for threads, turns in found.items():
        speeds = [f["particle_steps_per_s"] / 1e6 for f in turns]
        ratios = [f["particle_steps_per_s"] / o["particle_steps_per_s"]
                  for f, o in zip(turns, one)]
        triads = [b for f in turns for b in quern_bench.triads(f)]
        own = 100 * statistics.median(f["serial_fraction"] for f in turns)
        say(f"  {threads:7}  {quern_bench.spread(speeds):24}  {quern_bench.spread(ratios):20}  "
            f"{statistics.median(ratios) / threads:10.2f}  {own:9.2f}  "
            f"{speed_up(serial, threads):6.2f}  "
            f"{speed_up(serial, tasks / math.ceil(tasks / threads)):8.2f}  "
            f"{min(triads):.1f} ... {max(triads):.1f}")
    wrong = differences(found)
    for threads, key in wrong:
        say(f"  NOT RIGHT: {key} differs with {threads} threads")
    return not wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="+", metavar="scene")
    parser.add_argument("--threads", help="default: 1, 2, 4 ... up to the processors",
                        default=",".join(str(2**k) for k in range(os.cpu_count().bit_length())))
    parser.add_argument("--steps", type=int, default=1000, help="of a turn, after a tenth untimed")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--work", default=os.path.join(scene_speed.ROOT, "build", "bench"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="for trials: smaller scenes, shorter settling")
    options = parser.parse_args()
    options.work = os.path.abspath(options.work)
    options.threads = sorted({1, *(int(t) for t in options.threads.split(","))})
    report, all_right = quern_bench.Report(), True
    for scene in options.scenes:
        found = take_turns(options, scene)
        if not report.lines:
            report.say_where(found[1][0])
            report.say("# median (least ... largest)")
        all_right = show(report.say, options, scene, found) and all_right
    if not options.set:
        report.write("scaling.txt")
    sys.exit(0 if all_right else 1)


if __name__ == "__main__":
    main()
