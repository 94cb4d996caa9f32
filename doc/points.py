#!/usr/bin/python3
"""Table in Markdown of the pressure at the points of some runs, side by side, from their pressure-points.csv.

Usage: points.py results/one results/another ...
"""

import csv
import os
import sys


def pressures(folder):
    """{point: "kPa +- error"} of a run."""
    with open(os.path.join(folder, "pressure-points.csv"), newline="") as file:
        return {row["point"]: f"{float(row['pressure [kPa]']):.2f} +- {float(row['its error [kPa]']):.2f}"
                if float(row["pressure [kPa]"]) > 0.0 else f"free, {float(row['gap [mm]']):.1f} mm off"
                for row in csv.DictReader(file)}


def main(folders):
    runs = {os.path.basename(os.path.normpath(folder)): pressures(folder) for folder in folders}
    print("| point | " + " | ".join(f"`{scene}`" for scene in runs) + " |\n|---|" + "---|" * len(runs))
    for point in next(iter(runs.values())):
        print(f"| {point} | " + " | ".join(run.get(point, "-") for run in runs.values()) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
