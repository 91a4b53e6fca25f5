#!/usr/bin/python3
"""The page of a sweep in headless Chromium: draws, chooses, moves, links, and complains of nothing.

usage: QUERN_PROGRAM=... sweep_page.py WORK_FOLDER    (77: skipped, no Chromium)

Screenshots at 1400 and 400 pixels, light and dark, are left in WORK_FOLDER.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from browser import CATCH, Browser
from sweep_test import ANGLE, HEAD, SET, SPEED

PROGRAM = os.environ["QUERN_PROGRAM"]
WORK = pathlib.Path(sys.argv.pop(1))
PAGE = WORK / "out/sweep.html"
SECTIONS = ["ends", "responses", "effects", "scatter", "parallel", "cases"]


def setUpModule():
    global BROWSER
    BROWSER = Browser()
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    (WORK / "sweep.toml").write_text("".join([HEAD, "replicates = 2\n", SET, ANGLE, SPEED]), encoding="utf-8")
    subprocess.run([PROGRAM, "sweep", WORK / "sweep.toml", "--out", WORK / "out", "--threads", "1",
                    "--at-once", "2"], check=True, capture_output=True)


def tearDownModule():
    BROWSER.close()


class SweepPage(unittest.TestCase):
    def open(self, **how):
        BROWSER.open(PAGE, **how)
        self.addCleanup(lambda: self.assertEqual([], BROWSER.complaints() + BROWSER.requests()))

    def choose(self, section, row, value):
        BROWSER.evaluate(f"""(() => {{
            const box = document.querySelectorAll('#{section} select')[{row}];
            box.value = {value!r}; box.dispatchEvent(new Event('change')); }})()""")
        BROWSER.evaluate("new Promise((done) => setTimeout(done, 300))")

    def test_has_its_sections_and_fits(self):
        for width in (1400, 400):
            for dark in (False, True):
                self.open(width=width, dark=dark)
                self.assertEqual(SECTIONS, BROWSER.evaluate("[...document.querySelectorAll('section')].map((s) => s.id)"))
                self.assertLessEqual(BROWSER.evaluate("document.documentElement.scrollWidth"), width)
                BROWSER.evaluate("new Promise((done) => setTimeout(done, 1500))")
                BROWSER.picture(WORK / f"sweep_{width}{'_dark' if dark else ''}.png")

    def test_choices_change_the_plots(self):
        self.open()
        spec = "JSON.stringify(quern.plots[{}].spec.series.map((s) => [s.label, s.x, s.y, s.error]))"
        for section, select, value, plot in (("responses", 0, "1", 0), ("responses", 1, "within", 1),
                                             ("effects", 0, "1", 4), ("scatter", 0, "factor:1", 5),
                                             ("scatter", 2, "1", 5)):
            before = BROWSER.evaluate(spec.format(plot))
            self.choose(section, select, value)
            self.assertNotEqual(before, BROWSER.evaluate(spec.format(plot)), (section, select))

    def test_means_and_bars_are_those_of_the_cases(self):
        self.open()
        line = BROWSER.evaluate("quern.plots[0].spec.series[0]")
        power = BROWSER.evaluate("quern.page.sweep.responses[0].value")
        points = [(power[2 * k], power[2 * k + 1]) for k in (0, 3)]  # both angles at the first speed
        for (a, b), mean, bar in zip(points, line["y"], line["error"]):
            self.assertAlmostEqual((a + b) / 2, mean, places=12)
            self.assertAlmostEqual(abs(a - b) / 2, bar, places=12)  # of two: half their difference

    def test_another_response_shows_other_mills(self):
        self.open()
        names = "[...document.querySelectorAll('#ends .view > .note')].map((n) => n.textContent)"
        options = BROWSER.evaluate("[...document.querySelector('#ends select').options].map((o) => o.value)")
        seen = set()
        for value in options:
            self.choose("ends", 0, value)
            seen.add(tuple(BROWSER.evaluate(names)))
            BROWSER.evaluate("""new Promise((done, fail) => {
                setTimeout(() => fail(new Error("no pictures")), 60000);
                const look = () => document.querySelectorAll("#ends canvas").length === 2 ? done() : setTimeout(look, 50);
                look(); })""")
        self.assertGreater(len(seen), 1)

    def test_keys_and_links(self):
        self.open()
        BROWSER.evaluate("document.querySelector('.parallel').focus()")
        BROWSER.press("ArrowRight")
        self.assertIn("face_angle_10deg_rotation_20rpm_seed_1: ", BROWSER.evaluate("document.querySelector('#parallel output').value"))
        for link in BROWSER.evaluate("[...document.querySelectorAll('#cases a')].map((a) => a.getAttribute('href'))"):
            self.assertTrue((PAGE.parent / link).is_file(), link)

    def test_hands_out_numbers(self):
        self.open()
        BROWSER.evaluate(CATCH)
        BROWSER.evaluate("document.querySelectorAll('button.csv').forEach((button) => button.click())")
        texts = BROWSER.evaluate("Promise.all(handed.map((blob) => blob.text()))")
        self.assertEqual(8, len(texts))
        for text in texts:
            self.assertGreater(len(text.strip().split("\n")), 1, text)
            self.assertNotIn("NaN", text)


if __name__ == "__main__":
    unittest.main()
