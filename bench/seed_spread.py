#!/usr/bin/python3
"""How often the error bars of two replicates cover their difference, over the points of a sweep.

usage: seed_spread.py SWEEP.csv

A bar is the standard error that each case tells of itself, from blocks of its window. If they are
right two thirds of the differences are within the root of their summed squares.
"""
import csv
import math
import sys


def main():
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "finished"]
    factors = [name for name in rows[0] if "." in name]
    points = {}
    for row in rows:
        points.setdefault(tuple(row[name] for name in factors), []).append(row)
    pairs = [rows for rows in points.values() if len(rows) == 2]
    covered = all_of_them = 0
    for name in rows[0]:
        if f"{name}_standard_error" not in rows[0]:
            continue
        ratios = [abs(float(a[name]) - float(b[name])) /
                  math.hypot(*(float(row[f"{name}_standard_error"]) for row in (a, b)))
                  for a, b in pairs]
        within = sum(ratio <= 1 for ratio in ratios)
        covered, all_of_them = covered + within, all_of_them + len(ratios)
        print(f"{name:32} {within:3} of {len(ratios)}  root mean square "
              f"{math.sqrt(sum(ratio**2 for ratio in ratios) / len(ratios)):.2f}")
    print(f"{'all':32} {covered} of {all_of_them} = {covered / all_of_them:.2f}")


if __name__ == "__main__":
    main()
