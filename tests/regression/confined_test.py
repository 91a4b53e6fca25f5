#!/usr/bin/python3
"""quern opens no network, runs no other program, and writes only under its output folder, whatever a
scene says: seen by strace, system call by system call.

usage: QUERN_PROGRAM=build/release/quern confined_test.py    (77: skipped, no strace)
"""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import cli_test
import killed_runs

QUICK = [text for setting in killed_runs.SETTINGS for text in ("--set", setting)]
LAB_MILL = str(cli_test.SCENES / "lab_mill.toml")
CALL = re.compile(r"^(\w+)\((.*)\) += (.*)$")
PATH = re.compile(r'"((?:[^"\\]|\\.)*)"')
FORKS = ("fork", "vfork", "clone", "clone3")
HARMLESS = ("wait4", "waitid", "exit", "exit_group", "kill", "tgkill", "rt_sigqueueinfo")
READS = ("access", "faccessat", "faccessat2", "stat", "lstat", "newfstatat", "statx", "readlink",
         "readlinkat", "getcwd", "chdir", "statfs", "getxattr", "lgetxattr", "execve", "execveat")
WRITING_FLAGS = ("O_WRONLY", "O_RDWR", "O_CREAT", "O_TRUNC", "O_APPEND")


def traced(work, command, cwd):
    """The calls of all threads of a command: (name, arguments), and the command's result."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    result = subprocess.run(
        ["strace", "-ff", "-o", work / "trace", "-s", "4096", "-e",
         "trace=%file,%network,%process", *map(str, command)],
        capture_output=True, text=True, cwd=cwd, timeout=300, check=False)
    calls = []
    for path in work.iterdir():
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
            match = CALL.match(line)
            if match:
                calls.append(match.groups()[:2])
    return calls, result


def offences(calls, out, cwd):
    """What of it is forbidden to a program whose output folder is `out`."""
    found, programs = [], 0
    for name, arguments in calls:
        if name in FORKS:
            if "CLONE_THREAD" not in arguments:
                found.append(f"another process: {name}({arguments})")
        elif name.startswith("exec"):
            programs += 1
        elif name in ("open", "openat", "openat2", "creat"):
            if name == "creat" or any(flag in arguments for flag in WRITING_FLAGS):
                found += outside(name, arguments, out, cwd)
        elif name in READS or name in HARMLESS:
            continue
        elif PATH.search(arguments) and not name.startswith(("socket", "connect", "bind", "send")):
            found += outside(name, arguments, out, cwd)
        else:
            found.append(f"network: {name}({arguments})")
    if programs > 1:
        found.append(f"{programs - 1} other programs")
    return found


def outside(name, arguments, out, cwd):
    """Paths that are not below `out`."""
    paths = [(cwd / path).resolve() for path in PATH.findall(arguments)]
    return [f"writes: {name}({arguments})" for path in paths
            if path != out and out not in path.parents and str(path) != "/dev/null"]


class Confined(cli_test.Case):
    def setUp(self):
        super().setUp()
        self.folder = self.folder.resolve()
        self.out = self.folder / "out"

    def watch(self, *arguments, code=0):
        calls, result = traced(self.folder / "trace", [cli_test.PROGRAM, *arguments], self.folder)
        self.expect(code, result)
        self.assertGreater(len(calls), 20)
        self.assertEqual(offences(calls, self.out, self.folder), [])
        return calls

    def test_the_watch_sees_what_is_forbidden(self):
        def seen(command):
            calls, _ = traced(self.folder / "trace", command, self.folder)
            return "\n".join(offences(calls, self.out, self.folder))
        self.assertIn("writes: open", seen(["sh", "-c", "echo x > elsewhere"]))
        self.assertIn("other programs", seen(["sh", "-c", "exec true"]))
        self.assertIn("another process", seen(["sh", "-c", "true | true"]))
        self.assertIn("network: socket", seen([sys.executable, "-c",
                                               "import socket; socket.create_server(('', 0))"]))
        self.assertIn("writes: mkdir", seen(["mkdir", self.out / ".." / "elsewhere"]))

    def test_whatever_it_does(self):
        calls = self.watch("run", LAB_MILL, "--out", self.out, "--threads", 2, *QUICK, "--set",
                           "run.duration=0.012")
        self.assertTrue(any("checkpoint.h5.tmp" in arguments for _, arguments in calls))
        self.watch("resume", self.out, "--threads", 2)
        self.watch("report", self.out)
        shutil.copytree(self.out, self.folder / "twin")
        self.watch("compare", self.out, self.folder / "twin", "--out", self.out / "compare.html")
        self.watch("check", cli_test.BOUNCE)
        self.watch("bench", cli_test.BOUNCE, "--steps", 100, "--repeats", 1, code=4)  # no contact
        self.watch("shape", cli_test.APPS / "shapes" / "cube.stl", "--out", self.out)
        self.watch("info")

    def test_whatever_a_scene_names(self):
        """Names in a scene become names of datasets and files: none leads out of the folder."""
        text = pathlib.Path(LAB_MILL).read_text(encoding="utf-8")
        text = text.replace("../shapes", str(cli_test.APPS / "shapes"))
        zone = '\n[[record.zones]]\nname = "toe"\n'
        scene = self.folder / "scene.toml"
        for evil in ("../../evil", "/tmp/evil", "..", "a/b", "$(touch evil)", "`touch evil`",
                     "; touch evil", "evil\\u0000"):
            for find, replace in (('name = "ball"', f'name = "{evil}"'),
                                  ('group = "media"', f'group = "{evil}"'),
                                  ('name = "toe"', f'name = "{evil}"'),
                                  ("title = ", f'title = "{evil}" # ')):
                with self.subTest(find=find, name=evil):
                    self.assertIn(find, text + zone)
                    scene.write_text((text + zone).replace(find, replace), encoding="utf-8")
                    self.watch("run", scene, "--out", self.out, "--threads", 1, *QUICK, "--until",
                               "1e-3", code=0 if find == "title = " else 2)
                    self.assertEqual(list(self.folder.glob("**/*evil*")), [])


if __name__ == "__main__":
    if shutil.which("strace") is None:
        print("skipped: no strace (apt-get install strace)")
        sys.exit(77)
    unittest.main()
