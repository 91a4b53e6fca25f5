#!/usr/bin/python3
"""Maps, classes, zones and the statements on a run, seen from outside.

usage: QUERN_PROGRAM=build/release/quern cli_charge_test.py [CLASS ...]
"""

import math
import unittest

import h5py
import numpy

from cli_test import Case, LAB_MILL, SHORT, quern

RECORD = """
[record]
charge_shape = true
classes = true
snapshots_every = "1 ms"
[[record.zones]]
name = "toe"
radius_from = "0.1 m"
angle_from = "180 deg"
angle_to = "270 deg"
[[record.zones]]
name = "mill"
"""
TABLES = ("charge_map", "charge_blocks", "series_of_charge", "charge_snapshots", "classes",
          "zones", "class_snapshots")


def contents(path):
    """All datasets of the tables that snapshots make, as bytes."""
    found = {}
    with h5py.File(path) as run:
        def note(name, item):
            if isinstance(item, h5py.Dataset) and name.split("/")[0] in TABLES:
                found[name] = item[()] if item.shape == () else item[:].tobytes()
        run.visititems(note)
    return found


class Charge(Case):
    def setUp(self):
        super().setUp()
        self.scene, self.plain = self.folder / "recorded.toml", self.folder / "plain.toml"
        with open(LAB_MILL, encoding="utf-8") as file:
            plain = file.read().split("\n[record]")[0]
        self.plain.write_text(plain, encoding="utf-8")
        self.scene.write_text(plain + RECORD, encoding="utf-8")

    def run_scene(self, *arguments):
        return self.expect(0, quern("run", self.scene, "--out", self.out, *SHORT, *arguments))

    def test_tables_hold_together(self):
        self.run_scene("--threads", 1)
        with h5py.File(self.out / "run.h5") as run:
            tables = {name: {key: run[name][key] for key in run[name]}
                      for name in ("charge_map", "classes", "zones/toe", "zones/mill")}
            for table in tables.values():
                for name, column in table.items():
                    if name != "name":
                        self.assertTrue(column.attrs["unit"], name)
                        self.assertIn("doc", column.attrs)
            self.check_map(tables["charge_map"])
            self.check_classes(run, tables)

    def check_map(self, table):
        solid, speed = table["solid_fraction"][:], table["speed"][:]
        groups = [table[name][:] for name in table if name.startswith("solid_fraction_")]
        self.assertEqual(len(groups), 2)
        numpy.testing.assert_allclose(sum(groups), solid, rtol=1e-5, atol=1e-9)
        along = numpy.hypot(table["velocity_x"][:], table["velocity_y"][:])
        self.assertTrue((along <= speed * (1 + 1e-5) + 1e-9).all())  # the mean of vectors
        self.assertGreater(speed.max(), 0.1)
        self.assertEqual(speed[solid == 0].max(initial=0), 0)

    def check_classes(self, run, tables):
        classes, toe, mill = (tables[name] for name in ("classes", "zones/toe", "zones/mill"))
        self.assertEqual(classes["name"][0].decode().split(), ["ore", "ball"])
        self.assertEqual(list(classes["count"][:]), [300, 80])
        self.assertEqual(list(classes["count_standard_error"][:]), [0, 0])
        # A zone without bounds is the mill.
        for name in ("count", "kinetic_energy", "rotational_energy"):
            numpy.testing.assert_array_equal(mill[name][:], classes[name][:])
        self.assertTrue((toe["count"][:] < classes["count"][:]).all())
        numpy.testing.assert_allclose(mill["kinetic_energy_of_one"][:] * mill["count"][:],
                                      mill["kinetic_energy"][:], rtol=1e-12)
        # The series has the mean kinetic energy of the steps, the classes that of 150 moments.
        time, energy = run["series/time"][:], run["series/kinetic_energy"][:]
        mean = energy[time > 0.05].mean()
        self.assertAlmostEqual(classes["kinetic_energy"][:].sum() / mean, 1, delta=0.05)
        seen = run["series_of_charge"]
        self.assertEqual(len(seen["time"]), 150)
        self.assertAlmostEqual(seen["time"][0], 0.051, delta=1e-9)

    def test_a_resumed_run_and_any_threads_give_the_same_bits(self):
        self.run_scene("--threads", 1)
        straight, figures = contents(self.out / "run.h5"), self.summary()
        self.assertEqual({name.split("/")[0] for name in straight}, set(TABLES))
        self.out = self.folder / "resumed"
        self.run_scene("--threads", 2, "--until", 0.12)
        self.expect(0, quern("resume", self.out, "--threads", 2))
        resumed = contents(self.out / "run.h5")
        self.assertEqual(resumed.keys(), straight.keys())
        for name, value in straight.items():
            self.assertEqual(resumed[name], value, name)
        for name, value in figures.items():
            if any(word in name for word in ("_deg", "steady", "drift", "step_share")):
                self.assertEqual(self.summary()[name], value, name)

    def test_what_is_not_asked_is_not_there(self):
        self.expect(0, quern("run", self.plain, "--out", self.out, *SHORT))
        self.assertEqual(contents(self.out / "run.h5"), {})

    def test_zones_can_be_set(self):
        scene = ["--set", "record.zones.toe.angle_to=300 deg", "--set", "record.classes=false"]
        self.run_scene("--until", 0.06, *scene)
        text = (self.out / "scene.toml").read_text(encoding="utf-8")
        self.assertIn("300 deg", text.replace("5.235987755982989 rad", "300 deg"))
        self.expect(2, quern("check", self.scene, "--set", "record.zones.toes.angle_to=1 deg"),
                    "no zones named 'toes' - did you mean 'toe'?")


class Statements(Case):
    def test_say_whether_the_run_was_steady(self):
        said = self.expect(0, quern("run", LAB_MILL, "--out", self.out, *SHORT))
        summary = self.summary()
        # Dropped in and still falling: whatever it is called, the log and the summary agree.
        self.assertIn(summary["steady_statement"], said.stdout)
        self.assertEqual(summary["steady"], summary["steady_statement"].startswith("steady"))
        self.assertFalse(summary["steady"])

    def test_tell_the_dynamic_angle_and_no_formulas_of_a_laboratory_mill(self):
        self.expect(0, quern("run", LAB_MILL, "--out", self.out, *SHORT))
        summary = self.summary()
        x, y, _ = summary["center_of_mass_m"]
        self.assertAlmostEqual(summary["dynamic_angle_deg"], math.degrees(math.atan2(x, -y)), delta=1)
        self.assertIn("0.3 m", summary["power_formulas"])
        self.assertNotIn("power_within_formulas", summary)


if __name__ == "__main__":
    unittest.main()
