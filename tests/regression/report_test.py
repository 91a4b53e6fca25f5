#!/usr/bin/python3
"""The report page from outside, without a browser: what it carries is what the files have.

usage: report_test.py SPHERES_RUN MIXED_RUN WORK_FOLDER

The folders are those of short runs that have ended. QUERN_PROGRAM is the program.
"""

import glob
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy

from report_data import Page

PROGRAM = os.environ["QUERN_PROGRAM"]
SPHERES, MIXED, WORK = (pathlib.Path(p) for p in sys.argv[1:4])
SCENE = pathlib.Path(__file__).resolve().parents[2] / "apps/scenes/lab_mill_spheres.toml"


def quern(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == code, (arguments, done.returncode, done.stderr)
    return done.stdout + done.stderr


def frame_of(run, time_of_frame):
    """Rows of the frame nearest to a time, by identity: position, speed, quaternion or None."""
    rows = {}
    for path in glob.glob(str(run / "frames" / "particles_*.hdf")):
        with h5py.File(path) as file:
            if abs(file.attrs["time"] - time_of_frame) > 1e-6:
                continue
            data = file["VTKHDF"]
            for k, i in enumerate(data["PointData/id"][:]):
                rows[i] = (data["Points"][k], data["PointData/speed"][k], None)
        bodies = path.replace("particles_", "polyhedra_")
        if os.path.exists(bodies):
            with h5py.File(bodies) as file:
                data = file["polyhedra"]
                for k, i in enumerate(data["id"][:]):
                    rows[i] = (data["position"][k], numpy.linalg.norm(data["velocity"][k]),
                               data["orientation"][k])
    return rows


class Report(unittest.TestCase):
    def arrays(self, run, page):
        with h5py.File(run / "run.h5") as file:
            for name, array in page.data["runs"][0]["arrays"].items():
                stored = numpy.asarray(file[name][:], dtype=float).ravel()
                shown = numpy.array([numpy.nan if v is None else v for v in array["data"]])
                numpy.testing.assert_allclose(shown, stored, rtol=1e-6, atol=1e-300, err_msg=name)
                self.assertEqual(array["unit"], file[name].attrs["unit"].decode(), name)

    def view(self, run, page):
        view = page.data["runs"][0]["view"]
        statics = page.statics(view)
        step = (numpy.array(view["high"]) - numpy.array(view["low"])) / 65535
        for k, moment in enumerate(view["times"]):
            stored = frame_of(run, moment)
            position, speed, turn = page.frame(view, k)
            self.assertEqual(sorted(stored), sorted(statics["id"]))
            for row, identity in enumerate(statics["id"]):
                place, v, q = stored[identity]
                self.assertTrue(numpy.all(numpy.abs(position[row] - place) <= 0.51 * step + 1e-7))
                # Bytes of roots: half a step of q / 254.
                self.assertAlmostEqual(numpy.sqrt(speed[row] / view["speed"]),
                                       numpy.sqrt(v / view["speed"]), delta=0.51 / 254)
                if q is not None:
                    numpy.testing.assert_allclose(turn[row - view["spheres"]], q, atol=0.6 / 32767)

    def test_carries_what_the_files_have(self):
        for run in (SPHERES, MIXED):
            quern("report", run)
            page = Page(run / "report.html")
            self.arrays(run, page)
            self.view(run, page)
            told = page.data["runs"][0]
            self.assertEqual(json.loads(told["summary"]), json.loads((run / "summary.json").read_text()))
            with h5py.File(run / "run.h5") as file:
                self.assertEqual(told["scene_text"], file["scene"].asstr()[0])

    def test_shapes_are_those_of_the_run(self):
        """Each corner of a drawn shape is a vertex of /shapes, to the frames' single precision."""
        page = Page(MIXED / "report.html")
        shapes = page.data["runs"][0]["view"]["shapes"]
        with h5py.File(MIXED / "run.h5") as file:
            self.assertEqual(sorted(shapes), sorted(file["shapes"]))
            for name, corners in shapes.items():
                vertex = file[f"shapes/{name}/vertex"][:]
                for corner in numpy.reshape(corners, (-1, 3)):
                    self.assertLess(numpy.linalg.norm(vertex - corner, axis=1).min(), 1e-4)
                self.assertEqual(len(corners), 9 * len(file[f"shapes/{name}/triangle"]))

    def test_walls_move_as_in_the_frames(self):
        page = Page(SPHERES / "report.html")
        view = page.data["runs"][0]["view"]
        for k, moment in enumerate(view["times"]):
            path = [p for p in glob.glob(str(SPHERES / "frames" / "liner_*.hdf"))
                    if abs(h5py.File(p).attrs["time"] - moment) < 1e-6][0]
            with h5py.File(path) as file:
                points, corners = file["VTKHDF/Points"][:], file["VTKHDF/Connectivity"][:]
                wall = file["VTKHDF/CellData/wall"][:]
            for number, entry in enumerate(view["walls"]):
                body = numpy.frombuffer(page.blob(entry["blob"]), dtype="<f4").reshape(-1, 3)
                w, x, y, z = entry["poses"][k][:4]
                rotation = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
                drawn = body @ rotation.T + numpy.array(entry["poses"][k][4:])
                stored = points[corners.reshape(-1, 3)[wall == number].ravel()]
                numpy.testing.assert_allclose(drawn, stored, atol=1e-6)

    def test_is_written_at_the_end_of_a_run(self):
        out = WORK / "ended"
        shutil.rmtree(out, ignore_errors=True)
        said = quern("run", SCENE, "--out", out, "--set", "run.settle=none", "--set", "run.duration=0.02",
                     "--set", "run.record_from=0")
        self.assertIn("report.html", said)
        self.assertIsNone(Page(out / "report.html").data["runs"][0]["view"])

    def test_of_a_run_that_goes_on_and_of_one_that_was_killed(self):
        out = WORK / "killed"
        shutil.rmtree(out, ignore_errors=True)
        run = subprocess.Popen([PROGRAM, "run", str(SCENE), "--out", str(out), "--threads", "1",
                                "--set", "run.settle=none", "--set", "output.series_every=0.0002",
                                "--set", "output.frames_every=0.01"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            deadline = time.monotonic() + 60
            while not (out / "frames" / "particles.hdf.series").exists() and time.monotonic() < deadline:
                time.sleep(0.05)
            rows = 0
            for _ in range(20):  # while it writes
                quern("report", out)
                told = Page(out / "report.html").data["runs"][0]
                self.assertEqual(told["summary"], "")
                self.assertGreaterEqual(told["arrays"]["series/time"]["rows"], rows)
                rows = told["arrays"]["series/time"]["rows"]
            self.assertGreater(rows, 10)
        finally:
            run.send_signal(signal.SIGKILL)
            run.wait()
        quern("report", out)
        page = Page(out / "report.html")
        told = page.data["runs"][0]
        with h5py.File(out / "run.h5") as file:
            stored = min(len(file[f"series/{name}"]) for name in ("time", "power"))
        self.assertLessEqual(abs(told["arrays"]["series/time"]["rows"] - stored), 1)
        listed = json.loads((out / "frames" / "particles.hdf.series").read_text())["files"]
        self.assertEqual(len(told["view"]["times"]), len(listed))

    def test_a_killed_run_has_the_tables_of_its_last_checkpoint(self):
        out = WORK / "killed_later"
        shutil.rmtree(out, ignore_errors=True)
        run = subprocess.Popen([PROGRAM, "run", str(SCENE), "--out", str(out), "--threads", "1",
                                "--set", "run.settle=none", "--set", "run.record_from=0",
                                "--set", "output.series_every=0.0002",
                                "--set", "record.snapshots_every=0.001",
                                "--set", "output.frames_every=0.002",
                                "--set", "wear.flow_pressure=5e9", "--set", "wear.cell_size=0.05",
                                "--set", "output.checkpoint_every=0.2"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            deadline = time.monotonic() + 60
            while not (out / "summary.json").exists() and time.monotonic() < deadline:
                time.sleep(0.05)
            time.sleep(0.5)
        finally:
            run.send_signal(signal.SIGKILL)
            run.wait()
        quern("report", out)
        told = Page(out / "report.html").data["runs"][0]
        summary = json.loads(told["summary"])
        self.assertFalse(summary["finished"])
        self.assertGreater(summary["time_s"], 0)
        for name in ("power_by_kind/total", "spectra/ore-ore/energy", "charge_map/solid_fraction",
                     "classes/angular_speed"):
            self.assertIn(name, told["arrays"], name)
        spectra = [sum(told["arrays"][f"spectra/{kind}/energy"]["data"])
                   for kind in ("ore-ore", "ore-media", "ore-liner", "media-media", "media-liner")]
        spectra += told["arrays"]["spectra/open_energy"]["data"]
        self.assertAlmostEqual(sum(spectra) / summary["recorded_dissipation_J"], 1, delta=1e-6)
        # Torn by the kill: tables and wear are those of the copy.
        (out / "run.h5").write_bytes((out / "run.h5").read_bytes()[:3000])
        quern("report", out)
        torn = Page(out / "report.html").data["runs"][0]
        self.assertEqual(torn["arrays"]["power_by_kind/total"], told["arrays"]["power_by_kind/total"])
        self.assertIsNotNone(torn["view"]["walls"][0]["wear"])
        notes = " ".join(torn["notes"])
        self.assertEqual(notes.count("run.previous.h5"), 2, notes)

    def test_compare_carries_all_runs(self):
        out = WORK / "compare.html"
        quern("compare", SPHERES, MIXED, "--out", out)
        page = Page(out)
        self.assertEqual([run["name"] for run in page.data["runs"]], [SPHERES.name, MIXED.name])

    def test_says_what_is_missing(self):
        self.assertIn("no such folder", quern("report", WORK / "none", code=3))
        empty = WORK / "empty"
        empty.mkdir(exist_ok=True)
        self.assertIn("run.h5", quern("report", empty, code=3))
        self.assertIn("run.h5", quern("compare", SPHERES, empty, "--out", WORK / "x.html", code=3))
        quern("compare", SPHERES, code=2)
        quern("report", code=2)


if __name__ == "__main__":
    WORK.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
