#!/usr/bin/python3
"""Holds the decks of bench/peers to the scenes: coefficients, steps, types of walls, speeds.

usage: peer_decks.py BENCH_FOLDER

LAMMPS has one damping for all pairs and one for walls: those of the finest class, as the law
written for LIGGGHTS has them. That law is held to the closed form here. mix_bed is sag_slice_sp's
mixture.
"""

import math
import os
import re
import sys
import tempfile

bench = os.path.abspath(sys.argv[1])
sys.path[:0] = [bench, os.path.join(bench, "peers")]
import states  # noqa: E402

faults = []


def check(right, what):
    if not right:
        faults.append(what)


def near(a, b, what, share=1e-4):  # decks give four digits and more
    check(abs(a - b) <= share * abs(b), f"{what}: {a:g}, not {b:g}")


def read_deck(name, program):
    with open(os.path.join(bench, "peers", f"{name}.{program}"), encoding="utf-8") as file:
        return file.read().replace("&\n", " ")


def law_of(scene):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "law")
        states.write_law(path, scene)
        with open(path, encoding="utf-8") as file:
            text = file.read()
    law = {}
    for key, count, values in re.findall(r"global (\w+) peratomtypepair (\d+) (.*)", text):
        n, values = int(count), [float(v) for v in values.split()]
        law[key] = [values[k:k + n] for k in range(0, n * n, n)]
    return law


def check_lammps(name, scene, law, finest, wall):
    deck, contact = read_deck(name, "lammps"), scene["contact"]
    laws = re.findall(r"hooke/history ([\d.e+-]+) ([\d.e+-]+) ([\d.]+) 0 ([\d.]+) 0", deck)
    check(len(laws) == 2, f"{name}.lammps: a law for pairs and one for walls")
    for (kn, kt, gamma, friction), partner in zip(laws, (finest, wall)):
        near(float(kn), states.quantity(contact["normal_stiffness"]), f"{name}.lammps kn")
        near(float(kt), states.quantity(contact["tangential_stiffness"]), f"{name}.lammps kt")
        near(float(friction), contact["sliding_friction"], f"{name}.lammps friction")
        near(float(gamma), law["gamman"][finest][partner], f"{name}.lammps gamma")


def check_liggghts(name, scene, classes, walls):
    deck = read_deck(name, "liggghts")
    types = {int(t) for t in re.findall(r"\btype (\d+)", deck)}
    check(types == set(range(classes + 1, classes + walls + 1)), f"{name}.liggghts: wall types")
    damped = "on" if scene["contact"].get("tangential_damping", True) else "off"
    check(set(re.findall(r"tangential_damping (\w+)", deck)) == {damped},
          f"{name}.liggghts: tangential_damping")


def check_both(name, scene):
    for program in ("lammps", "liggghts"):
        deck = read_deck(name, program)
        near(float(re.search(r"^timestep (\S+)", deck, re.MULTILINE)[1]),
             states.quantity(scene["run"]["time_step"]), f"{name}.{program} timestep")
        if "mill" in scene:
            found = re.search(r"60/([\d.]+)$|PI\*([\d.]+)/60", deck, re.MULTILINE)
            near(float(found[1] or found[2]), float(scene["mill"]["rotation"].split()[0]),
                 f"{name}.{program} rotation")
        if "motion" in (scene.get("walls") or [{}])[0]:
            near(float(re.search(r"shear x (\S+)", deck)[1]),
                 states.quantity(scene["walls"][0]["motion"]["rate"]), f"{name}.{program} floor")


def check_scene(name):
    scene = states.read_scene(name)
    classes, walls = states.size_classes(scene), states.wall_materials(scene)
    law = law_of(scene)
    finest = min(range(len(classes)), key=lambda k: classes[k][3])
    check_lammps(name, scene, law, finest, len(classes))
    check_liggghts(name, scene, len(classes), len(walls))
    check_both(name, scene)


def check_law():
    """Equal spheres of 20 mm on each other: gamma = 2 zeta sqrt(kn / (m / 2))."""
    mass = 4500 * math.pi / 6 * 0.02**3
    zeta = -math.log(0.3) / math.sqrt(math.pi**2 + math.log(0.3)**2)
    gamma = law_of(states.read_scene("bed"))["gamman"]
    near(gamma[0][0], 2 * zeta * math.sqrt(2e7 * 2 / mass), "law of the bed, pairs", 1e-8)
    near(gamma[0][1], 2 * zeta * math.sqrt(2e7 / mass), "law of the bed, floor", 1e-8)


def check_mixture():
    mix, mill = states.read_scene("mix_bed"), states.read_scene("sag_slice_sp")
    check(states.size_classes(mix) == states.size_classes(mill), "classes of mix_bed")
    counts = [[p["count"]] if "count" in p else [row["count"] for row in p["sizes"]]
              for scene in (mix, mill) for p in scene["particles"]]
    ours, theirs = sum(counts[:2], []), sum(counts[2:], [])
    for a, b in zip(ours, theirs):
        check(a % 16 == 0 and abs(a - b) <= 8, f"mix_bed has {a} where the mill has {b}")
    check(mix["contact"] == mill["contact"], "law of mix_bed")


for scene_name in ("bed", "mix_bed", "sag_slice_sp", "lab_mill_reference"):
    check_scene(scene_name)
check_law()
check_mixture()
print("\n".join(faults))
sys.exit(1 if faults else 0)
