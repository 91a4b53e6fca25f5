#!/usr/bin/python3
"""Lists what a run folder holds and fails if something is missing.

usage: read_results.py RUN_FOLDER        (needs python3-h5py)

Looks into run.h5 (series, tables, texts, provenance), summary.json, and the frames with their
series files. Every dataset must carry a unit; texts have none. All series must be equally long;
what the summary says of the run as well, the provenance must repeat.
Prints name, shape, type and unit of each; exits 1 and names the fault otherwise.
"""

import json
import os
import sys

import h5py

PROVENANCE = ("version", "commit", "machine", "threads", "simd_target", "precision")

faults = []


def check(condition, fault):
    if not condition:
        faults.append(fault)
    return condition


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def list_datasets(path, file, needs_unit=True):
    def show(name, item):
        if not isinstance(item, h5py.Dataset):
            return
        is_text = h5py.check_string_dtype(item.dtype) is not None
        unit = text_of(item.attrs.get("unit", ""))
        print(f"  {name:40} {str(item.shape):16} {'text' if is_text else item.dtype}  [{unit}]")
        if needs_unit and not is_text:
            check(unit, f"{path}: '{name}' has no unit")
        item[()]  # reading verifies the checksums

    file.visititems(show)


def check_run(folder):
    path = os.path.join(folder, "run.h5")
    if not check(os.path.isfile(path), f"{path}: missing"):
        return {}
    print(path)
    with h5py.File(path, "r") as file:
        list_datasets(path, file)
        if check("series" in file and "time" in file["series"], f"{path}: no series/time"):
            series = {}
            file["series"].visititems(lambda name, item: series.update(
                {name: item} if isinstance(item, h5py.Dataset) else {}))
            rows = {name: item.shape[0] for name, item in series.items()}
            check(len(set(rows.values())) == 1, f"{path}: series of unequal length: {rows}")
            time = file["series/time"][:]
            check((time[1:] > time[:-1]).all(), f"{path}: series/time does not increase")
            for name, item in series.items():
                check(item.attrs.get("doc"), f"{path}: series/{name} has no doc")
        if check("provenance" in file, f"{path}: no provenance"):
            found = {name: text_of(value) for name, value in file["provenance"].attrs.items()}
            for name, value in found.items():
                print(f"  provenance {name} = {value}")
            for name in PROVENANCE:
                check(found.get(name), f"{path}: provenance has no '{name}'")
            return found
    return {}


def check_summary(folder, provenance):
    path = os.path.join(folder, "summary.json")
    if not check(os.path.isfile(path), f"{path}: missing"):
        return
    with open(path, encoding="utf-8") as file:
        summary = json.load(file)
    print(path)
    for name, value in summary.items():
        print(f"  {name} = {value}")
        said = provenance.get(name, str(value))
        check(said == str(value), f"{path}: {name} is {value}, in the provenance {said}")


def check_frames(folder):
    frames = os.path.join(folder, "frames")
    if not os.path.isdir(frames):
        print(f"{frames}: none")
        return
    for kind in ("particles", "polyhedra", "liner"):
        path = os.path.join(frames, f"{kind}.hdf.series")
        if not os.path.isfile(path):
            check(kind != "particles", f"{path}: missing")
            continue
        with open(path, encoding="utf-8") as file:
            entries = json.load(file)["files"]
        print(f"{path}: {len(entries)} frames")
        check(entries, f"{path}: lists no frame")
        for entry in entries:
            name = os.path.join(frames, entry["name"])
            if not check(os.path.isfile(name), f"{name}: missing"):
                continue
            with h5py.File(name, "r") as file:
                check(file.attrs["time"] == entry["time"], f"{name}: time differs from the series")
                if entry is entries[-1]:
                    list_datasets(name, file)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    provenance = check_run(sys.argv[1])
    check_summary(sys.argv[1], provenance)
    check_frames(sys.argv[1])
    for fault in faults:
        print(f"error: {fault}", file=sys.stderr)
    sys.exit(1 if faults else 0)


main()
