"""Settled and turning states of the benchmark scenes, and their hand-over to other programs.

state() makes a folder of `quern run` that stops at a time, from where `quern resume` goes on; it is
kept and used again. hand_over() writes what the decks read: spheres.data (places, velocities and
spins then), wall_0.stl ... (the mill as it stands then, from the engine's own triangles) and
law.liggghts (coefficients of all pairs of classes and walls).
"""

import json
import math
import os
import re
import subprocess
import sys
import tomllib
from typing import NamedTuple

import h5py
import numpy as np

import scene_speed

BENCH = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = os.path.join(os.path.dirname(BENCH), "apps", "scenes")
UNITS = {"m": 1, "mm": 1e-3, "s": 1, "ms": 1e-3, "m/s": 1, "rpm": math.pi / 30, "kg/m^3": 1,
         "N/m": 1}
ROOM = 1.0  # s of duration that a state has left


class Size(NamedTuple):
    """What of a scene is run: a share of its particles, for trials in less space."""
    share: int = 1
    settings: tuple = ()
    turn: float = 0.0  # s that the mill has turned before the programs start


class Column(NamedTuple):
    """Of a bed: a piece with 1 / share of the particles is settled and repeated along x."""
    share: int
    length: float
    width: float
    fill: float  # m, height of the loose filling
    times: int


class State(NamedTuple):
    folder: str  # of the run
    work: str    # of what is handed over
    time: float
    time_step: float


def quantity(text):
    value, unit = text.split()
    return float(value) * UNITS[unit]


def read_scene(name):
    with open(os.path.join(SCENES, name + ".toml"), "rb") as file:
        return tomllib.load(file)


def call(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(command)}\n{result.stderr[-2000:]}")


def run(program, scene, folder, until, settings):
    command = [program, "run", scene, "--out", folder, "--until", repr(until)]
    for setting in (*scene_speed.PLAIN, *settings):
        command += ["--set", setting]
    call(*command)


def is_done(folder, until):
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    except FileNotFoundError:
        return False
    return "error" not in summary and summary["time_s"] > until - 1e-9


def write_scene(path, name, share, particles=None):
    """The scene with a share of its particles, or with other [[particles]] altogether."""
    with open(os.path.join(SCENES, name + ".toml"), encoding="utf-8") as file:
        text = file.read()
    if particles is not None:
        text = text[:text.index("[[particles]]")] + particles + text[text.index("[output]"):]
    first = text.index("[[particles]]")
    text = text[:first] + re.sub(r"count = (\d+)", lambda m: f"count = {int(m[1]) // share}",
                                 text[first:])
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def tile(column, folder, csv, names, speed):
    """Writes the settled column, repeated along x, all moving at `speed`; species by name."""
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        last = file["final_particles"]
        x, radius = last["position"][:], last["radius"][:].astype(float)
        species = last["species"][:]
    x[:, 0] %= column.length
    x[:, 1] %= column.width
    with open(csv, "w", encoding="utf-8") as out:
        out.write("x,y,z,diameter,vx,class\n")
        for k in range(column.times):
            for p, r, s in zip(x, radius, species):
                out.write(f"{p[0] + k * column.length:.12g},{p[1]:.12g},{p[2]:.12g},{2 * r:.9g},"
                          f"{speed},{names[s]}\n")


def travelling_bed(program, name, work, column):
    """The scene file of the repeated column, and what is to be set."""
    scene = read_scene(name)
    settled, path = os.path.join(work, "column"), os.path.join(work, "column.toml")
    top = quantity(scene["domain"]["high"][2])
    corner = lambda length, z: f'["{length} m", "{column.width} m", "{z} m"]'
    if not is_done(settled, 0):
        write_scene(path, name, column.share)
        run(program, path, settled, 0,
            [f"domain.high={corner(column.length, top)}",
             f"fill.high={corner(column.length, column.fill)}", "output.frames_every=0"])
    species = scene["particles"]
    tile(column, settled, os.path.join(work, "bed.csv"), [s["name"] for s in species],
         quantity(scene["walls"][0]["motion"]["rate"]))
    particles = "".join(f'[[particles]]\nname = "{s["name"]}"\nmaterial = "{s["material"]}"\n'
                        'csv = "bed.csv"\n\n' for s in species)
    path = os.path.join(work, "travelling.toml")
    write_scene(path, name, 1, particles)
    length = round(column.times * column.length, 9)
    return path, [f"domain.high={corner(length, top)}", "run.settle=none"]


def settled_scene(program, name, size, work, top):
    """The scene file and settings of a run that begins settled; a share settles first."""
    if size.share == 1:
        checkpoint = scene_speed.settle(program, name, top, os.cpu_count() or 1)
        return os.path.join(SCENES, name + ".toml"), [
            "run.settle=none", "run.start=file", f"run.start_file={checkpoint}"]
    path = os.path.join(work, "scene.toml")
    write_scene(path, name, size.share)
    return path, size.settings


def state(program, name, size, top, trial):
    """The scene's state, made if it is not there."""
    work = os.path.join(top, "peers_small" if trial else "peers", name)
    folder = os.path.join(work, "state")
    os.makedirs(work, exist_ok=True)
    time_step = quantity(read_scene(name)["run"]["time_step"])
    turn = 0.0 if isinstance(size, Column) else size.turn
    if not is_done(folder, turn):
        print(f"# {name}: getting ready ...", flush=True)
        path, settings = (travelling_bed(program, name, work, size) if isinstance(size, Column)
                          else settled_scene(program, name, size, work, top))
        run(program, path, folder, turn,
            [f"run.duration={turn + ROOM}", "run.record_from=0", "output.frames_every=0",
             f"output.series_every={10 * time_step}", *settings])
    return State(folder, work, turn, time_step)


def size_classes(scene):
    """(species, material, density, from, to) of each class, in order."""
    found = []
    for k, species in enumerate(scene["particles"]):
        rows = species.get("sizes") or [{"from": species["diameter"], "to": species["diameter"]}]
        for row in rows:
            found.append((k, species["material"],
                          quantity(scene["materials"][species["material"]]["density"]),
                          quantity(row["from"]), quantity(row["to"])))
    return found


def wall_materials(scene):
    mill = scene.get("mill", {})
    named = [mill.get("material"), mill.get("end_material")]
    named += [wall["material"] for wall in scene.get("walls", [])]
    return [name for name in dict.fromkeys(named) if name]


def box(state_, scene):
    """Low and high corner for other programs: the scene's, or that of its mill."""
    domain = scene.get("domain", {})
    if "low" in domain:
        with open(os.path.join(state_.folder, "scene.toml"), "rb") as file:
            domain = tomllib.load(file)["domain"]
        return [np.array([quantity(text) for text in domain[key]]) for key in ("low", "high")]
    reach, length = 0.55 * quantity(scene["mill"]["diameter"]), quantity(scene["mill"]["length"])
    beyond = 0 if scene["mill"]["ends"] == "periodic" else 0.1 * length
    return np.array([-reach, -reach, -beyond]), np.array([reach, reach, length + beyond])


def write_spheres(path, state_, scene, low, high):
    with h5py.File(os.path.join(state_.folder, "run.h5")) as file:
        last = file["final_particles"]
        x, v, w = (last[key][:].astype(float) for key in ("position", "velocity", "spin"))
        diameter, species = 2 * last["radius"][:].astype(float), last["species"][:]
    axes = scene.get("domain", {}).get("periodic", ["z"] if "mill" in scene and
                                       scene["mill"]["ends"] == "periodic" else [])
    for axis in ("xyz".index(letter) for letter in axes):
        x[:, axis] = low[axis] + np.mod(x[:, axis] - low[axis], high[axis] - low[axis])
    classes = size_classes(scene)
    kind = np.zeros(len(x), int)
    for k, (s, _, _, small, large) in enumerate(classes):
        kind[(species == s) & (diameter > small * (1 - 1e-6)) & (kind == 0)
             & (diameter < large * (1 + 1e-6))] = k + 1
    if (kind == 0).any():
        sys.exit("error: a sphere of no size class")
    density = np.array([0] + [c[2] for c in classes])[kind]
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"spheres\n\n{len(x)} atoms\n"
                  f"{len(classes) + len(wall_materials(scene))} atom types\n\n")
        for axis, a, b in zip("xyz", low, high):
            out.write(f"{a:.9g} {b:.9g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for k, (t, d, rho, p) in enumerate(zip(kind, diameter, density, x)):
            out.write(f"{k + 1} {t} {d:.9g} {rho:g} {p[0]:.15g} {p[1]:.15g} {p[2]:.15g}\n")
        out.write("\nVelocities\n\n")
        for k, row in enumerate(np.hstack([v, w])):
            out.write(f"{k + 1} {' '.join(f'{value:.9g}' for value in row)}\n")
    mass = density * np.pi / 6 * diameter**3
    return len(x), float(np.median(mass)), float(np.median(diameter))


def write_law(path, scene):
    """The coefficients of LIGGGHTS. Its dashpot is gamma m_eff v, gamma = 2 zeta sqrt(k / m_eff) of
    the mean masses of two classes, or of a class and a wall."""
    contact, classes, walls = scene["contact"], size_classes(scene), wall_materials(scene)
    materials = [c[1] for c in classes] + walls
    cubes = [(a + b) * (a**2 + b**2) / 4 for _, _, _, a, b in classes]  # mean d^3, d uniform
    inverse = [6 / (math.pi * c[2] * d3) for c, d3 in zip(classes, cubes)] + [0.0] * len(walls)
    pairs = {frozenset(p["between"]): p["restitution"] for p in contact.get("pair", [])}
    stiffness = quantity(contact["normal_stiffness"])
    tangential = quantity(contact["tangential_stiffness"])

    def gamma(i, j):
        if inverse[i] + inverse[j] == 0:
            return 1.0  # of two walls
        between = frozenset((materials[i], materials[j]))
        log_e = math.log(pairs[between] if between in pairs else contact["restitution"])
        return 2 * -log_e / math.hypot(math.pi, log_e) * math.sqrt(
            stiffness * (inverse[i] + inverse[j]))

    n = len(materials)
    with open(path, "w", encoding="utf-8") as out:
        def each(key, value):
            out.write(f"fix law_{key} all property/global {key} peratomtype {f'{value} ' * n}\n")

        def all_pairs(key, value):
            out.write(f"fix law_{key} all property/global {key} peratomtypepair {n} "
                      + " ".join(f"{value(i, j):.9g}" for i in range(n) for j in range(n)) + "\n")

        each("youngsModulus", 5e6)  # asked for, not used
        each("poissonsRatio", 0.3)
        all_pairs("coefficientFriction", lambda i, j: contact["sliding_friction"])
        all_pairs("kn", lambda i, j: stiffness)
        all_pairs("kt", lambda i, j: tangential)
        all_pairs("gamman", gamma)
        all_pairs("gammat", lambda i, j: math.sqrt(tangential / stiffness) * gamma(i, j))
        damped = "on" if contact.get("tangential_damping", True) else "off"
        out.write("pair_style gran model hooke/stiffness tangential history tangential_damping "
                  f"{damped}\npair_coeff * *\n")


def write_walls(program, state_, scene):
    """wall_0.stl ...: the triangles of a frame of the mill, turned to the state's time."""
    folder = os.path.join(state_.work, "walls")
    run(program, os.path.join(state_.folder, "scene.toml"), folder, state_.time_step,
        ["run.start=file", f"run.start_file={os.path.abspath(state_.folder)}/checkpoint.h5",
         f"output.frames_every={state_.time_step}"])
    with h5py.File(os.path.join(folder, "frames", "liner_000001.hdf")) as file:
        points = file["VTKHDF/Points"][:].astype(float)
        corners = file["VTKHDF/Connectivity"][:].reshape(-1, 3)
        wall, time = file["VTKHDF/CellData/wall"][:], file.attrs["time"]
    angle = quantity(scene["mill"]["rotation"]) * (state_.time - time)
    c, s = math.cos(angle), math.sin(angle)
    points = points @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T
    if scene["mill"]["ends"] == "periodic":  # the engine's shell reaches beyond the faces
        points[:, 2] = np.clip(points[:, 2], 0, quantity(scene["mill"]["length"]))
    for k in np.unique(wall):
        with open(os.path.join(state_.work, f"wall_{k}.stl"), "w", encoding="utf-8") as out:
            out.write("solid wall\n")
            for a, b, d in points[corners[wall == k]]:
                normal = np.cross(b - a, d - a)
                out.write("facet normal {:.9g} {:.9g} {:.9g}\n outer loop\n".format(
                    *(normal / np.linalg.norm(normal))))
                for p in (a, b, d):
                    out.write("  vertex {:.9g} {:.9g} {:.9g}\n".format(*p))
                out.write(" endloop\nendfacet\n")
            out.write("endsolid wall\n")


def hand_over(program, name, state_):
    """Writes all that the decks of the scene read; number, median mass and diameter of spheres."""
    scene = read_scene(name)
    low, high = box(state_, scene)
    found = write_spheres(os.path.join(state_.work, "spheres.data"), state_, scene, low, high)
    write_law(os.path.join(state_.work, "law.liggghts"), scene)
    if "mill" in scene:
        write_walls(program, state_, scene)
    return found
