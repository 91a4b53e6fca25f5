#!/usr/bin/python3
"""quern trade, seen from outside: interrupted, gone on with, extended; its table against the runs.

usage: QUERN_PROGRAM=build/release/quern trade_cli.py
"""

import base64
import csv
import gzip
import json
import re
import signal
import subprocess
import time
import unittest

import h5py
import numpy

from cli_test import BOUNCE, LAB_MILL, PROGRAM, Case, quern

SHORT = ["--threads", 1, "--steady", 1 / 18, "--lead", 0.02, "--revolutions", 0.05,
         "--segment", 0.05, "--set", "run.settle=none", "--set", "output.series_every=1 ms"]


def sum_blocks(path):
    with h5py.File(path) as run:
        return {f"{block}/{name}": data[:].tobytes() for block, table in run["sum_blocks"].items()
                for name, data in table.items()}


class Trade(Case):
    def trade(self, *arguments):
        return quern("trade", LAB_MILL, "--out", self.out, *SHORT, *arguments)

    def rows(self):
        with open(self.out / "trade.csv", encoding="utf-8", newline="") as file:
            return {row["setting"]: row for row in csv.DictReader(file)}

    def summary_of(self, setting):
        with open(self.out / setting / "summary.json", encoding="utf-8") as file:
            return json.load(file)

    def interrupt(self, *arguments):
        """Stops it while the default runs."""
        command = [PROGRAM, "trade", LAB_MILL, "--out", self.out, *SHORT, *arguments]
        with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True) as process:
            until = time.monotonic() + 90
            while not (self.out / "default" / "checkpoint.h5").exists():
                self.assertLess(time.monotonic(), until)
                time.sleep(0.01)
            process.send_signal(signal.SIGTERM)
            said = process.communicate(timeout=90)[0]
        self.assertEqual(process.returncode, 0, said)
        self.assertIn("the same command goes on", said)

    def check_blocks(self, path):
        """Sums at each tenth of the window grow to what the tables of the whole window have."""
        with h5py.File(path) as run:
            blocks = [run["sum_blocks"][name] for name in sorted(run["sum_blocks"])]
            self.assertEqual(len(blocks), 10)
            for name in ("count", "energy"):
                kinds = run["spectra/kind"].asstr()[0].split()
                whole = numpy.array([run[f"spectra/{kind}/{name}"][:] for kind in kinds])
                self.assertTrue(numpy.array_equal(blocks[-1][name][:], whole), name)
            counts = [block["count"][:].sum() for block in blocks]
            self.assertTrue(all(numpy.diff([0, *counts]) > 0), counts)
            siem = sum(wall["energy_siem"][:].sum() for wall in run["wear"].values())
            self.assertAlmostEqual(blocks[-1]["wear"][0] / siem, 1, places=9)

    def check_errors(self, row, setting):
        """Of power: in percent of the default's, with the root of the summed squares."""
        own, base = self.summary_of(setting), self.summary_of("default")
        error = 100 * (own["power_W"] / base["power_W"] - 1)
        chance = 100 * (own["power_W_standard_error"]**2 +
                        base["power_W_standard_error"]**2)**0.5 / base["power_W"]
        self.assertAlmostEqual(float(row["power_W_error"]) / error, 1, places=3)
        self.assertAlmostEqual(float(row["power_W_standard_error"]) / chance, 1, places=3)
        said = (self.out / "trade.txt").read_text(encoding="utf-8")
        told = re.search(rf"^.*{row['value']}.* default .*$", said, re.MULTILINE)[0]
        bound = f"< {2 * chance:.2g}" if chance < 50 else f"< {2 * chance:.0f}"
        self.assertEqual(bound in told, abs(error) < 2 * chance, told)

    def check_page(self):
        page = (self.out / "trade.html").read_text(encoding="utf-8")
        self.assertIn("default-src 'none'", page)
        packed = re.search(r'id="data">([^<]*)<', page)[1]
        data = json.loads(gzip.decompress(base64.b64decode(packed)))
        with open(self.out / "trade.json", encoding="utf-8") as file:
            self.assertEqual(data["trade"], json.load(file))

    def test_goes_on_and_tells_what_its_runs_say(self):
        self.interrupt("--only", "soft_10")
        self.assertFalse(self.summary_of("default")["finished"])
        self.expect(0, self.trade("--only", "soft_10"), "softened", "10 x", "numerics")
        rows = self.rows()
        self.assertEqual(set(rows), {"default", "soft_10"})
        self.assertEqual(rows["soft_10"]["against"], "default")  # the finest was not asked for
        self.assertEqual(float(rows["default"]["power_W_error"]), 0)
        self.check_errors(rows["soft_10"], "soft_10")
        # Softer springs of the same steps a contact: sqrt(10) times as deep, and as long a step.
        for name in ("impact_overlap", "time_step_s"):
            ratio = float(rows["soft_10"][name]) / float(rows["default"][name])
            self.assertAlmostEqual(ratio, 10**0.5, places=3)
        self.assertGreater(float(rows["soft_10"]["cost_high"]), 0)
        self.check_page()

        # The runs are those of `quern run`, interrupted or not.
        straight = self.folder / "straight"
        self.expect(0, quern("run", self.out / "default" / "scene.toml", "--out", straight,
                             "--threads", 1))
        with open(straight / "summary.json", encoding="utf-8") as file:
            self.assertEqual(json.load(file)["state_hash"], self.summary_of("default")["state_hash"])
        blocks = sum_blocks(straight / "run.h5")
        self.check_blocks(straight / "run.h5")
        self.assertEqual(sum_blocks(self.out / "default" / "run.h5"), blocks)

        # Another setting: what is finished stays as it is.
        kept = [self.out / name / "run.h5" for name in ("default", "soft_10", "steady_spheres")]
        before = [path.stat().st_mtime_ns for path in kept]
        self.expect(0, self.trade("--only", "soft_10", "--only", "steps_4"))
        self.assertEqual([path.stat().st_mtime_ns for path in kept], before)
        rows = self.rows()
        self.assertAlmostEqual(float(rows["steps_4"]["steps_per_contact"]), 4, places=4)
        self.check_errors(rows["steps_4"], "steps_4")
        # Few steps: what collisions deliver scatters.
        self.assertGreater(float(rows["steps_4"]["restitution_scatter"]),
                           10 * float(rows["default"]["restitution_scatter"]))

        # One that went wrong is told, and does not stop the others.
        path = self.out / "soft_10" / "summary.json"
        path.write_text('{\n  "finished": false,\n  "error": "a particle has left the domain"\n}\n',
                        encoding="utf-8")
        self.expect(0, self.trade("--only", "softened", "--only", "steps_4", "--table"),
                    "a particle has left the domain")
        rows = self.rows()
        self.assertEqual(rows["soft_10"]["status"], "a particle has left the domain")
        self.assertEqual(rows["soft_10"]["power_W_error"], "")
        self.assertNotEqual(rows["steps_4"]["power_W_error"], "")
        self.assertNotIn("soft_3", rows)  # it has not been run

    def test_of_mistakes_ends_with_2(self):
        self.expect(2, self.trade("--only", "soft_11"), "soft_11", "--list")
        self.expect(2, quern("trade", BOUNCE, "--out", self.out), "no [mill]")
        self.expect(2, self.trade("--set", "run.duratoin=1"), "did you mean")
        self.assertFalse(self.out.exists())

    def test_lists_its_settings_and_runs_none(self):
        said = self.expect(0, self.trade("--list"), "finest", "run.precision=double",
                           "run.precision=single", "soft_100", "steps_50", "slack_1")
        self.assertNotIn("facets", said.stdout)  # a scene of spheres
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
