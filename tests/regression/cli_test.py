#!/usr/bin/python3
"""The program seen from outside: exit codes, messages, results, signals.

usage: QUERN_PROGRAM=build/release/quern cli_test.py [CLASS ...]
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
import unittest.mock

import h5py

PROGRAM = os.environ["QUERN_PROGRAM"]
APPS = pathlib.Path(__file__).resolve().parents[2] / "apps"
SCENES = APPS / "scenes"
LAB_MILL = str(SCENES / "lab_mill_spheres.toml")
BOUNCE = str(SCENES / "bounce.toml")

# A mill that turns at once: some seconds of computing.
SHORT = ["--set", "run.settle=none", "--set", "run.duration=0.2", "--set", "run.record_from=0.05"]
LONGER = SHORT + ["--set", "run.duration=0.6"]  # long enough to be interrupted


def quern(*arguments, cwd=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          cwd=cwd, timeout=100, check=False)


class Case(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="quern_cli_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def expect(self, code, result, *texts):
        """The exit code, and texts that standard output or error must hold."""
        said = result.stdout + result.stderr
        self.assertEqual(result.returncode, code, said)
        for text in texts:
            self.assertIn(text, said)
        return result

    def summary(self):
        with open(self.out / "summary.json", encoding="utf-8") as file:
            return json.load(file)


class Info(Case):
    def test_lists_what_the_code_offers(self):
        self.expect(0, quern("info"), "linear-spring-dashpot", "hertz-mindlin", "young_modulus", "normal_stiffness", "N/m", "clamped",
                    "sphere-sphere", "sphere-facet", "polyhedron-sphere",
                    "polyhedron-polyhedron", "polyhedron-facet", "volume_stiffness",
                    "Polyhedron fields", "angular momentum", "model_work", "inverse_mass", "power", "ledger_error",
                    "run.time_step", "mill.lifters.count", "SIMD targets")

    def test_says_how_it_is_used(self):
        self.expect(0, quern("--help"), "run", "resume", "check", "bench", "trade", "shape", "info")
        self.expect(0, quern("--version"), "0.")
        self.expect(2, quern())
        self.expect(2, quern("grind"))
        self.expect(2, quern("run"))


class Check(Case):
    def test_says_what_a_scene_holds_and_costs(self):
        said = self.expect(0, quern("check", LAB_MILL), "380", "kg", "filling", "of critical",
                           "steps per contact", "limit", "memory", "particle steps per second")
        # 380 spheres: 300 of 13.75 mm and 80 of 18 mm in a drum of 300 mm x 40 mm.
        self.assertRegex(said.stdout, r"ball\b")
        self.assertRegex(said.stdout, r"ore\b")

    def test_measures_a_scene_that_rains_in_with_all_particles_there(self):
        said = self.expect(0, quern("check", SCENES / "box_packing.toml"), "at once, to measure",
                           "rain in over")
        rate = re.search(r"; ([0-9.e+]+) particle steps per second .* about (\S+) with", said.stdout)
        self.assertIsNotNone(rate, said.stdout)
        self.assertGreater(float(rate[1]), 1000)
        self.assertNotEqual(rate[2], "-")

    def test_refuses_too_few_steps_per_contact(self):
        self.expect(2, quern("check", LAB_MILL, "--set", "run.time_step=1e-4"), "steps per contact")

    def test_bounds_the_step_of_hertz_mindlin_by_impacts_and_by_the_rayleigh_time(self):
        scene, slow = SCENES / "lab_mill_hertz.toml", "contact.impact_speed=0.01"
        said = self.expect(0, quern("check", scene), "of impacts at 2.43 m/s", "Rayleigh")
        # Two small spheres at the fall through the mill, 4.6e-4 s; and their wave, 1.835e-4 s.
        self.assertRegex(said.stdout, r"small 13.75 mm +small 13.75 mm +45\.8 ")
        self.assertIn("0.0001836 s of small 13.75 mm; the step is 0.0545 of it", said.stdout)
        self.assertNotIn("warning", said.stderr)
        run = ("run", scene, "--out", self.out, "--until", "1e-3", "--set", "run.settle=none")
        self.expect(2, quern(*run, "--set", "run.time_step=1.3e-4"), "steps per contact")
        self.expect(0, quern(*run, "--set", "run.time_step=1e-4", "--set", slow),
                    "0.54 of the Rayleigh time")
        self.expect(2, quern(*run, "--set", "run.time_step=2e-4", "--set", slow),
                    "Rayleigh time", "1 of it is allowed")

    def test_writes_nothing(self):
        self.expect(0, quern("check", BOUNCE, cwd=self.folder))
        self.assertEqual(list(self.folder.iterdir()), [])


class Mistakes(Case):
    def scene(self, find, replace):
        text = pathlib.Path(BOUNCE).read_text(encoding="utf-8")
        self.assertIn(find, text)
        path = self.folder / "scene.toml"
        path.write_text(text.replace(find, replace, 1), encoding="utf-8")
        return path

    def test_in_a_scene_end_with_2_and_a_place(self):
        path = self.scene("restitution = 0.8", "restitutoin = 0.8")
        for command in ("run", "check"):
            self.expect(2, quern(command, path, cwd=self.folder), f"{path}:", "error:",
                        "restitutoin", "did you mean 'restitution'")

    def test_are_told_all_at_once(self):
        path = self.scene('diameter = "20 mm"', 'diameter = "20 kg"\ncuont = 3')
        result = quern("run", path, cwd=self.folder)
        self.expect(2, result, "kg", "cuont")
        self.assertGreaterEqual(result.stderr.count("error:"), 2)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["scene.toml"])

    def test_on_the_command_line_end_with_2(self):
        self.expect(2, quern("run", BOUNCE, "--out", self.out, "--set", "run.duratoin=1"),
                    "run.duratoin", "did you mean")
        self.expect(2, quern("run", BOUNCE, "--threads", "-1"), "threads")
        self.expect(2, quern("run", self.folder / "no_such.toml"), "no_such.toml")

    def test_of_the_system_end_with_3(self):
        self.expect(3, quern("run", BOUNCE, "--out", "/dev/null/out"), "/dev/null/out")
        self.expect(3, quern("resume", self.folder), str(self.folder))
        (self.folder / "checkpoint.h5").write_bytes(b"no checkpoint")
        self.expect(3, quern("resume", self.folder), "checkpoint.h5")


class Summary(Case):
    MEANS = ["power_W", "torque_Nm", "kinetic_energy_J", "rotational_energy_J",
             "contacts_per_particle", "center_of_mass_x_m", "center_of_mass_y_m",
             "center_of_mass_z_m"]
    FIGURES = ["particles", "spheres", "polyhedra", "steps", "time_s", "wall_s", "particle_steps_per_s", "center_of_mass_m",
               "ledger_error", "numerical_loss", "state_hash", "peak_memory_B", "threads",
               "simd_target", "precision", "version"]

    def test_has_every_figure_and_means_with_errors(self):
        self.expect(0, quern("run", LAB_MILL, "--out", self.out, "--threads", 1, *SHORT),
                    "power", "energy", str(self.out))
        summary = self.summary()
        for name in self.FIGURES + self.MEANS:
            self.assertIsNotNone(summary.get(name), name)
        for name in self.MEANS:
            self.assertGreaterEqual(summary[name + "_standard_error"], 0, name)
        self.assertEqual(summary["particles"], 380)
        self.assertEqual((summary["spheres"], summary["polyhedra"]), (380, 0))
        for name in ("model_work_J", "contained_warnings", "bounded_warnings",
                     "wall_depth_warnings"):
            self.assertNotIn(name, summary)
        self.assertEqual(summary["steps"], 20000)
        self.assertAlmostEqual(summary["time_s"], 0.2, delta=1e-9)
        self.assertEqual(summary["threads"], 1)
        self.assertEqual(summary["precision"], "mixed")
        self.assertLess(summary["ledger_error"], 1e-3)
        self.assertEqual(len(summary["center_of_mass_m"]), 3)
        for name in ("scene.toml", "run.h5", "checkpoint.h5"):
            self.assertTrue((self.out / name).is_file(), name)

    def test_tells_the_shape_of_the_charge_on_request(self):
        shape = SHORT + ["--set", "record.charge_shape=true"]
        said = self.expect(0, quern("run", LAB_MILL, "--out", self.out, "--threads", 1, *shape))
        self.assertIn("shoulder", said.stdout)
        straight = self.summary()
        # Dropped in and barely turning: the charge lies in the lower half, its toe on the left.
        self.assertLess(straight["shoulder_deg"], 45)
        self.assertGreater(straight["toe_deg"], 135)
        for name in ("shoulder_deg", "toe_deg"):
            error, spread = straight[name + "_standard_error"], straight[name + "_spread"]
            self.assertGreater(error, 0, name)
            # Of 100 snapshots; ten of them in a block scatter less than one.
            self.assertGreater(spread, error, name)
            self.assertLess(spread, 45, name)
        # The bulk ends further out the lower the limit of its solid fraction.
        self.assertGreaterEqual(straight["shoulder_deg_at_0.4"], straight["shoulder_deg"])
        self.assertLessEqual(straight["shoulder_deg_at_0.6"], straight["shoulder_deg"])
        self.assertLess(abs(straight["shoulder_deg_at_0.4"] - straight["shoulder_deg_at_0.6"]), 45)
        for cut in ("0.4", "0.6"):
            self.assertLess(abs(straight["toe_deg_at_" + cut] - straight["toe_deg"]), 45, cut)
        self.assertEqual(straight["charge_snapshots"], 100)
        picture = (self.out / "charge_shape.svg").read_bytes()
        self.out = self.folder / "resumed"
        self.expect(0, quern("run", LAB_MILL, "--out", self.out, "--until", 0.12, *shape))
        self.expect(0, quern("resume", self.out))
        resumed = self.summary()
        for name in [key for key in straight if "_deg" in key or "charge" in key]:
            self.assertEqual(resumed[name], straight[name], name)
        self.assertEqual((self.out / "charge_shape.svg").read_bytes(), picture)

    def test_without_a_request_there_is_no_shape(self):
        self.expect(0, quern("run", BOUNCE, "--out", self.out, "--until", 0.1))
        self.assertFalse([key for key in self.summary() if "_deg" in key])
        self.assertFalse((self.out / "charge_shape.svg").exists())

    def test_rain_brings_its_energy(self):
        for scene in ("box_packing_spheres", "box_packing"):
            self.expect(0, quern("run", SCENES / f"{scene}.toml", "--out", self.out, "--until", 0.2))
            # Closed but for rounding and free rotation, which the step keeps to second order.
            self.assertLess(self.summary()["ledger_error"], 1e-5)

    def test_until_stops_early_and_resume_goes_on(self):
        self.expect(0, quern("run", BOUNCE, "--out", self.out, "--until", 0.1))
        self.assertAlmostEqual(self.summary()["time_s"], 0.1, delta=1e-5)
        self.assertFalse(self.summary()["finished"])
        self.expect(0, quern("resume", self.out, "--until", 0.2))
        self.assertAlmostEqual(self.summary()["time_s"], 0.2, delta=1e-5)

    def test_a_written_scene_runs_as_the_original(self):
        self.expect(0, quern("run", BOUNCE, "--out", self.out, "--until", 0.2))
        first = self.summary()["state_hash"]
        scene = self.out / "scene.toml"
        self.out = self.folder / "again"
        self.expect(0, quern("run", scene, "--out", self.out, "--until", 0.2))
        self.assertEqual(self.summary()["state_hash"], first)


LAW = """[materials.ore]
density = "4500 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
restitution = 0.5
sliding_friction = 0.3
"""

# Two spheres without gravity, in a domain of their own.
TWO = """format = 1
[run]
duration = "1 ms"
time_step = "1e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[domain]
low = ["-0.1 m", "-0.1 m", "-0.1 m"]
high = ["0.1 m", "0.1 m", "0.1 m"]
""" + LAW + """[[walls]]
name = "floor"
material = "ore"
point = ["0 m", "0 m", "-50 mm"]
normal = [0, 0, 1]
[[particles]]
name = "ball"
material = "ore"
entries = [
  { position = ["0 m", "0 m", "0 m"], diameter = "20 mm"%s },
  { position = ["%s", "0 m", "0 m"], diameter = "20 mm" },
]
"""


# A ball (particle 0) and two rocks (1 and 2).
ROCKS = TWO[:TWO.index("[[particles]]")] + """[[particles]]
name = "rock"
material = "ore"
shape = "polyhedron"
mesh = "%(mesh)s"
entries = [
  { position = ["0 m", "30 mm", "0 m"], diameter = "20 mm"%(motion)s },
  { position = ["30 mm", "30 mm", "0 m"], diameter = "20 mm" },
]
[[particles]]
name = "ball"
material = "ore"
entries = [{ position = ["-30 mm", "30 mm", "0 m"], diameter = "20 mm" }]
"""


class Failures(Case):
    """A run that goes wrong says which particle, where and when, and leaves the state before."""

    def run_two(self, motion="", place="30 mm", *more):
        path = self.folder / "two.toml"
        path.write_text(TWO % (motion, place), encoding="utf-8")
        return quern("run", path, "--out", self.out, "--threads", 1, *more)

    def goes_wrong(self, result, *texts):
        self.expect(4, result, "error:", "t = ", str(self.out / "checkpoint.h5"), *texts)
        self.assertTrue((self.out / "checkpoint.h5").is_file())
        summary = self.summary()
        self.assertFalse(summary["finished"])
        for text in texts:
            self.assertIn(text, summary["error"])

    def test_by_leaving_the_domain(self):
        result = self.run_two(', velocity = ["0 m/s", "300 m/s", "0 m/s"]')
        self.goes_wrong(result, "left the domain", "particle 0 at (0, 0.1")

    def test_by_an_overlap_of_a_radius(self):
        # 300 m/s go 3 mm a step: from 5 mm into a radius of 10 mm before the spring turns them.
        result = self.run_two(', velocity = ["300 m/s", "0 m/s", "0 m/s"]', "25 mm")
        self.goes_wrong(result, "an overlap reached 1.", "particle 0", "against particle 1")
        result = self.run_two(', velocity = ["0 m/s", "0 m/s", "-300 m/s"]')
        self.goes_wrong(result, "an overlap reached 1.", "particle 0", "against wall 'floor'")

    def run_rocks(self, velocity):
        path = self.folder / "rocks.toml"
        motion = ", velocity = [{}]".format(", ".join(f'"{v} m/s"' for v in velocity))
        mesh = APPS / "shapes" / "ore12.stl"
        path.write_text(ROCKS % {"mesh": mesh, "motion": motion}, encoding="utf-8")
        return quern("run", path, "--out", self.out, "--threads", 1)

    def test_of_rocks_name_both(self):
        result = self.run_rocks((300, 0, 0))
        self.goes_wrong(result, "an overlap reached 1.", "particle 2 at (0.03",
                        "against particle 1")
        result = self.run_rocks((-300, 0, 0))
        self.goes_wrong(result, "an overlap reached 1.", "particle 1 at (-0.0",
                        "against particle 0")

    def test_of_a_rock_that_goes_through_a_wall(self):
        # A wall is no thicker than the rock's inner radius: warned of, then lost.
        result = self.run_rocks((0, 0, -300))
        self.goes_wrong(result, "left the domain", "particle 1 at (", ", -0.1")
        self.expect(4, result, "warning:", "deeper than half the smaller radius")
        self.assertGreater(self.summary()["overlap_warnings"], 0)

    @unittest.mock.patch.dict(os.environ)
    def test_by_a_number_that_is_none(self):
        os.environ.pop("QUERN_TRAP_FP", None)
        result = self.run_two(', velocity = ["1e200 m/s", "0 m/s", "0 m/s"]')
        self.goes_wrong(result, "not finite", "particle 0")

    def test_leaves_no_figures_of_another_run(self):
        self.expect(0, self.run_two())
        self.assertTrue(self.summary()["finished"])
        self.expect(4, self.run_two(', velocity = ["0 m/s", "300 m/s", "0 m/s"]'))
        self.assertFalse(self.summary()["finished"])

    def test_deep_overlaps_are_counted_and_warned_of_across_a_resume(self):
        result = self.run_two("", "14 mm", "--until", "2e-5")
        self.expect(0, result, "warning:", "deeper than half the smaller radius")
        before = self.summary()["overlap_warnings"]
        self.assertGreater(before, 0)
        self.expect(0, quern("resume", self.out))
        self.assertGreaterEqual(self.summary()["overlap_warnings"], before)

    def test_few_steps_per_contact_are_warned_of(self):
        self.expect(0, self.run_two("", "30 mm", "--set", "run.time_step=1.5e-4"), "warning:",
                    "steps per contact", "20 are advised")


class Resume(Case):
    COLUMN = """format = 1
[run]
settle = "%s"
duration = "0.02 s"
time_step = "5e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
""" + LAW + """[[walls]]
name = "box"
material = "ore"
low = ["0 m", "0 m", "0 m"]
high = ["50 mm", "50 mm", "50 mm"]
open_top = true
[fill]
method = "rain"
[[particles]]
name = "ball"
material = "ore"
diameter = "10 mm"
count = 300
"""

    def column(self, settle):
        path = self.folder / "column.toml"
        path.write_text(self.COLUMN % settle, encoding="utf-8")
        return path

    def test_where_the_filling_reached_beyond_the_walls(self):
        scene = self.column("none")
        self.expect(0, quern("run", scene, "--out", self.out))
        straight = self.summary()["state_hash"]
        self.out = self.folder / "stopped"
        self.expect(0, quern("run", scene, "--out", self.out, "--until", 0.01))
        self.expect(0, quern("resume", self.out))
        self.assertEqual(self.summary()["state_hash"], straight)
        start = self.out
        self.out = self.folder / "from_file"
        self.expect(0, quern("run", scene, "--out", self.out, "--set", "run.start=file",
                             "--set", f"run.start_file={start}"))
        # The state that it began from is needed no more.
        shutil.rmtree(start)
        self.expect(0, quern("resume", self.out))

    def test_during_settling_ends_as_a_straight_run(self):
        scene = self.column("until-rest")
        # A long bounce: settling ends by its limit, which depends on how far the charge may fall.
        rough = ["--set", "contact.restitution=1", "--set", "contact.sliding_friction=0",
                 "--set", "walls.box.open_top=false",
                 "--set", "particles.ball.count=20", "--threads", "1"]
        self.expect(0, quern("run", scene, "--out", self.out, *rough))
        straight = self.summary()["state_hash"]
        self.out = self.folder / "stopped"
        process = subprocess.Popen([PROGRAM, "run", str(scene), "--out", str(self.out), *rough],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        while not (self.out / "checkpoint.h5").is_file():
            time.sleep(0.002)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertFalse(self.summary()["finished"])
        self.assertEqual(self.summary()["time_s"], 0)  # the mill has not started
        self.expect(0, quern("resume", self.out))
        self.assertEqual(self.summary()["state_hash"], straight)

    def test_of_another_precision_ends_with_2(self):
        self.expect(0, quern("run", BOUNCE, "--out", self.out, "--until", 0.01))
        self.expect(2, quern("run", BOUNCE, "--out", self.folder / "double",
                             "--set", "run.precision=double", "--set", "run.start=file",
                             "--set", f"run.start_file={self.out}"), "start_file", "double", "mixed")
        self.expect(2, quern("run", BOUNCE, "--out", self.folder / "single",
                             "--set", "run.precision=single", "--set", "run.start=file",
                             "--set", f"run.start_file={self.out}"), "start_file", "single", "mixed")

    def test_checkpoints_at_the_end_only_if_asked(self):
        self.expect(0, quern("run", BOUNCE, "--out", self.out, "--until", 0.05,
                             "--set", "output.checkpoint_every=0"))
        # The one before the last is that of the beginning.
        with h5py.File(self.out / "checkpoint.previous.h5") as file:
            self.assertEqual(file.attrs["step"], 0)


class Signals(Case):
    def start(self, *more, stdout=subprocess.PIPE):
        process = subprocess.Popen(
            [PROGRAM, "run", LAB_MILL, "--out", str(self.out), "--threads", "1", *LONGER, *more],
            stdout=stdout, stderr=subprocess.STDOUT, text=True)
        if process.stdout is not None:
            self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        return process

    def wait_for_series(self):
        """Until the mill turns and has written some rows of its series."""
        for _ in range(6000):
            path = self.out / "run.h5"
            if path.is_file() and path.stat().st_mtime > self.begun + 0.3:
                return
            time.sleep(0.01)
        self.fail("the run does not begin")

    def straight_hash(self):
        out, self.out = self.out, self.folder / "straight"
        self.expect(0, quern("run", LAB_MILL, "--out", self.out, "--threads", 1, *LONGER))
        straight, self.out = self.summary(), out
        return straight["state_hash"]

    def interrupt(self, number, *more, times=1):
        self.begun = time.time()
        process = self.start(*more)
        self.wait_for_series()
        for _ in range(times):
            process.send_signal(number)
            time.sleep(0.001)  # else the system makes one of them
        said, _ = process.communicate(timeout=60)
        return process.returncode, said

    def test_leave_a_checkpoint_and_resume_ends_as_a_straight_run(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
            code, said = self.interrupt(number)
            self.assertEqual(code, 0, said)
            self.assertIn("resume", said)
            stopped = self.summary()
            self.assertFalse(stopped["finished"], "the run ended before the signal")
            self.assertTrue((self.out / "checkpoint.h5").is_file())
        self.expect(0, quern("resume", self.out, "--threads", 2))
        self.assertTrue(self.summary()["finished"])
        self.assertEqual(self.summary()["state_hash"], self.straight_hash())

    def test_told_twice_as_timeout_does_leave_a_checkpoint_too(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            code, said = self.interrupt(number, times=3)
            self.assertEqual(code, 0, said)
            self.assertFalse(self.summary()["finished"], "the run ended before the signal")

    def test_told_again_seconds_later_end_at_once(self):
        said, say = os.pipe()
        self.addCleanup(os.close, said)
        self.begun = time.time()
        process = self.start(stdout=say)
        self.wait_for_series()
        # Nobody reads what it says, and there is no room for more: it never gets to its end.
        os.set_blocking(say, False)
        with self.assertRaises(BlockingIOError):
            while True:
                os.write(say, bytes(1))
        os.set_blocking(say, True)
        os.close(say)
        process.send_signal(signal.SIGTERM)
        with self.assertRaises(subprocess.TimeoutExpired):
            process.wait(timeout=3.2)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), -signal.SIGTERM)

    def test_a_killed_run_resumes_from_its_last_checkpoint(self):
        code, _ = self.interrupt(signal.SIGKILL, "--set", "output.checkpoint_every=0.1")
        self.assertEqual(code, -signal.SIGKILL)
        self.expect(0, quern("resume", self.out))
        self.assertTrue(self.summary()["finished"])
        self.assertEqual(self.summary()["state_hash"], self.straight_hash())


if __name__ == "__main__":
    unittest.main()
