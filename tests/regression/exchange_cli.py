#!/usr/bin/python3
"""The program exchanges the spheres of a settled run for polyhedra; it is stopped while it relaxes
them, killed while it runs, and still ends in the bits of a straight run.

usage: QUERN_PROGRAM=build/release/quern exchange_cli.py
"""

import signal
import subprocess
import time
import unittest

import cli_test

MIXTURE = """format = 1
[run]
duration = "0.3 s"
time_step = "2e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
""" + cli_test.LAW + """[[walls]]
name = "box"
material = "ore"
low = ["0 m", "0 m", "0 m"]
high = ["60 mm", "60 mm", "150 mm"]
[fill]
method = "random"
[[particles]]
name = "rock"
material = "ore"
shape = "polyhedron"
mesh = "%s"
sizes = [{ from = "12 mm", to = "16 mm", count = 30 }]
[[particles]]
name = "ball"
material = "ore"
diameter = "10 mm"
count = 50
[output]
checkpoint_every = "0.05 s"
"""


class Exchange(cli_test.Case):
    def wait_for(self, happened):
        for _ in range(30000):
            if happened():
                return
            time.sleep(0.002)
        self.fail("the run does not get there")

    def stop_when(self, happened, number, *arguments):
        process = subprocess.Popen([cli_test.PROGRAM, *map(str, arguments)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        self.wait_for(happened)
        process.send_signal(number)
        return process.wait(timeout=60)

    def test_of_spheres_for_polyhedra_ends_as_a_straight_run(self):
        scene = self.folder / "mixture.toml"
        scene.write_text(MIXTURE % (cli_test.APPS / "shapes" / "ore12.stl"), encoding="utf-8")
        self.expect(0, cli_test.quern("run", scene, "--out", self.out, "--set",
                                      "particles.rock.shape=sphere"))
        spheres = self.summary()
        self.assertEqual((spheres["spheres"], spheres["polyhedra"]), (80, 0))
        exchange = ["run", scene, "--set", "run.start=file", "--set", f"run.start_file={self.out}"]
        self.out = self.folder / "straight"
        self.expect(0, cli_test.quern(*exchange, "--out", self.out, "--threads", 1),
                    "30 spheres became polyhedra", "relaxed for 0.2 s")
        straight = self.summary()
        self.assertEqual((straight["spheres"], straight["polyhedra"]), (50, 30))
        self.assertEqual(straight["overlap_warnings"], 0)
        # Stopped while they are let go, then killed while the run goes on.
        self.out = self.folder / "stopped"
        checkpoint, settled = self.out / "checkpoint.h5", self.out / "settled" / "checkpoint.h5"
        self.assertEqual(self.stop_when(checkpoint.is_file, signal.SIGTERM, *exchange, "--out",
                                        self.out, "--threads", 2), 0)
        self.assertFalse(settled.exists())
        self.assertEqual(self.summary()["time_s"], 0)
        self.assertFalse(self.summary()["finished"])
        code = self.stop_when(lambda: settled.is_file() and checkpoint.is_file() and
                              checkpoint.stat().st_mtime > settled.stat().st_mtime + 0.04,
                              signal.SIGKILL, "resume", self.out, "--threads", 1)
        self.assertEqual(code, -signal.SIGKILL)
        self.expect(0, cli_test.quern("resume", self.out, "--threads", 2))
        self.assertTrue(self.summary()["finished"])
        self.assertEqual(self.summary()["state_hash"], straight["state_hash"])


if __name__ == "__main__":
    unittest.main()
