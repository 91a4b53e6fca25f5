#!/usr/bin/python3
"""A run that records everything, killed by SIGKILL at random moments and resumed each time.

usage: killed_runs.py QUERN SCENE FOLDER KILLS [SEED]

Every process, a resumed one too, is killed at a moment uniform in the first 40 % of the processor
time that a whole run takes, until one comes to the end; then the next run begins. With checkpoints,
frames and series every few milliseconds a kill often strikes while a file is written. After each:
  - what lies in the folder can be read: a checkpoint, the series (or, of a file that the kill tore,
    the copy kept with the checkpoint), every frame that is listed, the texts
  - `quern report` makes a page
  - the next `quern resume` goes on from the newest whole checkpoint
At the end of each run all that it leaves equals what a run left in peace leaves, byte for byte:
the hash of the state, series, tables, frames, figures but for those of the process. (Checkpoints also
hold how far polyhedra were apart when that was last asked: it spares work and depends on resumes.)
"""
import json
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

import h5py

SETTINGS = ["run.settle=0.01 s", "run.duration=0.05", "run.record_from=0.01",
            "particles.ore.count=20", "particles.ball.count=20",
            "output.checkpoint_every=0.01", "output.series_every=1e-3", "output.frames_every=2e-3",
            "output.contacts=true", "record.collisions=true", "record.charge_shape=true",
            "record.classes=true", "record.snapshots_every=2e-3", "wear.flow_pressure=5e9", "wear.cell_size=0.05",
            "wear.archard_coefficient=0.001", "materials.pmma.hardness=20",
            "materials.resin.hardness=20"]
OF_THE_PROCESS = ("threads", "wall_s", "particle_steps_per_s", "rebuild_s", "peak_memory_B")


def say_and_end(text):
    sys.exit(f"FAILED: {text}")


def processor_time(process):
    """Seconds of the main thread so far: other than the clock, the same on a busy machine."""
    with open(f"/proc/{process.pid}/schedstat", encoding="ascii") as file:
        return int(file.read().split()[0]) * 1e-9


def kill_at(process, moment):
    """Kills the process once it has taken so much time; False: it came to its end before."""
    while process.poll() is None:
        if processor_time(process) >= moment:
            process.send_signal(signal.SIGKILL)
            return process.wait() == -signal.SIGKILL
        time.sleep(2e-4)
    return False


def arrays(path):
    """Every dataset of an HDF5 file, all its bytes read."""
    with h5py.File(path) as file:
        found = {}
        file.visititems(lambda name, item: found.update({name: item[()]})
                        if isinstance(item, h5py.Dataset) else None)
        return found


def opens(path):
    try:
        arrays(path)
        return True
    except (OSError, RuntimeError):  # the latter where the file opens and an object lies past its end
        return False


def newest_checkpoint(folder):
    """(time, step) of what resume will start from, or None."""
    for name in ("checkpoint.h5", "checkpoint.previous.h5"):
        if not (folder / name).is_file():
            continue
        if not opens(folder / name):
            say_and_end(f"{folder / name} cannot be read")
        with h5py.File(folder / name) as file:
            return float(file.attrs["time"]), int(file.attrs["step"])
    return None


def look_at(quern, folder):
    """Everything in the folder of a killed run; the names of files that a kill tore."""
    torn = []
    for name in ("run.h5", "run.previous.h5"):
        if (folder / name).is_file() and not opens(folder / name):
            torn.append(name)
    if "run.previous.h5" in torn:
        say_and_end("the kept copy of the series is torn")
    for listing in sorted((folder / "frames").glob("*.series")):
        for frame in json.loads(listing.read_text(encoding="utf-8"))["files"]:
            arrays(folder / "frames" / frame["name"])
    if (folder / "summary.json").is_file():
        json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    if newest_checkpoint(folder) is None:
        return torn
    page = folder.with_suffix(".html")
    report = subprocess.run([quern, "report", folder, "--out", page], capture_output=True,
                            text=True, timeout=300, check=False)
    if report.returncode != 0 or page.stat().st_size < 100000:
        say_and_end(f"no page of the killed run (torn: {torn}): {report.stderr}")
    return torn


def left_by(folder):
    """All that a finished run leaves, but for what differs between processes."""
    with open(folder / "summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    figures = {key: value for key, value in summary.items()
               if key not in OF_THE_PROCESS and not key.endswith("busy_s")}
    tables = {name: data.tobytes() if hasattr(data, "tobytes") else data
              for name, data in arrays(folder / "run.h5").items()}
    files = {path.name: path.read_bytes() for path in sorted((folder / "frames").iterdir())}
    for name in ("scene.toml", "charge_shape.svg"):
        files[name] = (folder / name).read_bytes()
    return {"figures": figures, "tables": tables, "files": files}


def compare(straight, found):
    for kind, wanted in straight.items():
        if wanted.keys() != found[kind].keys():
            say_and_end(f"{kind}: {sorted(wanted.keys() ^ found[kind].keys())} of one run only")
        for name, value in wanted.items():
            if found[kind][name] != value:
                say_and_end(f"{kind}: '{name}' differs from the run left in peace")


class Killer:
    def __init__(self, quern, scene, folder, kills):
        self.quern, self.scene, self.work, self.kills = quern, scene, folder, kills
        self.log = open(folder / "log", "w+", encoding="utf-8")
        self.done, self.torn, self.runs, self.none_yet = 0, 0, 0, 0

    def start(self, *arguments):
        return subprocess.Popen([self.quern, *map(str, arguments)], stdout=self.log,
                                stderr=self.log)

    def begin(self, folder):
        settings = [text for setting in SETTINGS for text in ("--set", setting)]
        return self.start("run", self.scene, "--out", folder, "--threads", 1, *settings)

    def in_peace(self):
        folder = self.work / "in_peace"
        process = self.begin(folder)
        taken = 0
        while process.poll() is None:
            taken = processor_time(process)
            time.sleep(1e-3)
        self.ended_well(process)
        return left_by(folder), taken

    def ended_well(self, process):
        self.log.seek(0)
        if process.returncode != 0:
            say_and_end(f"exit code {process.returncode}: {self.log.read()[-2000:]}")

    def one_run(self, taken):
        """Killed and resumed until it ends; returns its folder."""
        folder = self.work / "killed"
        shutil.rmtree(folder, ignore_errors=True)
        process = self.begin(folder)
        while self.done < self.kills and kill_at(process, random.uniform(0, 0.4 * taken)):
            self.done += 1
            before = newest_checkpoint(folder)
            self.torn += "run.h5" in look_at(self.quern, folder)
            self.none_yet += before is None
            if before is None and not (folder / "scene.toml").is_file():
                process = self.begin(folder)  # killed before it had written anything
                continue
            process = self.start("resume", folder, "--threads", random.choice((1, 2)))
        process.wait()
        self.ended_well(process)
        return folder

    def go(self):
        straight, taken = self.in_peace()
        print(f"left in peace: {taken:.2f} s, {straight['figures']['state_hash']}")
        while self.done < self.kills:
            compare(straight, left_by(self.one_run(taken)))
            self.runs += 1
        print(f"{self.done} kills in {self.runs} runs, {self.none_yet} of them before the first "
              f"checkpoint, {self.torn} tore run.h5; every run ended in the same bytes")


def main():
    quern, scene, folder, kills = sys.argv[1:5]
    seed = int(sys.argv[5]) if len(sys.argv) > 5 else random.SystemRandom().randrange(10**6)
    print(f"seed {seed}")
    random.seed(seed)
    work = pathlib.Path(folder)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    Killer(quern, scene, work, int(kills)).go()


if __name__ == "__main__":
    main()
