#!/usr/bin/python3
"""Holds every #include to the rule of the folders.

usage: include_rule.py SOURCE_FOLDER

    soa <- kernels <- scheduler <- apps      soa <- io <- apps

A folder includes itself and what is left of it; io and scheduler never meet. Each library that we
build upon is included in one place only. tests/ and bench/ may include anything of ours.
"""

import pathlib
import re
import sys

MAY_INCLUDE = {
    "soa": {"soa"},
    "kernels": {"kernels", "soa"},
    "scheduler": {"scheduler", "kernels", "soa"},
    "io": {"io", "soa"},
    "apps": {"apps", "scheduler", "kernels", "io", "soa"},
}
# Library headers -> the files (prefixes of paths) that may include them.
HOMES = {
    r"hwy/": ["kernels/", "tests/"],
    r"(tbb|oneapi)/": ["scheduler/graph.cpp"],
    r"(hdf5|H5\w+)\.h": ["io/hdf5_file.cpp"],
    r"zlib\.h": ["io/packed.cpp", "io/seal.cpp", "tests/"],
    r"toml\+\+/": ["io/toml_reader.cpp"],
    r"libqhull": ["kernels/polyhedron.cpp", "tests/unit/polyhedron_overlap_test.cpp"],
    r"CLI/": ["apps/quern/main.cpp"],
    r"gtest/": ["tests/"],
    r"benchmark/": ["bench/"],
    r"(iostream|print)$": [],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]')


def faults_of(path, text):
    folder = path.split("/")[0]
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        kind, header = match.groups()
        target = header.split("/")[0]
        if kind == '"' and "/" not in header:
            yield f"{path}:{number}: '{header}': includes are written from the root"
        if kind == '"' and folder in MAY_INCLUDE and target not in MAY_INCLUDE[folder]:
            yield f"{path}:{number}: {folder}/ may not include '{header}'"
        for pattern, homes in HOMES.items():
            if re.match(pattern, header) and not any(path.startswith(h) for h in homes):
                yield f"{path}:{number}: <{header}> belongs to {', '.join(homes) or 'nobody'}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for folder in [*MAY_INCLUDE, "tests", "bench"]
             for pattern in ("*.h", "*.cpp") for f in sorted((root / folder).rglob(pattern))]
    faults = [fault for file in files
              for fault in faults_of(str(file.relative_to(root)), file.read_text())]
    print(f"{len(files)} files, {len(faults)} faults", *faults, sep="\n")
    sys.exit(1 if faults or not files else 0)


main()
