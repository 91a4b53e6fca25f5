#!/usr/bin/python3
"""`quern sweep --slurm` of six lab mills under Slurm, one of them told by its time limit: it is queued
again, all end in the state of a local sweep, and the tables are the same bytes.

usage: QUERN_PROGRAM=build/release/quern slurm_loopback.py SCENE FOLDER
(77: skipped, no Slurm. Debian: slurmctld slurmd slurm-client munge)

Slurm runs on the loopback, as the user who starts this, root or not, without systemd, control
groups or a database: one node, this machine, with a configuration and a key of its own in FOLDER.
"""

import csv
import json
import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time

PROGRAM = os.path.abspath(os.environ["QUERN_PROGRAM"])
# All start from one filling. The last is the long one, which is told.
CASES, LONG = 6, 6
SWEEP = """format = 1
scene = "%s"
design = "list"
[set]
run.settle = "0.1 s"
run.record_from = "0.02 s"
[[factors]]
key = "mill.rotation"
values = ["30 rpm", "31 rpm", "32 rpm", "33 rpm", "34 rpm", "35 rpm"]
[[factors]]
key = "run.duration"
values = ["0.1 s", "0.11 s", "0.12 s", "0.13 s", "0.14 s", "10 s"]
"""

CONFIGURATION = """
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
CredType=cred/munge
# A task is not queued again before its credential has expired.
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SlurmdParameters=config_overrides
MinJobAge=86400
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class Cluster:
    """Slurm's daemons in the foreground, each with its log in the folder; ended by `with`."""

    DAEMONS = ("munged", "slurmctld", "slurmd")

    def __init__(self, folder):
        self.folder = folder
        self.started = []

    @classmethod
    def missing(cls):
        return [name for name in (*cls.DAEMONS, "sbatch", "scontrol")
                if not shutil.which(name, path=cls.path())]

    @staticmethod
    def path():
        return os.environ["PATH"] + ":/usr/sbin"

    def __enter__(self):
        os.environ["PATH"] = self.path()
        os.environ["SLURM_CONF"] = str(self.folder / "slurm.conf")
        # Of a job this may run in itself.
        for name in [name for name in os.environ if name.startswith(("SBATCH_", "SLURM_JOB"))]:
            del os.environ[name]
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], ports=free_ports(2), folder=self.folder,
            user=subprocess.check_output(["id", "-un"], text=True).strip()), encoding="utf-8")
        try:
            self.start("munged", "--foreground", "--force", f"--key-file={key}",
                       f"--socket={self.folder}/munge.socket",
                       f"--pid-file={self.folder}/munged.pid",
                       f"--seed-file={self.folder}/munged.seed",
                       f"--log-file={self.folder}/munged.log")
            self.wait("munge", "--no-input", "--socket", f"{self.folder}/munge.socket")
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D")
            self.wait("sh", "-c", "sinfo --noheader --format=%T | grep -q idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self, name, *words):
        with open(self.folder / f"{name}.out", "w", encoding="utf-8") as log:
            self.started.append(subprocess.Popen([name, *words], stdout=log, stderr=log))

    def wait(self, *command):
        """Until a command succeeds; the daemons' last lines if it does not."""
        for _ in range(60):
            if subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              check=False).returncode == 0:
                return
            time.sleep(0.5)
        logs = [f"{path.name}:\n" + "\n".join(path.read_text(errors="replace").splitlines()[-8:])
                for path in sorted(self.folder.glob("*.out"))]
        sys.exit(f"failed: {' '.join(command)}\n" + "\n".join(logs))

    def __exit__(self, *_):
        for daemon in reversed(self.started):
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(timeout=60)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def said(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def task(array, case):
    """What Slurm knows of a task."""
    text = said("scontrol", "--oneliner", "show", "job", f"{array}_{case}")
    return dict(word.split("=", 1) for word in text.split() if "=" in word)


def wait_until(what, holds, seconds):
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            sys.exit(f"{what}: not within {seconds} s\n" + said("scontrol", "show", "job"))
        time.sleep(1)


def sweep(file, out, *more):
    print(said(PROGRAM, "sweep", file, "--out", out, *map(str, more)), end="", flush=True)


def summaries(out):
    """Of each case, in the order of the table."""
    with open(out / "sweep.csv", encoding="utf-8", newline="") as file:
        names = [row["case"] for row in csv.DictReader(file)]
    return {name: json.loads((out / name / "summary.json").read_text(encoding="utf-8"))
            for name in names}


def run_arrays(file, out):
    """Submits the six, shortens the long one's time to what is over, and waits for all."""
    sweep(file, out, "--slurm", "--time-limit", "1 h")
    numbers = said("squeue", "--noheader", "--format=%F", "--sort=i").split()
    if len(set(numbers)) != 2:
        sys.exit(f"two arrays were to be there: {numbers}")
    array = numbers[-1]

    def set_limit(minutes):
        said("scontrol", "update", f"JobId={array}_{LONG}", f"TimeLimit={minutes}")

    wait_until("the long case begins", lambda: list(out.glob("*10s/run.h5")), 900)
    set_limit(1)
    wait_until("the long case is queued again", lambda: task(array, LONG)["Restarts"] != "0", 180)
    set_limit(60)
    for case in range(1, CASES + 1):
        wait_until(f"case {case} ends", lambda case=case: task(array, case)["JobState"] not in (
            "PENDING", "RUNNING", "COMPLETING"), 1800)
    sweep(file, out, "--collect")
    return [task(array, case) for case in range(1, CASES + 1)]


def check(local, out, tasks):
    log = (out / f"slurm/case-{LONG}.log").read_text(encoding="utf-8")
    if log.count("stopping: the runs write their checkpoints") != 1:
        sys.exit(f"the long case was not told once:\n{log}")
    straight, here = summaries(local), summaries(out)
    for case, (seen, name) in enumerate(zip(tasks, straight, strict=True), 1):
        found, wanted = here[name], straight[name]["state_hash"]
        print(f"{name}: {seen['JobState']}, queued again {seen['Restarts']} times, "
              f"t = {found['time_s']:g} s, hash {found['state_hash']}, undisturbed {wanted}")
        if seen["JobState"] != "COMPLETED" or seen["Restarts"] != str(int(case == LONG)):
            sys.exit(f"not as it should have gone: {seen}")
        if not found["finished"] or found["state_hash"] != wanted:
            sys.exit("another state than undisturbed")
    for name in ("sweep.csv", "sweep.h5"):
        if (local / name).read_bytes() != (out / name).read_bytes():
            sys.exit(f"{name} is another than that of the local sweep")
    long_log = next(out.glob("*10s")) / "log.txt"
    print(next(line for line in long_log.read_text(encoding="utf-8").splitlines()
               if line.startswith("stopped by signal")))
    print("sweep.csv, sweep.h5: the same bytes")


def main():
    if missing := Cluster.missing():
        print("skipped: not installed: " + ", ".join(missing))
        sys.exit(77)
    scene, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    file, out, local = folder / "six mills.toml", folder / "the cases", folder / "local"
    file.write_text(SWEEP % scene, encoding="utf-8")
    with Cluster(folder):
        tasks = run_arrays(file, out)
    sweep(file, local, "--threads", "1")
    check(local, out, tasks)


if __name__ == "__main__":
    main()
