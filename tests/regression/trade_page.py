#!/usr/bin/python3
"""The page of `quern trade` in headless Chromium: draws what the table says, and complains of nothing.

usage: QUERN_PROGRAM=... trade_page.py WORK_FOLDER    (77: skipped, no Chromium)

Screenshots at 1400 and 400 pixels, light and dark, are left in WORK_FOLDER.
"""

import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from browser import CATCH, Browser
from cli_test import LAB_MILL
from trade_cli import SHORT

PROGRAM = os.environ["QUERN_PROGRAM"]
WORK = pathlib.Path(sys.argv.pop(1))
SETTINGS = ["default", "soft_10", "steps_4"]


def setUpModule():
    global BROWSER
    BROWSER = Browser()
    shutil.rmtree(WORK, ignore_errors=True)
    only = [word for setting in SETTINGS[1:] for word in ("--only", setting)]
    subprocess.run([PROGRAM, "trade", LAB_MILL, "--out", WORK, *map(str, SHORT), *only],
                   check=True, capture_output=True)


def tearDownModule():
    BROWSER.close()


class TradePage(unittest.TestCase):
    def open(self, **how):
        BROWSER.open(WORK / "trade.html", **how)
        self.addCleanup(lambda: self.assertEqual([], BROWSER.complaints() + BROWSER.requests()))

    def test_has_its_sections_and_fits(self):
        for width in (1400, 400):
            for dark in (False, True):
                self.open(width=width, dark=dark)
                self.assertEqual(["pareto", "errors", "numerics", "settings"], BROWSER.evaluate(
                    "[...document.querySelectorAll('section')].map((s) => s.id)"))
                self.assertLessEqual(BROWSER.evaluate("document.documentElement.scrollWidth"), width)
                BROWSER.evaluate("new Promise((done) => setTimeout(done, 500))")
                BROWSER.picture(WORK / f"trade_{width}{'_dark' if dark else ''}.png")

    def test_a_point_is_cost_and_error_of_the_chosen_figure(self):
        self.open()
        with open(WORK / "trade.csv", encoding="utf-8", newline="") as file:
            rows = {row["setting"]: row for row in csv.DictReader(file)}
        names = BROWSER.evaluate("[...document.querySelectorAll('#pareto option')].map((o) => o.value)")
        self.assertIn("power_W", names)
        seen = 0
        for name in names:
            BROWSER.evaluate(f"""(() => {{
                const box = document.querySelector('#pareto select');
                box.value = {name!r}; box.dispatchEvent(new Event('change')); }})()""")
            points = {(x, y) for line in BROWSER.evaluate("quern.plots[0].spec.series")
                      for x, y in zip(line["x"], line["y"])}
            expected = set()
            for row in (rows[setting] for setting in SETTINGS[1:]):
                error, chance = (row.get(f"{name}_{part}") for part in ("error", "standard_error"))
                if not error or not chance or "nan" in (error, chance): continue
                bound = max(abs(float(error)), 2 * float(chance))
                if bound > 0: expected.add((float(row["cost"]), bound))
            self.assertEqual(len(points), len(expected), name)
            for got, want in zip(sorted(points), sorted(expected)):
                for a, b in zip(got, want): self.assertAlmostEqual(a / b, 1, places=4, msg=name)
            seen += len(points)
        self.assertGreater(seen, len(names))

    def test_hands_out_the_table(self):
        self.open()
        BROWSER.evaluate(CATCH)
        BROWSER.evaluate("document.querySelectorAll('button.csv').forEach((button) => button.click())")
        texts = BROWSER.evaluate("Promise.all(handed.map((blob) => blob.text()))")
        self.assertEqual(2, len(texts))
        table = next(text for text in texts if text.startswith('"dial"'))
        self.assertEqual([row["value"] for row in csv.DictReader(io.StringIO(table))],
                         BROWSER.evaluate("quern.page.trade.rows.map((row) => row.value)"))


if __name__ == "__main__":
    unittest.main()
