#!/usr/bin/python3
"""Table in Markdown of the pressure at the points of some runs, side by side, from their pressure-points.csv.

Usage: points.py results/one results/another ...
       points.py --compare results/one results/another    two ways to one state: levels as well, with their difference
"""

import csv
import os
import sys


def free(row):
    """How far off it is, and what may press there: fabric beside it does."""
    error = float(row["its error [kPa]"])
    return f"free, {float(row['gap [mm]']):.1f} mm off" + (f", +- {error:.2f}" if error > 0.0 else "")


def pressures(folder):
    """{point: "kPa +- error"} of a run."""
    with open(os.path.join(folder, "pressure-points.csv"), newline="") as file:
        return {row["point"]: f"{float(row['pressure [kPa]']):.2f} +- {float(row['its error [kPa]']):.2f}"
                if float(row["pressure [kPa]"]) > 0.0 else free(row)
                for row in csv.DictReader(file)}


def values(folder):
    """{place: (kPa, its error by the mesh)} of the points and levels of a run."""
    found = {}
    for table, place, pressure in (("points", "point", "pressure [kPa]"), ("levels", "level", "mean pressure [kPa]")):
        with open(os.path.join(folder, f"pressure-{table}.csv"), newline="") as file:
            found.update({row[place]: (float(row[pressure]), float(row["its part by mesh [kPa]"]))
                          for row in csv.DictReader(file)})
    return found


def compare(folders):
    one, other = (values(folder) for folder in folders)
    names = [os.path.basename(os.path.normpath(folder)) for folder in folders]
    print(f"| place | `{names[0]}` kPa | `{names[1]}` kPa | difference kPa | error of the mesh kPa |\n|---|---|---|---|---|")
    for place, (pressure, error) in one.items():
        if place not in other:
            sys.exit(f"{folders[1]}: there is no point or level {place!r}")
        print(f"| {place} | {pressure:.4f} | {other[place][0]:.4f} | {abs(pressure - other[place][0]):.0e} "
              f"| {max(error, other[place][1]):.2f} |")


def main(folders):
    runs = {os.path.basename(os.path.normpath(folder)): pressures(folder) for folder in folders}
    print("| point | " + " | ".join(f"`{scene}`" for scene in runs) + " |\n|---|" + "---|" * len(runs))
    for point in next(iter(runs.values())):
        print(f"| {point} | " + " | ".join(run.get(point, "-") for run in runs.values()) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if sys.argv[1] != "--compare":
        main(sys.argv[1:])
    elif len(sys.argv) == 4:
        compare(sys.argv[2:])
    else:
        sys.exit(__doc__)
