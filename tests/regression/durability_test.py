#!/usr/bin/python3
"""What befalls a run from outside: full and read-only disks, damaged and foreign checkpoints, scenes
beyond the memory. (Killed at any moment: killed_runs.py.)

usage: QUERN_PROGRAM=build/release/quern durability_test.py [CLASS ...]
"""

import contextlib
import functools
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import unittest
import zlib

import cli_test
import h5py
import killed_runs

QUICK = [text for setting in killed_runs.SETTINGS for text in ("--set", setting)]
LAB_MILL = str(cli_test.SCENES / "lab_mill.toml")


def limited(*limits):
    """Runs the program under these limits; files that grow too large are an error, no signal."""
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        for which, most in limits:
            resource.setrlimit(which, (most, most))
    return prepare


class Case(cli_test.Case):
    def quern(self, *arguments, prepare=None):
        return subprocess.run([cli_test.PROGRAM, *map(str, arguments)], capture_output=True,
                              text=True, timeout=300, check=False, preexec_fn=prepare)

    def run_scene(self, *more, prepare=None):
        return self.quern("run", LAB_MILL, "--out", self.out, "--threads", 1, *QUICK, *more,
                          prepare=prepare)

    @staticmethod
    @functools.cache
    def hash_in_peace():
        other = Case()
        other.setUp()
        try:
            other.expect(0, other.run_scene())
            return other.summary()["state_hash"]
        finally:
            other.doCleanups()

    def ends_as_in_peace(self):
        self.expect(0, self.quern("resume", self.out, "--threads", 1))
        self.assertTrue(self.summary()["finished"])
        self.assertEqual(self.summary()["state_hash"], self.hash_in_peace())


def seal(path):
    """The end of a checkpoint, lost when other programs write to it: io/seal.h."""
    whole = path.read_bytes()
    path.write_bytes(whole + b"quernsum" + zlib.crc32(whole).to_bytes(8, "little"))


@contextlib.contextmanager
def small_disk(test, size):
    """A file system of so many bytes in a name space of its own, as a path; skips where that is not
    allowed."""
    command = f"mount -t tmpfs -o size={size} small {test.folder} && echo mounted && exec sleep 600"
    process = subprocess.Popen(["unshare", "-rm", "sh", "-c", command], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    try:
        if process.stdout.readline() != "mounted\n":
            test.skipTest("no file system can be mounted here: " + process.stderr.read().strip())
        yield pathlib.Path(f"/proc/{process.pid}/root{test.folder}"), process.pid
    finally:
        process.kill()
        process.communicate()


class DiskFull(Case):
    """Ends with 3, the file and the reason; with room again the run goes on as if nothing had been."""

    def goes_on(self, full, make_room):
        self.expect(3, full, "error: cannot write")
        self.assertRegex(full.stderr, "No space left on device|File too large")
        make_room()
        self.ends_as_in_peace()

    def test_wherever_it_fills(self):
        self.hash_in_peace()
        # All that the run leaves is some 20 MB. Room for less than one checkpoint; then for more and
        # more of frames and series.
        with small_disk(self, "60m") as (disk, _):
            self.out = disk / "out"
            ballast = disk / "ballast"
            for room in (30_000, 400_000, 1_200_000, 2_500_000, 4_000_000, 6_000_000):
                with self.subTest(room=room):
                    ballast.write_bytes(bytes((60 << 20) - room))
                    self.goes_on(self.run_scene(), ballast.unlink)
                shutil.rmtree(self.out)

    def test_where_a_file_may_not_grow(self):
        for most in (5_000, 60_000, 250_000, 400_000):
            with self.subTest(most=most):
                full = self.run_scene(prepare=limited((resource.RLIMIT_FSIZE, most)))
                self.goes_on(full, lambda: None)
            shutil.rmtree(self.out)


class ReadOnly(Case):
    """Ends with 3 and the reason; what is there stays as it was."""

    def test_output_is_refused(self):
        with small_disk(self, "60m") as (disk, pid):
            self.out = disk / "out"
            self.expect(0, self.run_scene("--until", 0.01))
            before = {path: path.read_bytes() for path in self.out.rglob("*") if path.is_file()}
            subprocess.run(["nsenter", "-U", "-m", "--preserve-credentials", "-t", str(pid), "mount",
                            "-o", "remount,ro", str(self.folder)], check=True)
            for result in (self.run_scene(), self.quern("resume", self.out)):
                self.expect(3, result, "error:", "Read-only file system", str(self.out))
            self.out = disk / "other"
            self.expect(3, self.run_scene(), "error:", "Read-only file system", str(self.out))
            self.assertFalse(self.out.exists())
            for path, contents in before.items():
                self.assertEqual(path.read_bytes(), contents, path)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_folder_is_refused(self):
        self.out.mkdir()
        self.out.chmod(0o555)
        self.expect(3, self.run_scene(), "error:", "Permission denied", str(self.out))

    def test_names_that_are_taken_are_refused(self):
        for name in ("run.h5", "checkpoint.h5.tmp", "scene.toml.tmp"):
            (self.out / name).mkdir(parents=True)
            self.expect(3, self.run_scene(), "error: cannot", name.removesuffix(".tmp"))
            shutil.rmtree(self.out)


class Damaged(Case):
    """A damaged checkpoint is noticed, and the one before it is used."""

    def setUp(self):
        super().setUp()
        self.expect(0, self.run_scene("--until", 0.03))
        self.newest = self.out / "checkpoint.h5"
        self.whole = self.newest.read_bytes()

    def leads_to_the_previous_one(self, contents):
        self.newest.write_bytes(contents)
        shutil.copytree(self.out, self.folder / "kept")
        said = self.expect(0, self.quern("resume", self.out, "--threads", 1), "warning: using the "
                           f"previous checkpoint '{self.out}/checkpoint.previous.h5'",
                           f"cannot read checkpoint '{self.newest}'")
        self.assertEqual(self.summary()["state_hash"], self.hash_in_peace(), said.stderr)
        shutil.rmtree(self.out)
        (self.folder / "kept").rename(self.out)

    def test_where_it_is_cut(self):
        for size in (0, 100, len(self.whole) // 2, len(self.whole) - 1):
            with self.subTest(size=size):
                self.leads_to_the_previous_one(self.whole[:size])

    def test_where_bytes_are_flipped(self):
        with h5py.File(self.newest) as file:
            chunk = file["state/particles/record"].id.get_chunk_info(0)
        for name, at in (("signature", 3), ("state", chunk.byte_offset + chunk.size // 2)):
            with self.subTest(where=name):
                damaged = bytearray(self.whole)
                damaged[at] ^= 0x10
                self.leads_to_the_previous_one(bytes(damaged))

    def test_if_both_are_nothing_is_touched(self):
        (self.out / "checkpoint.previous.h5").write_bytes(self.whole[:5000])
        self.newest.write_bytes(self.whole[:5000])
        series = (self.out / "run.h5").read_bytes()
        self.expect(3, self.quern("resume", self.out), "no usable checkpoint",
                    "checkpoint.h5'", "checkpoint.previous.h5'")
        self.assertEqual((self.out / "run.h5").read_bytes(), series)


class Foreign(Case):
    """Checkpoints of another version or scene are refused with the reason."""

    def test_version(self):
        self.expect(0, self.run_scene("--until", 0.01))
        for name in ("checkpoint.h5", "checkpoint.previous.h5"):
            with h5py.File(self.out / name, "r+", libver="v110") as file:
                file.attrs.modify("format", file.attrs["format"] + 1)
            seal(self.out / name)
        self.expect(3, self.quern("resume", self.out), "it has format", "this program reads format")

    def test_scene(self):
        self.expect(0, self.run_scene("--until", 0.01))
        other, self.out = self.out, self.folder / "other"
        self.expect(0, self.run_scene("--until", 0.01, "--set", "particles.ball.count=21"))
        for name in ("checkpoint.h5", "checkpoint.previous.h5"):
            shutil.copy(other / name, self.out / name)
        self.expect(2, self.quern("resume", self.out), "checkpoint of another scene", "count = 20",
                    "count = 21")

    def test_state_of_another_scene(self):
        self.expect(0, self.run_scene("--until", 0.01))
        bounce = self.folder / "bounce"
        self.expect(0, self.quern("run", cli_test.BOUNCE, "--out", bounce, "--until", 0.01))
        self.expect(3, self.quern("run", LAB_MILL, "--out", self.folder / "from", *QUICK, "--set",
                                  "run.start=file", "--set", f"run.start_file={bounce}"),
                    "the checkpoint is of another scene or version")

    def test_of_none_yet_the_run_begins_anew(self):
        self.expect(0, self.run_scene("--until", 0.001))
        for path in list(self.out.glob("*.h5")) + [self.out / "summary.json"]:
            path.unlink()
        shutil.rmtree(self.out / "frames")
        self.ends_as_in_peace()


class TooLarge(Case):
    """Refused by its estimate, before anything large is made."""

    SAG_SLICE = str(cli_test.SCENES / "sag_slice_small_sp.toml")

    def refused(self, *arguments, prepare=None):
        process = subprocess.Popen([cli_test.PROGRAM, *map(str, arguments)], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=prepare)
        said = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        process.communicate()
        self.assertEqual(process.returncode, 3, said)
        self.assertIn("too large for this machine", said)
        self.assertLess(usage.ru_maxrss * 1024, 100e6)
        return said

    def test_for_the_machine(self):
        for command in (["run", self.SAG_SLICE, "--out", self.out], ["check", self.SAG_SLICE]):
            said = self.refused(*command, "--set", "particles.ball.count=990000000")
            self.assertRegex(said, r"9\.9e\+08 spheres and 0 polyhedra need about 1\.09e\+03 GB of "
                             r"memory, [0-9.e+]+ GB are available")
        self.assertFalse(self.out.exists())

    def test_for_the_limits_of_the_process(self):
        # 35 363 spheres at 1100 B and 150 MB.
        address_space = (resource.RLIMIT_AS, 180_000_000)
        said = self.refused("check", self.SAG_SLICE, prepare=limited(address_space))
        self.assertIn("about 0.189 GB of memory, 0.18 GB", said)

    def test_check_tells_what_it_expects_and_that_holds(self):
        said = self.expect(0, self.quern("check", self.SAG_SLICE, "--threads", 1)).stdout
        expected = float(re.search(r"about (\d+) MB expected of a run, \d+ MB available", said)[1])
        found = float(re.search(r"(\d+) MB peak so far", said)[1])
        # Nothing is recorded yet, and the loose charge has fewer contacts than the settled one.
        self.assertGreater(found, expected - 150)
        self.assertLess(found, expected)


if __name__ == "__main__":
    unittest.main()
