#!/usr/bin/env python3
"""A mill, a body from an STL file, a plane and a box in one scene: all_walls.py QUERN STL OUT

A mill of 300 mm turns around a cube that turns the other way, a box open at the top and a plane; a
dozen balls are thrown at them and roll on for 0.6 s. Fails if a wall has felt no force or if the energy
account does not close to 1e-5. (Its kinetic energy is that of v(n-1/2) . v(n+1/2); the first step has v(0)
and half a kick instead, so that the account of balls thrown begins m g . v(0) dt / 4 off: 5.3e-8 J,
2.3e-6 of what is dissipated, and that is what is found. At rest there is no such thing.)
"""
import os
import shutil
import sys

import h5py
import numpy as np

import runs

LIMIT = 1e-5

SCENE = """format = 1
[run]
duration = "0.6 s"
time_step = "1e-5 s"
[materials.resin]
density = "1190 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
sliding_friction = 0.3
restitution = 0.3
[mill]
material = "resin"
diameter = "300 mm"
length = "40 mm"
ends = "walls"
rotation = "30 rpm"
[mill.lifters]
count = 18
height = "10 mm"
face_angle = "14 deg"
top_width = "10 mm"
[[walls]]
name = "cube"                       # 32 mm, turning the other way at the mill's centre
material = "resin"
mesh = "{stl}"
scale = 0.04
motion = {{ kind = "rotation", axis = [0, 0, 1], center = ["0 m", "0 m", "0 m"], rate = "-30 rpm" }}
[[walls]]
name = "plane"                      # cuts off the left of the mill
material = "resin"
point = ["-0.09 m", "0 m", "0 m"]
normal = [1, 0.2, 0]
[[walls]]
name = "box"
material = "resin"
low = ["0.05 m", "-0.06 m", "0.002 m"]
high = ["0.1 m", "-0.02 m", "0.038 m"]
open_top = true
[[particles]]
name = "ball"
material = "resin"
diameter = "12 mm"
entries = [
{entries}
]
[output]
series_every = "1e-4 s"             # a third of a contact: none is missed
"""
# Position (m) and velocity (m/s): at the cube, the plane, the ends, into the box, at the liner.
BALLS = [((0.000, 0.040, 0.015), (0, -0.5, 0)), ((0.005, 0.055, 0.028), (0, -0.5, 0)),
         ((-0.050, 0.000, 0.020), (-1, 0, 0)), ((-0.040, 0.030, 0.015), (-1, 0, 0)),
         ((-0.040, -0.060, 0.015), (0, 0, -1)), ((0.010, -0.060, 0.025), (0, 0, 1)),
         ((0.075, 0.010, 0.020), (0, 0, 0)), ((0.075, 0.040, 0.020), (0.2, 0, 0)),
         ((0.075, 0.060, 0.020), (-0.2, 0, 0)), ((0.020, -0.100, 0.020), (0, -1, 0)),
         ((0.000, -0.080, 0.012), (0, -1, 0)), ((0.090, 0.090, 0.020), (1, 1, 0))]


def entry(position, velocity):
    place = ", ".join(f'"{x} m"' for x in position)
    speed = ", ".join(f'"{v} m/s"' for v in velocity)
    return f"  {{ position = [{place}], velocity = [{speed}] }},"


def main():
    quern, stl, out = sys.argv[1:4]
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    scene = os.path.join(out, "all_walls.toml")
    with open(scene, "w", encoding="utf-8") as file:
        entries = "\n".join(entry(*ball) for ball in BALLS)
        file.write(SCENE.format(stl=os.path.abspath(stl), entries=entries))
    folder = os.path.join(out, "run")
    summary = runs.run_once(quern, scene, folder, [])
    right = summary["finished"] and summary["ledger_error"] < LIMIT
    with h5py.File(os.path.join(folder, "run.h5")) as file:
        walls = file["series/walls"]
        for name in ("liner", "ends", "cube", "plane", "box"):
            force = np.sqrt(sum(walls[name][f"force_{axis}"][:] ** 2 for axis in "xyz"))
            print(f"{name}: touched in {(force > 0).mean():.1%} of the samples, "
                  f"{force.max():.3g} N at most")
            right = right and force.max() > 0
    print(f"ledger error {summary['ledger_error']:.1e} (limit {LIMIT})")
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
