#!/usr/bin/python3
"""An array of six lab mills under Slurm, one of them told by its time limit: it is queued again and
ends in the same state as the same mill run undisturbed.

usage: QUERN_PROGRAM=build/release/quern slurm_loopback.py SLURM_ARRAY_TEXT SCENE FOLDER
(77: skipped, no Slurm. Debian: slurmctld slurmd slurm-client munge)

Slurm runs on the loopback, as the user who starts this, root or not, without systemd, control
groups or a database: one node, this machine, with a configuration and a key of its own in FOLDER.
"""

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

PROGRAM = os.environ["QUERN_PROGRAM"]
# Last the long one, which is told. All differ by their speed of rotation.
DURATIONS = [0.1] * 5 + [10.0]

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


def settings(case):
    return ["--set", "run.settle=none", "--set", "run.record_from=0.02",
            "--set", f"mill.rotation={30 + case} rpm", "--set", f"run.duration={DURATIONS[case]}"]


def run_case(scene, folder, case):
    """What a task runs, in its own place: the mill of the case, or what is left of its run."""
    out = pathlib.Path(folder, str(case))
    command = ["resume", out] if (out / "scene.toml").exists() else \
        ["run", scene, "--out", out, *settings(case)]
    os.execv(PROGRAM, [PROGRAM, *map(str, command), "--threads", "1"])


def undisturbed_hash(scene, folder, case):
    subprocess.run([PROGRAM, "run", scene, "--out", folder, "--threads", "2", *settings(case)],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return summary(folder)["state_hash"]


def summary(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def run_array(array_text, scene, folder):
    """Submits the six, shortens the last one's time to what is over, and waits for all."""
    out = folder / "the cases"  # a name to be quoted
    out.mkdir()
    script = folder / "array.sh"
    script.write_text(said(array_text, out, str(len(DURATIONS)), "500", "60", sys.executable,
                           os.path.abspath(__file__), "--case", scene, out), encoding="utf-8")
    array = said("sbatch", "--parsable", script).strip()
    last = len(DURATIONS) - 1

    def set_limit(minutes):
        said("scontrol", "update", f"JobId={array}_{last}", f"TimeLimit={minutes}")

    wait_until("the long case begins", lambda: (out / str(last) / "run.h5").exists(), 900)
    set_limit(1)
    wait_until("the long case is queued again", lambda: task(array, last)["Restarts"] != "0", 180)
    set_limit(60)
    for case in range(len(DURATIONS)):
        wait_until(f"case {case} ends", lambda case=case: task(array, case)["JobState"] not in (
            "PENDING", "RUNNING", "COMPLETING"), 1800)
    return out, [task(array, case) for case in range(len(DURATIONS))]


def check(scene, folder, out, tasks):
    last = len(DURATIONS) - 1
    log = (out / f"slurm-{last}.log").read_text(encoding="utf-8")
    if log.count("stopped by signal 10 at t = ") != 1:
        sys.exit(f"the long case was not stopped once by SIGUSR1:\n{log}")
    for case, seen in enumerate(tasks):
        straight = undisturbed_hash(scene, folder / f"straight_{case}", case)
        found = summary(out / str(case))
        print(f"case {case}: {seen['JobState']}, queued again {seen['Restarts']} times, "
              f"t = {found['time_s']:g} s, hash {found['state_hash']}, undisturbed {straight}")
        if seen["JobState"] != "COMPLETED" or seen["Restarts"] != str(int(case == last)):
            sys.exit(f"not as it should have gone: {seen}")
        if not found["finished"] or found["state_hash"] != straight:
            sys.exit("another state than undisturbed")
    print(log[log.index("stopped by signal"):].splitlines()[0])


def main():
    if sys.argv[1] == "--case":
        run_case(sys.argv[2], sys.argv[3], int(sys.argv[4]))
    if missing := Cluster.missing():
        print("skipped: not installed: " + ", ".join(missing))
        sys.exit(77)
    array_text, scene, folder = sys.argv[1], os.path.abspath(sys.argv[2]), pathlib.Path(sys.argv[3])
    folder = folder.absolute()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with Cluster(folder):
        out, tasks = run_array(array_text, scene, folder)
    check(scene, folder, out, tasks)


if __name__ == "__main__":
    main()
