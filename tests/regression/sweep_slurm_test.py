#!/usr/bin/python3
"""`quern sweep --slurm` and `--collect` without a cluster: an sbatch of our own notes what it is told
and runs the tasks one after another.

usage: QUERN_PROGRAM=build/release/quern sweep_slurm_test.py [TEST]
"""

import json
import os
import signal
import subprocess
import time
import unittest

from sweep_test import ANGLE, HEAD, SET, SPEED, WIDTH, SweepCase, alive

# As the real ones: a number of its own for each job, a log for each task, what is queued again runs
# again. Notes its words and how many fillings were there at that time.
SBATCH = r"""#!/usr/bin/python3
import os, pathlib, re, subprocess, sys
bin = pathlib.Path(__file__).parent
calls = bin / "calls"
count = len(calls.read_text().splitlines()) if calls.exists() else 0
script = pathlib.Path(sys.argv[-1])
if script.name in os.environ.get("REFUSES", "").split():
    sys.exit("sbatch: error: Batch job submission failed: Invalid partition name specified")
settled = len(list(script.parents[1].glob("fillings/*/settled/checkpoint.h5")))
with open(calls, "a") as file:
    file.write(" ".join([*sys.argv[1:-1], script.name, str(settled)]) + "\n")
lines = dict(re.findall(r'^#SBATCH .*--(array|output)="?([^"\n]*)', script.read_text(), re.M))
numbers = []
for part in lines["array"].split("%")[0].split(","):
    first, _, last = part.partition("-")
    numbers += range(int(first), int(last or first) + 1)
job = str(101 + count)
for number in numbers:
    requeued = bin / f"requeue {job}_{number}"
    while True:
        with open(lines["output"].replace("%%", "%").replace("%a", str(number)), "a") as log:
            code = subprocess.run(["bash", script], stdout=log, stderr=log, env={
                **os.environ, "SLURM_ARRAY_JOB_ID": job, "SLURM_ARRAY_TASK_ID": str(number)}).returncode
        if not requeued.exists():
            break
        requeued.unlink()
    with open(bin / "codes", "a") as file:
        file.write(f"{job}_{number} {code}\n")
print("sbatch: a word beside", file=sys.stderr)
print(job + ";loopback")
"""
SCONTROL = '#!/bin/sh\ntouch "${0%/*}/$*"\n'
# Long enough to be caught, with checkpoints where it is stopped only.
LONG = (SET.replace('run.duration = "0.06 s"', 'run.duration = "1.5 s"')
        .replace('output.checkpoint_every = "0.02 s"\n', ""))
TWO = '[[factors]]\nkey = "mill.rotation"\nvalues = ["20 rpm", "30 rpm"]\n'


class Slurm(SweepCase):
    def setUp(self):
        super().setUp()
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        for name, text in (("sbatch", SBATCH), ("scontrol", SCONTROL)):
            (self.bin / name).write_text(text, encoding="utf-8")
            (self.bin / name).chmod(0o755)
        self.out = self.folder / "50% of it's out"  # a name to be quoted
        self.path(f"{self.bin}:{os.environ['PATH']}")

    def path(self, path):
        before = os.environ["PATH"]
        os.environ["PATH"] = path
        self.addCleanup(os.environ.__setitem__, "PATH", before)

    def lines(self, name):
        file = self.bin / name
        return file.read_text(encoding="utf-8").splitlines() if file.exists() else []

    def task(self, number, script="cases.sh"):
        """A task of the array, as Slurm starts it."""
        with open(self.folder / "task.log", "a", encoding="utf-8") as log:
            return subprocess.Popen(
                ["bash", self.out / "slurm" / script], stdout=log, stderr=log,
                env={**os.environ, "SLURM_ARRAY_JOB_ID": "7", "SLURM_ARRAY_TASK_ID": str(number)})

    def wait_for(self, found):
        deadline = time.monotonic() + 250
        while not (there := found()):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.005)
        return there

    def statuses(self, code=0):
        text = self.sweep("--collect", code=code).stdout
        rows = self.rows()
        for status in ("running", "stopped", "missing"):
            count = sum(row["status"] == status for row in rows)
            self.assertEqual(count > 0, f"{count} {status}" in text, text)
        return [row["status"] for row in rows]

    def state_hash(self, out, name):
        return json.loads((out / name / "summary.json").read_text())["state_hash"]

    def test_an_array_ends_with_the_table_of_a_local_sweep(self):
        self.write(HEAD, SET, ANGLE, SPEED)
        text = self.sweep("--slurm", "--at-once", 3, "--time-limit", "90 min", "--sbatch",
                          "partition=long").stdout
        self.assertEqual(["--parsable fillings.sh 0",
                          "--parsable --dependency=afterany:101 cases.sh 2"], self.lines("calls"))
        self.assertEqual([f"101_{k} 0" for k in (1, 4)] + [f"102_{k} 0" for k in range(1, 7)],
                         self.lines("codes"))
        self.assertRegex(text, r"submitted +job 102: 6 cases, once job 101 has ended")
        script = (self.out / "slurm/cases.sh").read_text(encoding="utf-8")
        for line in ("array=1-6%3", "time=90", 'partition="long"', "nodes=1 --ntasks=1 --cpus-per-task=1"):
            self.assertIn(f"#SBATCH --{line}\n", script)
        self.assertIn("finished", (self.out / "slurm/case-6.log").read_text(encoding="utf-8"))
        self.assertEqual([], list(self.out.glob("sweep.*")))
        self.assertEqual(["finished"] * 6, self.statuses())
        local = self.folder / "local"
        self.sweep(*WIDTH, out=local)
        for name in ("sweep.csv", "sweep.h5"):
            self.assertEqual((local / name).read_bytes(), (self.out / name).read_bytes(), name)
        self.assertTrue((self.out / "sweep.html").is_file())
        self.assertIn("6, 0 of them left to do", self.sweep("--slurm").stdout)
        self.assertEqual(2, len(self.lines("calls")))

    def test_only_what_is_left_is_submitted(self):
        self.write(HEAD, SET, ANGLE, SPEED)
        for number in (1, 2, 5):
            self.sweep("--case", number, "--threads", 1)
        self.assertEqual(["finished", "finished", "missing", "missing", "finished", "missing"],
                         self.statuses())
        self.sweep("--slurm")
        self.assertEqual(["--parsable cases.sh 2"], self.lines("calls"))
        self.assertEqual(["101_3 0", "101_4 0", "101_6 0"], self.lines("codes"))
        self.assertEqual(["finished"] * 6, self.statuses())

    def test_a_task_that_is_told_of_its_end_is_queued_again_and_goes_on(self):
        self.write(HEAD, LONG, TWO)
        self.assertIn("submit  ", self.sweep("--slurm", "--no-submit").stdout)
        self.assertEqual([], self.lines("calls"))
        task = self.task(2)
        self.wait_for((self.out / "rotation_30rpm/run.h5").exists)
        self.assertEqual(["missing", "running"], self.statuses())
        task.send_signal(signal.SIGUSR1)
        self.assertEqual(0, task.wait(timeout=250))
        self.assertEqual(["missing", "stopped"], self.statuses())
        self.assertTrue((self.bin / "requeue 7_2").exists())
        (self.bin / "requeue 7_2").unlink()
        self.assertEqual(0, self.task(2).wait(timeout=250))
        self.assertEqual(["missing", "finished"], self.statuses())
        self.assertFalse((self.bin / "requeue 7_2").exists())
        straight = self.folder / "straight"
        self.sweep("--case", 2, "--threads", 1, out=straight)
        self.assertEqual(self.state_hash(straight, "rotation_30rpm"),
                         self.state_hash(self.out, "rotation_30rpm"))
        # The one that is told when it is over, or was before, ends at once.
        log = self.out / "rotation_30rpm/log.txt"
        before = log.stat().st_mtime_ns
        self.assertEqual(0, self.task(2).wait(timeout=250))
        self.assertEqual(before, log.stat().st_mtime_ns)

    def test_a_filling_that_is_told_goes_on_too(self):
        self.write(HEAD, LONG.replace('run.settle = "0.02 s"', 'run.settle = "2 s"'), TWO)
        self.sweep("--slurm", "--no-submit")
        task = self.task(1, "fillings.sh")
        self.wait_for(lambda: list(self.out.glob("fillings/*/checkpoint.h5")))
        task.send_signal(signal.SIGUSR1)
        self.assertEqual(0, task.wait(timeout=250))
        self.assertTrue((self.bin / "requeue 7_1").exists())
        self.assertEqual([], list(self.out.glob("fillings/*/settled")))
        self.assertEqual(0, self.task(1, "fillings.sh").wait(timeout=250))
        self.assertEqual(1, len(list(self.out.glob("fillings/*/settled"))))
        self.assertEqual(["missing"] * 2, self.statuses())

    def test_a_case_that_goes_wrong_twice_is_failed_and_not_queued_again(self):
        self.write(HEAD, SET.replace("[set]", '[set]\nrun.time_step = "1e-5 s"\nrun.settle = "none"\n')
                   .replace('run.settle = "0.02 s"\n', ""),
                   '[[factors]]\nkey = "contact.normal_stiffness"\nvalues = ["1e5 N/m", "0.1 N/m"]\n')
        self.sweep("--slurm")
        self.assertEqual(["101_1 0", "101_2 4"], self.lines("codes"))
        log = (self.out / "slurm/case-2.log").read_text(encoding="utf-8")
        self.assertEqual(1, log.count("; once more"), log)
        statuses = self.statuses(code=4)
        self.assertEqual("finished", statuses[0])
        self.assertRegex(statuses[1], "^failed: .*overlap")
        # Nor submitted again.
        self.assertIn("2, 0 of them left to do", self.sweep("--slurm").stdout)

    def test_a_case_that_is_killed_twice_is_failed_until_somebody_tries_again(self):
        self.write(HEAD, LONG, TWO)
        self.sweep("--slurm", "--no-submit")
        task, killed = self.task(1), set()

        def victim():
            return [pid for pid, command in alive(str(self.out / "rotation_20rpm"))
                    if "sweep" not in command[1:2] and pid not in killed]

        for _ in range(2):
            pid = self.wait_for(victim)[0]
            os.kill(pid, signal.SIGKILL)
            killed.add(pid)
        self.assertEqual(4, task.wait(timeout=250))
        self.assertEqual([], list(self.bin.glob("requeue*")))
        self.assertEqual(["failed: signal 9", "missing"], self.statuses(code=4))
        self.sweep("--slurm")
        self.assertEqual(["finished"] * 2, self.statuses())

    def test_says_why_nothing_was_submitted(self):
        self.write(HEAD, SET, ANGLE, SPEED)
        errors = self.sweep("--slurm", "--time-limit", "5 parsecs", code=2).stderr
        self.assertIn("--time-limit 5 parsecs: unit 'parsecs'", errors)
        os.environ["REFUSES"] = "fillings.sh"
        self.addCleanup(os.environ.pop, "REFUSES")
        result = self.sweep("--slurm", code=3)
        self.assertIn("sbatch: error: Batch job submission failed: Invalid partition name", result.stderr)
        self.assertIn("fillings=$(sbatch --parsable ", result.stdout)
        os.environ["REFUSES"] = "cases.sh"
        result = self.sweep("--slurm", code=3)
        self.assertIn("Invalid partition name", result.stderr)
        self.assertEqual(["101_1 0", "101_4 0"], self.lines("codes"))
        # What the program says goes on by hand.
        os.environ["REFUSES"] = ""
        by_hand = result.stdout.split("by hand ")[1].splitlines()[0]
        subprocess.run(["bash", "-c", by_hand], check=True, capture_output=True)
        self.assertEqual(["finished"] * 6, self.statuses())

    def test_says_that_there_is_no_slurm(self):
        self.write(HEAD, SET, ANGLE, SPEED)
        empty = self.folder / "empty"
        empty.mkdir()
        self.path(str(empty))
        result = self.sweep("--slurm", code=3)
        self.assertIn("there is no program sbatch here", result.stderr)
        self.assertIn("by hand ", result.stdout)
        self.assertTrue((self.out / "slurm/cases.sh").is_file())

    def test_collects_nothing_where_nothing_is(self):
        self.write(HEAD, SET, SPEED)
        self.assertIn("there is no folder", self.sweep("--collect", code=2).stderr)
        self.out.mkdir()
        self.assertEqual(["missing"] * 3, self.statuses())


if __name__ == "__main__":
    unittest.main()
