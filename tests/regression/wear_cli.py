#!/usr/bin/python3
"""A run with [wear]: its tables, figures and frames say the same, the profile holds what the cells
hold, and a run that was stopped ends in the same numbers.

usage: QUERN_PROGRAM=build/release/quern wear_cli.py
"""

import unittest

import cli_test
import h5py
import numpy as np

MM_PER_1000_HOURS = 3.6e9  # of m/s
MODELS = ("siem", "sliding", "archard", "finnie")
# 300 mm x 40 mm, 18 lifters; of its walls no hardness is known.
WEAR = cli_test.SHORT + ["--set", "wear.flow_pressure=5e9", "--set", "wear.cell_size=0.004",
                         "--set", "wear.archard_coefficient=0.001", "--set",
                         "materials.pmma.hardness=20", "--set", "wear.siem_factor=2"]


class Wear(cli_test.Case):
    def tables(self):
        with h5py.File(self.out / "run.h5") as file:
            def read(group):
                return {name: data[()] for name, data in group.items()
                        if isinstance(data, h5py.Dataset)}
            return ({name: read(group) for name, group in file["wear"].items()},
                    read(file["wear_profile"]), read(file["wear_of_groups"]))

    def test_tables_figures_and_frames_agree_after_a_stop_too(self):
        command = ["run", cli_test.LAB_MILL, *WEAR, "--out", self.out]
        self.expect(0, cli_test.quern(*command, "--set", "output.frames_every=0.2"),
                    "wear", "siem", "factor 2")
        walls, profile, groups = self.tables()
        summary = self.summary()
        self.assertEqual(set(walls), {"liner", "ends"})
        self.assertAlmostEqual(summary["wear_recorded_s"], 0.15, 9)
        for model in MODELS:
            total = sum(wall[f"volume_{model}"].sum() for wall in walls.values())
            self.assertGreater(total, 0, model)
            self.assertAlmostEqual(total / summary[f"wear_{model}_m3"], 1, 12)
            for wall in walls.values():
                volume = (wall[f"depth_rate_{model}"] * wall["area"]).sum() * 0.15
                self.assertAlmostEqual(
                    volume / MM_PER_1000_HOURS / wall[f"volume_{model}"].sum(), 1, 9)
        self.assertEqual(summary["wear_siem_factor"], 2)
        liner = walls["liner"]
        self.assertTrue(np.allclose(liner["volume_siem"], 2 * liner["energy_siem"] / 2e10,
                                    rtol=1e-12))
        # The profile: mean of 18 lifters over the length of the mill.
        arc = profile["arc"]
        width = np.empty_like(arc)
        begin = 0
        for k, middle in enumerate(arc):
            width[k] = 2 * (middle - begin)
            begin += width[k]
        for model in MODELS:
            worn = (profile[model] * width).sum() * 0.15 * 0.04 * 18 / MM_PER_1000_HOURS
            self.assertAlmostEqual(worn / liner[f"volume_{model}"].sum(), 1, 6)
        self.assertEqual(len(profile["siem_spread"]), len(arc))
        # Of the groups only that whose material has a hardness.
        self.assertEqual(np.isnan(groups["volume_siem"]).sum(), 1)
        self.assertEqual(np.isnan(groups["volume_finnie"]).sum(), 1)
        with h5py.File(self.out / "frames" / "liner_000001.hdf") as file:
            data = file["VTKHDF/CellData"]
            area = np.concatenate([walls["liner"]["area"], walls["ends"]["area"]])
            worn = (data["wear_depth_siem"][:] * area).sum()
            self.assertAlmostEqual(worn / summary["wear_siem_m3"], 1, 5)
            self.assertEqual(len(data["pressure"]), len(area))
            self.assertEqual(file["VTKHDF/NumberOfCells"][0], len(area))
        self.out = self.folder / "stopped"
        self.expect(0, cli_test.quern(*command[:-1], self.out, "--until", 0.1))
        self.expect(0, cli_test.quern("resume", self.out, "--threads", 2))
        self.assertEqual(self.summary()["state_hash"], summary["state_hash"])
        again = self.tables()[0]["liner"]
        for name, values in liner.items():
            self.assertTrue(np.array_equal(values, again[name]), name)


if __name__ == "__main__":
    unittest.main()
