"""quern, LAMMPS and LIGGGHTS as runs that go on by so many steps at a time.

A peer stays alive between its turns: it reads its commands from a pipe and waits, stopped, while
the others run. quern resumes from its checkpoint. Speed is particle steps a second of wall clock,
as each program prints it: upkeep of lists included, start and output not.
"""

import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
from typing import NamedTuple

import h5py

from states import call

HERE = os.path.dirname(os.path.abspath(__file__))


class Result(NamedTuple):
    speed: float     # particle steps a second
    contacts: float  # a particle with particles
    kinetic: float   # J, of all, rotation included
    torque: float    # Nm, of the charge on the mill, mean of the steps; NaN: not known
    memory: float    # bytes a particle, the most so far


class Quern:
    def __init__(self, program, state, threads):
        self.program, self.threads = program, threads
        self.time, self.time_step = state.time, state.time_step
        self.folder = os.path.join(state.work, f"quern_{threads}")
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(state.folder, self.folder)

    def go(self, steps):
        start = self.time
        self.time += steps * self.time_step
        call(self.program, "resume", self.folder, "--threads", str(self.threads), "--until",
             repr(self.time))
        with open(os.path.join(self.folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with h5py.File(os.path.join(self.folder, "run.h5")) as file:
            series = file["series"]
            late = series["time"][:] > start + 1e-9
            if not late.any():
                sys.exit(f"error: {self.folder}/run.h5 has no record in {steps} steps")
            mean = {key: series[key][:][late].mean() for key in
                    ("contacts_per_particle", "kinetic_energy", "rotational_energy", "torque")}
        return Result(summary["particle_steps_per_s"], mean["contacts_per_particle"],
                      mean["kinetic_energy"] + mean["rotational_energy"], mean["torque"],
                      summary["peak_memory_B"] / summary["particles"])

    def end(self):
        shutil.rmtree(self.folder, ignore_errors=True)


class Peer:
    """program: lammps or liggghts; the deck is NAME.PROGRAM of this folder."""

    BINARY = {"lammps": "lmp", "liggghts": "liggghts"}
    READ = {"lammps": "ke c_turning v_contacts", "liggghts": "ke c_turning v_contacts f_torque"}

    def __init__(self, program, name, state, ranks, steps):
        self.ranks = ranks
        self.read = self.READ[program]
        # stdbuf: rows are to come when they are written.
        command = ["stdbuf", "-oL", self.BINARY[program], "-log", "none", "-var", "work",
                   os.path.abspath(state.work), "-var", "steps", str(steps)]
        if ranks > 1:
            root = ["--allow-run-as-root"] if os.getuid() == 0 else []
            command = ["mpirun", *root, "-np", str(ranks), *command]
        self.process = subprocess.Popen(
            command, cwd=HERE, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
        self.send(f"include {name}.{program}")
        self.send('print "deck read"')
        self.read_until("deck read")
        self.pause(signal.SIGSTOP)

    def send(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def read_until(self, start):
        """Lines up to the one that begins so."""
        lines = []
        for line in self.process.stdout:
            lines.append(line)
            if line.startswith(start):
                return lines
        sys.exit(f"error: {' '.join(self.process.args)}\n{''.join(lines[-30:])}")

    def workers(self):
        if self.ranks == 1:
            return [self.process.pid]
        pid = self.process.pid
        with open(f"/proc/{pid}/task/{pid}/children", encoding="utf-8") as file:
            return [int(child) for child in file.read().split()]

    def pause(self, what):
        """Ranks that wait for a message would keep the processors busy."""
        for pid in self.workers():
            os.kill(pid, what)

    def memory(self):
        total = 0
        for pid in self.workers():
            with open(f"/proc/{pid}/status", encoding="utf-8") as file:
                total += sum(1024 * int(line.split()[1]) for line in file
                             if line.startswith("VmHWM"))
        return total

    def timed(self, steps, columns):
        """Particle steps a second, and the columns at the end."""
        self.send(f"thermo_style custom {columns}")
        self.send("thermo_modify norm no")
        self.send(f"run {steps}")
        lines = self.read_until("Loop time of")
        loop = re.search(r"Loop time of (\S+) .* with (\d+) atoms", lines[-1])
        return (int(loop[2]) * steps / float(loop[1]) if steps else 0, int(loop[2]),
                [float(word) for word in lines[-2].split()])

    def go(self, steps):
        self.pause(signal.SIGCONT)
        speed, particles, _ = self.timed(steps, "step")
        # Contacts cost a pass over all pairs: read when the time is taken.
        _, _, (kinetic, turning, contacts, *torque) = self.timed(0, self.read)
        memory = self.memory() / particles
        self.pause(signal.SIGSTOP)
        return Result(speed, contacts, kinetic + turning, torque[0] if torque else math.nan,
                      memory)

    def end(self):
        self.pause(signal.SIGCONT)
        self.process.stdin.close()
        try:
            self.process.stdout.read()
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
