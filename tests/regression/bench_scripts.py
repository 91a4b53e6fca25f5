#!/usr/bin/python3
"""The scripts of bench/ that run `quern bench`, on a mill of 380 spheres; what they call wrong.

usage: QUERN_PROGRAM=build/release/quern bench_scripts.py [CLASS ...]
"""

import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

PROGRAM = os.path.abspath(os.environ["QUERN_PROGRAM"])
BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(BENCH))
import cost_against_size  # noqa: E402
import quern_bench  # noqa: E402
import scaling  # noqa: E402
import targets  # noqa: E402


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="quern_bench_")
        self.addCleanup(folder.cleanup)
        self.work = folder.name
        # Of a vector of f32 with half of its lanes empty (SSE4) the rest may divide zero by zero.
        untrapped = {k: v for k, v in os.environ.items() if k != "QUERN_TRAP_FP"}
        patch = unittest.mock.patch.dict(os.environ, untrapped, clear=True)
        patch.start()
        self.addCleanup(patch.stop)

    def script(self, name, *words):
        """What a trial prints of the mill."""
        result = subprocess.run(
            [sys.executable, BENCH / name, PROGRAM, *words, "--steps", "200", "--repeats", "2",
             "--work", self.work, "--set", "run.settle=0.01", "--set", "run.tile_size=64"],
            capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout


# What a turn has found.
TURN = {**{key: 1.5 for key in scaling.SAME}, "particles": 10, "particle_steps_per_s": 1e7,
        "serial_fraction": 0.1, "simd_target": "AVX2", "triad_before_B_per_s": 25e9,
        "triad_after_B_per_s": 25e9, "bytes": 500, "tasks": 32}


class Scaling(Case):
    def test_prints_a_row_for_each_number_of_threads(self):
        said = self.script("scaling.py", "lab_mill_spheres", "--threads", "1,2")
        self.assertEqual(re.findall(r"^ +(\d+)  [0-9.]+ \(", said, re.MULTILINE), ["1", "2"])
        self.assertIn("1.00 (1.00 ... 1.00)", said)  # one thread over one thread

    def test_wants_the_same_to_the_last_bit(self):
        other = {**TURN, "sphere_pairs_touching": 1.5 * (1 + 1e-15)}
        self.assertEqual(scaling.differences({1: [TURN, TURN], 2: [TURN, TURN]}), [])
        self.assertEqual(scaling.differences({1: [TURN, TURN], 2: [TURN, other]}),
                         [(2, "sphere_pairs_touching")])

    def test_predicts_by_amdahls_law(self):
        self.assertEqual(scaling.speed_up(0, 16), 16)
        self.assertEqual(scaling.speed_up(1, 16), 1)
        self.assertAlmostEqual(scaling.speed_up(0.25, 3), 2)


class Targets(Case):
    def test_prints_a_row_for_each_target(self):
        said = self.script("targets.py", "--scenes", "lab_mill_spheres")
        rows = re.findall(r"^  ([A-Z0-9_]+) +[0-9.]+ \(", said, re.MULTILINE)
        self.assertEqual(rows, targets.targets_of(PROGRAM))

    def show(self, second):
        lines = []
        options = unittest.mock.Mock(targets=["AVX3", "AVX2"], threads=1, steps=10)
        right = targets.show(lines.append, options, "bed", {"AVX3": [TURN], "AVX2": [second]})
        return right, lines[-1]

    def test_wants_the_same_contacts(self):
        self.assertTrue(self.show({**TURN, "sphere_pairs_touching": 1.51})[0])
        right, row = self.show({**TURN, "sphere_pairs_touching": 1.8})
        self.assertFalse(right)
        self.assertIn("DIFFERS", row)

    def test_counts_only_while_the_memory_is_free(self):
        slow = {**TURN, "particle_steps_per_s": 5e6}
        self.assertRegex(self.show(slow)[1], r" 0\.50 \(0\.50 \.\.\. 0\.50\) +1 ")
        self.assertRegex(self.show({**slow, "triad_after_B_per_s": 15e9})[1], r"0\.50\) +0 ")


class Size(Case):
    def test_repeats_a_column(self):
        with unittest.mock.patch.multiple(cost_against_size, COLUMN=500, STIR=1e-3):
            scene = cost_against_size.scene_of(PROGRAM, "gas", (2, 2), self.work)
            side = cost_against_size.FAMILIES["gas"].side
        with open(scene.replace(".toml", ".csv"), encoding="utf-8") as file:
            rows = [[float(row[key]) for key in ("x", "y", "z", "vx")]
                    for row in csv.DictReader(file)]
        self.assertEqual(len(rows), 2000)
        for k, (i, j) in enumerate([(0, 0), (0, 1), (1, 0), (1, 1)]):
            for first, copy in zip(rows[:500], rows[500 * k:500 * (k + 1)]):
                moved = [first[0] + i * side, first[1] + j * side, *first[2:]]
                for a, b in zip(moved, copy):  # twelve digits are written
                    self.assertAlmostEqual(a, b, delta=1e-11)
        found = quern_bench.figures(PROGRAM, scene, [], threads=1, steps=1000, repeats=1)
        self.assertEqual(found["particles"], 2000)

    def test_wants_the_same_contacts_at_all_sizes(self):
        lines, family = [], cost_against_size.FAMILIES["equal"]
        sizes = {10_000: [TURN], 20_000: [TURN], 40_000: [{**TURN, "particle_steps_per_s": 5e6}]}
        self.assertTrue(cost_against_size.show(lines.append, family, sizes))
        self.assertIn(" 2.00 ", lines[-1])  # 40k over 20k
        sizes[20_000] = [{**TURN, "sphere_pairs_touching": 1.9}]
        self.assertFalse(cost_against_size.show(lines.append, family, sizes))


if __name__ == "__main__":
    unittest.main()
