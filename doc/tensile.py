#!/usr/bin/python3
"""Joins the force curves of the three tensile scenes into one table; called by tensile.sh.

Usage: tensile.py FOLDER table.csv        (FOLDER/wale/force-curves.csv, ...)

Force in N of a strip 50 mm wide and 1 mm thick; length in mm of the middle section, 50 at the start (in the bias it
turns and is longer than the strip is wide).
"""

import csv
import sys

DIRECTIONS = ("wale", "course", "bias")
STRIPS = ("pantyhose rebar", "pantyhose Itskov", "T-shirt rebar", "T-shirt Itskov")
STRETCHES = [1.0 + 0.025 * k for k in range(17)]


def read(path):
    """Force and middle section of every strip by its stretch; of repeated steps the last."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    curves = {}
    for strip in STRIPS:
        for row in rows:
            stretch = round(float(row[f"{strip}: stretch"]), 9)
            curves.setdefault(strip, {})[stretch] = (
                float(row[f"{strip}: force [N]"]), float(row[f"{strip}: middle section [mm]"]))
    return curves


def main():
    folder, table = sys.argv[1:]
    columns = {}
    for direction in DIRECTIONS:
        for strip, curve in read(f"{folder}/{direction}/force-curves.csv").items():
            points = [curve[round(stretch, 9)] for stretch in STRETCHES]
            columns[f"{strip} {direction} force [N]"] = [force for force, _ in points]
            columns[f"{strip} {direction} section [mm]"] = [width for _, width in points]
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["stretch"] + list(columns))
        for k, stretch in enumerate(STRETCHES):
            values = [0.0 if abs(column[k]) < 1e-9 else column[k] for column in columns.values()]
            writer.writerow([f"{stretch:.3f}"] + [f"{value:.7g}" for value in values])


if __name__ == "__main__":
    main()
