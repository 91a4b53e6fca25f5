#!/usr/bin/python3
"""`quern sweep` from outside: mistakes, the plan, shared fillings, a failed case, kill and resume.

usage: QUERN_PROGRAM=build/release/quern sweep_test.py [TEST]
"""

import csv
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import h5py

PROGRAM = os.environ["QUERN_PROGRAM"]
SCENE = pathlib.Path(__file__).resolve().parents[2] / "apps/scenes/lab_mill_spheres.toml"
SET = """
[set]
run.settle = "0.02 s"
run.duration = "0.06 s"
run.record_from = "0.02 s"
particles.ore.count = 20
particles.ball.count = 10
output.series_every = "1 ms"
output.frames_every = "20 ms"
output.checkpoint_every = "0.02 s"
"""
HEAD = 'format = 1\nscene = "%s"\n' % SCENE
SPEED = '[[factors]]\nkey = "mill.rotation"\nvalues = ["20 rpm", "30 rpm", "40 rpm"]\n'
ANGLE = '[[factors]]\nkey = "mill.lifters.face_angle"\nvalues = ["10 deg", "20 deg"]\n'
WIDTH = ("--at-once", 2, "--threads", 1)


def alive(pattern):
    """Processes whose command line names the folder."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            command = (entry / "cmdline").read_bytes().decode(errors="replace")
            state = (entry / "stat").read_text().rsplit(")", 1)[1].split()[0]
        except OSError:
            continue
        if pattern in command and state != "Z":
            found.append((int(entry.name), command.split("\0")))
    return found


class SweepCase(unittest.TestCase):
    """A sweep's file and folder, and what is asked of them."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="quern_sweep_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.file = self.folder / "sweep.toml"
        self.out = self.folder / "out"

    def write(self, *parts):
        self.file.write_text("".join(parts), encoding="utf-8")

    def command(self, *more, out=None):
        return [PROGRAM, "sweep", str(self.file), "--out", str(out or self.out), *map(str, more)]

    def sweep(self, *more, code=0, out=None):
        result = subprocess.run(self.command(*more, out=out), capture_output=True, text=True,
                                timeout=250, check=False)
        self.assertEqual(code, result.returncode, result.stdout + result.stderr)
        return result

    def rows(self, out=None):
        with open((out or self.out) / "sweep.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))


class Sweep(SweepCase):
    def test_mistakes_name_the_place_in_the_sweep(self):
        self.write(HEAD, '[[factors]]\nkey = "mill.rotation"\nvalues = ["20 rpm", "30 rmp"]\n',
                   '[[factors]]\nkey = "mill.lifters.hight"\nvalues = ["10 mm"]\n')
        errors = self.sweep(code=2).stderr
        self.assertIn(f"{self.file}:5:21: error: mill.rotation=30 rmp: 'rotation': unit 'rmp'", errors)
        self.assertIn(f"{self.file}:8:11: error: mill.lifters.hight=10 mm: unknown key 'hight' - "
                      "did you mean 'height'?", errors)
        self.assertFalse(self.out.exists())

    def test_plan_runs_nothing(self):
        self.write(HEAD, "replicates = 2\n", SET, ANGLE, SPEED)
        text = self.sweep("--plan").stdout
        self.assertIn("12, 0 of them finished; 4 fillings", text)
        self.assertRegex(text, r"time +about \d+:\d\d for all cases")
        self.assertRegex(text, r"disk +about 0\.0\d+ GB")
        self.assertRegex(text, r"width +\d+ at a time, \d+ threads each \(particle steps measured: ")
        self.assertIn("   12  face_angle_20deg_rotation_40rpm_seed_2", text)
        self.assertEqual([], [p for p in self.out.rglob("*") if p.is_file()])

    def test_cases_that_differ_in_speed_share_a_filling(self):
        self.write(HEAD, SET, ANGLE, SPEED)
        self.sweep(*WIDTH)
        fillings = [p for p in (self.out / "fillings").iterdir() if p.is_dir()]
        self.assertEqual(2, len(fillings))
        rows = self.rows()
        self.assertEqual(6, len(rows))
        self.assertEqual(["finished"] * 6, [row["status"] for row in rows])
        starts = {}
        for row in rows:
            text = (self.out / row["case"] / "scene.toml").read_text(encoding="utf-8")
            start = [line for line in text.splitlines() if line.startswith("start_file")][0]
            starts.setdefault(start, []).append(row["mill.lifters.face_angle [deg]"])
            summary = json.loads((self.out / row["case"] / "summary.json").read_text())
            self.assertEqual(float(row["power_W"]), summary["power_W"])
            self.assertEqual(float(row["power_W_standard_error"]), summary["power_W_standard_error"])
            self.assertTrue((self.out / row["case"] / "report.html").is_file())
        self.assertEqual([["10"] * 3, ["20"] * 3], sorted(starts.values()))
        with h5py.File(self.out / "sweep.h5") as file:
            self.assertEqual([float(row["power_W"]) for row in rows],
                             list(file["responses/power_W"][:]))
            self.assertEqual([20, 30, 40] * 2, list(file["factors/mill.rotation"][:]))
            self.assertEqual("rpm", file["factors/mill.rotation"].attrs["unit"].decode())
        self.one_case_alone(rows[4])

    def one_case_alone(self, row):
        """By its number, in another folder: the same run, and nothing but it."""
        out = self.folder / "alone"
        self.sweep("--case", 5, "--threads", 1, out=out)
        self.assertEqual({"fillings", row["case"]}, {p.name for p in out.iterdir()})
        summary = json.loads((out / row["case"] / "summary.json").read_text())
        self.assertEqual(float(row["power_W"]), summary["power_W"])

    def test_a_case_that_goes_wrong_is_tried_twice_and_the_others_go_on(self):
        # Springs so soft that what falls goes through: an overlap of a radius.
        self.write(HEAD, SET.replace("[set]", '[set]\nrun.time_step = "1e-5 s"\n'),
                   '[[factors]]\nkey = "contact.normal_stiffness"\nvalues = ["1e5 N/m", "0.1 N/m"]\n')
        result = self.sweep(*WIDTH, code=4)
        self.assertEqual(1, result.stderr.count("; once more"), result.stderr)
        rows = self.rows()
        self.assertEqual("finished", rows[0]["status"])
        self.assertRegex(rows[1]["status"], "^failed: .*overlap")
        self.assertIn("1 of 2 finished, 1 failed", result.stdout)

    def test_a_case_that_was_killed_is_done_again(self):
        self.write(HEAD, SET, SPEED)
        process = subprocess.Popen(self.command("--at-once", 1, "--threads", 1),
                                   stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        victim = None
        while victim is None and process.poll() is None:
            for pid, command in alive(str(self.out / "rotation_30rpm")):
                if "sweep" not in command[1:2]:
                    victim = pid
            time.sleep(0.005)
        os.kill(victim, signal.SIGKILL)
        errors = process.communicate(timeout=250)[1]
        self.assertEqual(0, process.returncode, errors)
        self.assertIn("rotation_30rpm: signal 9; see ", errors)
        self.assertEqual(["finished"] * 3, [row["status"] for row in self.rows()])

    def kill_and_go_on(self, number, most):
        """Ended at random moments, so many times at most; then left in peace. How often it was."""
        for kills in range(most):
            process = subprocess.Popen(self.command(*WIDTH), stderr=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL)
            try:
                process.wait(timeout=random.Random(number + kills).uniform(0.2, 1.2))
                return kills
            except subprocess.TimeoutExpired:
                process.send_signal(number)
                process.wait(timeout=250)
            if number != signal.SIGKILL:
                self.assertEqual(0, process.returncode)
                self.assertEqual([], alive(str(self.out)), "runs outlive a sweep that was stopped")
            deadline = time.monotonic() + 20
            while alive(str(self.out)):
                self.assertLess(time.monotonic(), deadline, "runs outlive a sweep that was killed")
                time.sleep(0.02)
        self.sweep(*WIDTH)
        return most

    def test_a_sweep_killed_at_any_moment_ends_with_the_same_table(self):
        self.write(HEAD, "replicates = 2\n", SET, SPEED)
        self.sweep(*WIDTH)
        peace = self.out
        wanted = {name: (peace / name).read_bytes() for name in ("sweep.csv", "sweep.h5")}
        for number, most in ((signal.SIGKILL, 5), (signal.SIGTERM, 2)):
            self.out = self.folder / f"killed_{number}"
            kills = self.kill_and_go_on(number, most)
            self.assertGreater(kills, 0)
            for name, contents in wanted.items():
                self.assertEqual(contents, (self.out / name).read_bytes(), name)
        # Finished cases are not run again.
        before = (self.out / "sweep.csv").stat().st_mtime_ns
        logs = {p: p.stat().st_mtime_ns for p in self.out.rglob("log.txt")}
        self.sweep(*WIDTH)
        self.assertEqual(logs, {p: p.stat().st_mtime_ns for p in self.out.rglob("log.txt")})
        self.assertGreater((self.out / "sweep.csv").stat().st_mtime_ns, before)


if __name__ == "__main__":
    unittest.main()
