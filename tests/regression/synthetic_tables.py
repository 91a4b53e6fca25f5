#!/usr/bin/python3
"""SYNTHETIC TEST DATA for the report page: adds made-up tables to a copy of a short run.

usage: synthetic_tables.py RUN_FOLDER NEW_FOLDER [FACTOR]

Each table that the page can show is there under its name and units, with smooth numbers of a
sensible size, scaled by FACTOR, that no engine has computed. The title says so. The run is one of
lab_mill_spheres with [record] charge_shape.
"""

import json
import math
import pathlib
import shutil
import sys

import h5py
import numpy

NOTE = "SYNTHETIC TEST DATA <script>alert('not escaped')</script>"
GROUPS, WALLS = ["ore", "ball"], ["liner"]
KINDS = ["ore-ore", "ore-ball", "ore-liner", "ball-ball", "ball-liner"]
SHARES = [0.62, 0.2, 0.05, 0.09, 0.04]


def table(file, name, columns):
    """columns: name -> (values, unit, doc)."""
    for column, (values, unit, doc) in columns.items():
        path = f"{name}/{column}"
        if path in file:
            del file[path]
        data = file.create_dataset(path, data=numpy.asarray(values, dtype=numpy.float64))
        data.attrs["unit"] = numpy.bytes_(unit)
        data.attrs["doc"] = numpy.bytes_(doc)


def text(file, name, lines):
    if name in file:
        del file[name]
    file.create_dataset(name, data=numpy.array(["\n".join(lines).encode()]))


def with_errors(columns):
    both = dict(columns)
    for name, (values, unit, doc) in columns.items():
        both[name + "_standard_error"] = (0.03 * numpy.abs(numpy.asarray(values)) + 1e-9, unit,
                                          "standard error: " + doc)
    return both


def power_by_kind(file, summary, factor):
    power = factor * summary["power_W"]
    total = [power * share for share in SHARES]
    split = {"normal": 0.4, "sliding": 0.5, "tangential": 0.1}
    columns = {"total": (total, "W", "dissipation, mean over the recorded window")}
    columns.update({k: ([v * t for t in total], "W", f"{k} part") for k, v in split.items()})
    table(file, "power_by_kind", with_errors(columns))
    text(file, "power_by_kind/kind", KINDS)
    dissipation = file["series/dissipation"][:]
    for kind, share in zip(KINDS, SHARES):
        table(file, "series/dissipation_by_kind",
              {kind: (factor * share * (dissipation - dissipation[0]), "J", "since the record")})
        summary[f"power_{kind}_W"] = power * share
        summary[f"power_{kind}_W_standard_error"] = 0.03 * power * share


def spectra(file, summary, factor):
    edges = [0.0] + [10 ** (-12 + k / 10) for k in range(151)]
    table(file, "spectra", {"energy_from": (edges, "J", "lower edge of each bin"),
                            "recorded_time": ([0.8], "s", "length of the window")})
    middle = numpy.array([1e-12] + [10 ** (-12 + (k + 0.5) / 10) for k in range(151)])
    for k, (kind, share) in enumerate(zip(KINDS, SHARES)):
        for name, peak in (("", -7.0 + 0.3 * k), ("approach_", -6.5 + 0.3 * k),
                           ("impact_", -6.2 + 0.3 * k)):
            count = numpy.round(2e4 * factor * share *
                                numpy.exp(-((numpy.log10(middle) - peak) / 1.1) ** 2))
            table(file, f"spectra/{kind}", {name + "count": (count, "1", "episodes"),
                                            name + "energy": (count * middle, "J", "their energy")})
    table(file, "spectra", {"open_energy": ([1e-4 * s for s in SHARES], "J", "of open episodes"),
                            "open_count": ([300 * s for s in SHARES], "1", "open episodes")})
    summary["spectra_sum_error"] = 3e-8


def charge(file, summary):
    radius, angle = file["charge_map/radius"][:], numpy.radians(file["charge_map/angle"][:])
    solid = file["charge_map/solid_fraction"][:]
    r, a = numpy.meshgrid(radius, angle, indexing="ij")
    spin = 3.14 * (2 * r / radius.max() - 1)
    table(file, "charge_map", {
        "velocity_x": (-spin * r * numpy.sin(a), "m/s", "mean"),
        "velocity_y": (spin * r * numpy.cos(a), "m/s", "mean"),
        "speed": (numpy.abs(spin * r), "m/s", "mean"),
        "solid_fraction_ore": (0.7 * solid, "1", "of ore"),
        "solid_fraction_ball": (0.3 * solid * (1 + 0.5 * numpy.cos(a)), "1", "of balls")})
    for name, value in (("head", 62.0), ("impact_toe", 212.0), ("dynamic_angle", 38.0)):
        summary[f"{name}_deg"], summary[f"{name}_deg_standard_error"] = value, 1.4
    summary["head_deg_at_0.4"] = summary["head_deg_at_0.6"] = 61.0
    time = file["series/time"][:]
    table(file, "series_of_charge", {
        "time": (time, "s", "of the snapshot"),
        "shoulder": (46 + 3 * numpy.sin(9 * time), "deg", "of the snapshot"),
        "toe": (231 + 4 * numpy.cos(7 * time), "deg", "of the snapshot")})


def classes(file, factor):
    text(file, "classes/name", ["ore 10-12 mm", "ore 12-14 mm", "ore 14-16 mm", "ball 18 mm"])
    spin = [38, 29, 22, 17]
    columns = {"count": ([100, 120, 80, 80], "1", "mean number"),
               "angular_speed": ([factor * s for s in spin], "rad/s", "mean"),
               "kinetic_energy": ([1e-4, 1.6e-4, 2.2e-4, 3e-4], "J", "mean of a particle"),
               "rotational_energy": ([1e-5, 1.3e-5, 1.5e-5, 1.6e-5], "J", "mean of a particle")}
    table(file, "classes", with_errors(columns))
    table(file, "classes", {"from": ([0.01, 0.012, 0.014, 0.018], "m", "diameter"),
                            "to": ([0.012, 0.014, 0.016, 0.018], "m", "diameter")})
    table(file, "zones/toe", with_errors({
        "count": ([factor * n for n in (8, 9, 7, 6)], "1", "mean number in the zone"),
        "kinetic_energy": ([2e-4, 3e-4, 4e-4, 5e-4], "J", "mean of a particle there")}))


def formulas(file, summary, factor):
    names = ["Austin", "Hogg-Fuerstenau", "Morrell C"]
    text(file, "formulas/name", names)
    text(file, "formulas/source", ["Austin 1990", "Hogg & Fuerstenau 1972", "Morrell 1996"])
    text(file, "formulas/valid", ["J 0.2 - 0.4, below 80 % of critical", "any filling",
                                  "SAG mills of 1 - 10 m"])
    low = factor * summary["power_W"] * numpy.array([1.04, 0.9, 0.97])
    high = factor * summary["power_W"] * numpy.array([1.04, 1.1, 0.97])
    table(file, "formulas", {"low": (low, "W", "lower end"), "high": (high, "W", "upper end")})
    summary["power_formula_low_W"], summary["power_formula_high_W"] = float(low.min()), float(high.max())
    summary["power_within_formulas"] = True


def pitch_of_profile(count=18, radius=0.15, height=0.01, top=0.01, cells=60):
    """Points along one pitch of a mill's section: shell, leading face, top, trailing face, shell."""
    slope = math.tan(math.radians(14))
    base = math.atan2(top / 2 + height * slope, radius)
    corners = [(radius, -math.pi / count), (radius, -base), (radius - height, -top / 2 / radius),
               (radius - height, top / 2 / radius), (radius, base), (radius, math.pi / count)]
    xy = numpy.array([(r * math.cos(a), r * math.sin(a)) for r, a in corners])
    length = numpy.concatenate([[0], numpy.cumsum(numpy.hypot(*numpy.diff(xy, axis=0).T))])
    arc = numpy.linspace(0, length[-1], cells)
    return arc, numpy.interp(arc, length, xy[:, 0]), numpy.interp(arc, length, xy[:, 1])


def wear(file, summary, factor):
    arc, x, y = pitch_of_profile()
    # Counterclockwise: the leading face looks to larger angles, the second edge of the top leads.
    edge = arc[-1] * 0.62
    siem = factor * (2 + 40 * numpy.exp(-((arc - edge) / 0.004) ** 2))
    mm = "mm per 1000 h"
    table(file, "wear_profile", {
        "arc": (arc, "m", "along the section"), "x": (x, "m", "at t = 0"), "y": (y, "m", "at t = 0"),
        "siem": (siem, mm, "mean over the lifters"), "siem_spread": (0.1 * siem, mm, "their spread"),
        "sliding": (0.5 * siem, mm, "sliding only"), "archard": (0.8 * siem, mm, "Archard"),
        "finnie": (0.3 * siem, mm, "Finnie"), "pressure": (900 * siem, "Pa", "time mean"),
        "shear": (250 * siem, "Pa", "time mean")})
    corners, values = [], []
    for lifter in range(18):
        a = 2 * math.pi * lifter / 18
        px, py = x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)
        for k in range(len(arc) - 1):
            for z in (0.0, 0.02):
                p, q = (px[k], py[k]), (px[k + 1], py[k + 1])
                corners += [[*p, z, *q, z, *q, z + 0.02], [*p, z, *q, z + 0.02, *p, z + 0.02]]
                values += 2 * [siem[k] * (1 + 0.1 * math.sin(lifter))]
    values = numpy.array(values)
    table(file, "wear/liner", {
        "corner": (corners, "m", "body frame"), "area": (numpy.full(len(values), 1e-5), "m^2", "cell"),
        "depth_rate_siem": (values, mm, "SIEM"), "depth_rate_archard": (0.8 * values, mm, "Archard"),
        "pressure": (900 * values, "Pa", "time mean"), "shear": (250 * values, "Pa", "time mean")})
    table(file, "wear_of_groups", {"volume_siem": ([2e-12, 5e-13], "m^3", "of all in the group"),
                                   "volume_archard": ([1e-12, 3e-13], "m^3", "of all in the group")})
    text(file, "wear_of_groups/group", GROUPS)
    for model in ("siem", "archard", "finnie", "sliding"):
        summary[f"wear_{model}_m3"], summary[f"wear_{model}_factor"] = 3e-12 * factor, 1.0


def main():
    source, target = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    factor = float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target)
    summary = json.loads((target / "summary.json").read_text())
    with h5py.File(target / "run.h5", "r+", libver=("v108", "v110")) as file:
        scene = file["scene"].asstr()[0].replace('title = "', f'title = "{NOTE} ')
        text(file, "scene", [scene])
        power_by_kind(file, summary, factor)
        spectra(file, summary, factor)
        charge(file, summary)
        classes(file, factor)
        formulas(file, summary, factor)
        wear(file, summary, factor)
    summary["power_W"] *= factor
    summary.update({"steady": False, "steps_per_contact": 28.2, "power_drift_share": 0.04,
                    "steady_statement": "not steady: power rose by 4 % (2.1 standard errors)"})
    (target / "summary.json").write_text(json.dumps(summary, indent=2))


if __name__ == "__main__":
    main()
