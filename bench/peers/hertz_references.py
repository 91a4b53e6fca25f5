#!/usr/bin/env python3
"""Makes the references of law = "hertz-mindlin" with LIGGGHTS: hertz_references.py OUT [impacts|mill]

impacts  hertz_impacts_plane.csv, hertz_impacts_pair.csv: oblique impacts at 18 angles
mill     hertz_lab_mill.json: the mill of apps/scenes/lab_mill_hertz.toml, 4 seeds

Both stand in tests/golden, with what they are in its README. Needs the Debian package liggghts (3.8.0).
"""

import csv
import json
import math
import os
import random
import subprocess
import sys

GOLDEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "golden")
ANGLES = range(0, 90, 5)
GAP = 1e-6  # m
# e, E and nu of both, mu, diameter, density, v0, step. Without tangential damping: the solver's dashpot
# is not cut to the cone, and friction passes Coulomb's limit with it.
CASES = (
    (0.3, 1e9, 0.3, 3e8, 0.2, 0.5, 0.02, 4500, 3.0, 1e-7),
    (0.8, 1e9, 0.3, 1e9, 0.3, 0.5, 0.02, 4500, 3.0, 1e-7),
    (0.75, 5e7, 0.3, 5e7, 0.3, 0.3, 0.01375, 1190, 1.0, 1e-6),
)
NAMES = "restitution young poisson young2 poisson2 mu diameter density v0 dt".split()
FORMAT = " ".join(["%d"] + ["%.15g"] * 9)


def liggghts(deck, folder):
    path = os.path.join(folder, "deck")
    with open(path, "w", encoding="utf-8") as file:
        file.write(deck)
    subprocess.run(["liggghts", "-in", "deck", "-log", "log"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)


def last_frame(path):
    """Rows x y z vx vy vz wx wy wz of the last frame of a dump, by identity."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    rows = text[text.rindex("ITEM: ATOMS"):].splitlines()[1:]
    return [[float(value) for value in row.split()[1:]]
            for row in sorted(rows, key=lambda row: int(row.split()[0]))]


def contact_time(c, mass, radius):
    """2.94 d / v of an impact straight on, the largest overlap d from 2/5 k d^(5/2) = 1/2 m v^2."""
    effective = 1 / ((1 - c["poisson"]**2) / c["young"] + (1 - c["poisson2"]**2) / c["young2"])
    slowest = c["v0"] * math.cos(math.radians(ANGLES[-1]))
    k = 4 / 3 * effective * math.sqrt(radius)
    return 2.9433 * (1.25 * mass * slowest**2 / k)**0.4 / slowest


def head(c, low, high):
    return f"""units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block {low} {high} units box
create_box 2 box
neighbor 0.001 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {c['young']} {c['young2']}
fix m2 all property/global poissonsRatio peratomtype {c['poisson']} {c['poisson2']}
fix m3 all property/global coefficientRestitution peratomtypepair 2 {f"{c['restitution']} " * 4}
fix m4 all property/global coefficientFriction peratomtypepair 2 {f"{c['mu']} " * 4}
pair_style gran model hertz tangential history tangential_damping off
pair_coeff * *
timestep {c['dt']}
fix move all nve/sphere
"""


def tail(c, contact):
    slowest = c["v0"] * math.cos(math.radians(ANGLES[-1]))
    steps = int((GAP / slowest + 2 * contact) / c["dt"]) + 10
    return f"""dump last all custom {steps} dump id x y z vx vy vz omegax omegay omegaz
dump_modify last format "{FORMAT}"
run {steps}
"""


def on_plane(c, folder):
    deck, d = head(c, "-1 3", "-1 10 -1 1"), c["diameter"]
    for k, _ in enumerate(ANGLES):
        deck += f"create_atoms 1 single 0 {0.5 * k!r} {d / 2 + GAP!r} units box\n"
    deck += f"set group all diameter {d} density {c['density']}\n"
    for k, angle in enumerate(map(math.radians, ANGLES)):
        deck += (f"group g{k} id {k + 1}\nvelocity g{k} set {c['v0'] * math.sin(angle)!r} 0 "
                 f"{-c['v0'] * math.cos(angle)!r} units box\n")
    deck += ("fix wall all wall/gran model hertz tangential history primitive type 2 zplane 0.0 "
             f"tangential_damping off\n")
    mass = c["density"] * math.pi / 6 * d**3
    liggghts(deck + tail(c, contact_time(c, mass, d / 2)), folder)
    for angle, row in zip(ANGLES, last_frame(os.path.join(folder, "dump"))):
        if row[2] <= d / 2:
            sys.exit("error: still in contact")
        yield {**c, "angle_deg": angle, "vx": row[3], "vz": row[5], "omega_y": row[7]}


def on_sphere(c, folder):
    d, d2 = c["diameter"], 2 * c["diameter"]
    deck, touch = head(c, "-1 1", "-1 10 -1 1"), (d + d2) / 2
    for k, angle in enumerate(map(math.radians, ANGLES)):
        deck += (f"create_atoms 1 single {-touch - GAP * math.cos(angle)!r} "
                 f"{0.5 * k - GAP * math.sin(angle)!r} 0 units box\n"
                 f"create_atoms 2 single 0 {0.5 * k!r} 0 units box\n")
    for k, angle in enumerate(map(math.radians, ANGLES)):
        deck += (f"set atom {2 * k + 1} diameter {d}\nset atom {2 * k + 2} diameter {d2}\n"
                 f"group g{k} id {2 * k + 1}\nvelocity g{k} set {c['v0'] * math.cos(angle)!r} "
                 f"{c['v0'] * math.sin(angle)!r} 0 units box\n")
    deck += f"set group all density {c['density']}\n"
    m1, m2 = (c["density"] * math.pi / 6 * size**3 for size in (d, d2))
    liggghts(deck + tail(c, contact_time(c, m1 * m2 / (m1 + m2), d * d2 / (d + d2) / 2)), folder)
    rows = last_frame(os.path.join(folder, "dump"))
    for k, angle in enumerate(ANGLES):
        one, two = rows[2 * k], rows[2 * k + 1]
        if math.hypot(one[0] - two[0], one[1] - two[1]) <= touch:
            sys.exit("error: still in contact")
        yield {**c, "diameter2": d2, "angle_deg": angle, "v1x": one[3], "v1y": one[4],
               "omega1_z": one[8], "v2x": two[3], "v2y": two[4], "omega2_z": two[8]}


def impacts(out, folder):
    for name, impact in (("plane", on_plane), ("pair", on_sphere)):
        rows = [row for case in CASES for row in impact(dict(zip(NAMES, case)), folder)]
        with open(os.path.join(out, f"hertz_impacts_{name}.csv"), "w", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


RPM, TURNING, RECORDED = 30, 6.0, 4.0  # s, of which the last are recorded
STEP = 1e-5


def write_start(path, seed):
    """Spheres anywhere in the mill, one after another, the large ones first."""
    rng, placed = random.Random(seed), []
    for diameter in [0.018] * 80 + [0.01375] * 300:
        r = diameter / 2
        while True:
            x, y, z = rng.uniform(-0.137, 0.137), rng.uniform(-0.137, 0.137), rng.uniform(r, 0.04 - r)
            if math.hypot(x, y) < 0.137 - r and all(
                    (x - p[0])**2 + (y - p[1])**2 + (z - p[2])**2 > (r + p[3])**2 for p in placed):
                break
        placed.append((x, y, z, r))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"seed {seed}\n\n{len(placed)} atoms\n4 atom types\n\n-0.21 0.21 xlo xhi\n"
                   "-0.21 0.21 ylo yhi\n-0.01 0.05 zlo zhi\n\nAtoms\n\n")
        for k, (x, y, z, r) in enumerate(placed):
            file.write(f"{k + 1} {2 if r > 0.008 else 1} {2 * r:.9g} 1190 {x:.9g} {y:.9g} {z:.9g}\n")


# Types: 1 small, 2 large, 3 the liner, 4 the ends.
MILL = """atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
read_data start
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e7 5e7 5e7 5e7
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 4 0.65 0.65 0.75 0.7 &
  0.65 0.65 0.75 0.7 0.75 0.75 0.75 0.75 0.7 0.7 0.75 0.7
fix m4 all property/global coefficientFriction peratomtypepair 4 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 &
  0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history tangential_damping off
pair_coeff * *
timestep STEP
fix weight all gravity 9.81 vector 0 -1 0
fix liner all mesh/surface/stress file GOLDEN/lab_mill_liner.stl type 3 reference_point 0 0 0
fix ends all mesh/surface/stress file GOLDEN/lab_mill_ends.stl type 4 reference_point 0 0 0
fix walls all wall/gran model hertz tangential history mesh n_meshes 2 meshes liner ends &
  tangential_damping off
fix move all nve/sphere
compute turning all erotate/sphere
compute touching all contact/atom
compute touches all reduce sum c_touching
variable moment equal f_liner[6]+f_ends[6]
variable kinetic equal ke
variable turning equal c_turning
variable contacts equal c_touches/atoms
variable x equal xcm(all,x)
variable y equal xcm(all,y)
thermo_style custom step atoms ke
thermo_modify lost error norm no
thermo 100000
run SETTLING
fix turn all move/mesh mesh liner rotate origin 0 0 0 axis 0 0 1 period PERIOD
fix turn2 all move/mesh mesh ends rotate origin 0 0 0 axis 0 0 1 period PERIOD
fix means all ave/time 10 100 1000 v_moment v_kinetic v_turning v_contacts v_x v_y file means
run TURNING
"""
FIGURES = ("power_W", "kinetic_energy_J", "rotational_energy_J", "contacts_per_particle",
           "center_of_mass_x_m", "center_of_mass_y_m")


def run_mill(folder, seed):
    os.makedirs(folder, exist_ok=True)
    write_start(os.path.join(folder, "start"), seed)
    deck = MILL
    for word, value in (("GOLDEN", os.path.abspath(GOLDEN)), ("SETTLING", round(1 / STEP)),
                        ("TURNING", round(TURNING / STEP)), ("PERIOD", 60 / RPM), ("STEP", STEP)):
        deck = deck.replace(word, str(value))
    liggghts(deck, folder)
    rows = []
    with open(os.path.join(folder, "means"), encoding="utf-8") as file:
        for line in file:
            if not line.startswith("#"):
                step, *values = map(float, line.split())
                if step * STEP > 1 + TURNING - RECORDED + 1e-9:
                    rows.append(values)
    means = [sum(column) / len(rows) for column in zip(*rows)]
    means[0] *= -RPM * math.pi / 30  # the charge's moment brakes the mill
    return dict(zip(FIGURES, means))


def mill(out, folder, seeds=4):
    runs = [run_mill(os.path.join(folder, f"seed{seed}"), seed) for seed in range(1, seeds + 1)]
    golden = {"origin": "LIGGGHTS-PUBLIC 3.8.0 (Debian 12 package 3.8.0+repack1-9+b2), 1 rank, made by "
                        "bench/peers/hertz_references.py: pair gran model hertz tangential history "
                        f"tangential_damping off, {seeds} seeds; law, geometry and protocol as in "
                        "apps/scenes/lab_mill_hertz.toml; means over the last 4 s of 6 s of turning",
              "rpm": RPM}
    for name in FIGURES:
        values = [run[name] for run in runs]
        mean = sum(values) / seeds
        error = math.sqrt(sum((v - mean)**2 for v in values) / (seeds - 1) / seeds)
        golden[name] = {"mean": mean, "se": error}
    with open(os.path.join(out, "hertz_lab_mill.json"), "w", encoding="utf-8") as file:
        json.dump(golden, file, indent=2)
        file.write("\n")


def main():
    out, what = sys.argv[1], sys.argv[2:] or ["impacts", "mill"]
    work = os.path.join(out, "work")
    os.makedirs(work, exist_ok=True)
    for name in what:
        {"impacts": impacts, "mill": mill}[name](out, work)


if __name__ == "__main__":
    main()
