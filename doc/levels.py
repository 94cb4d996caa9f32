#!/usr/bin/python3
"""Table in Markdown of the levels of some runs, from their pressure-levels.csv.

Usage: levels.py results/one results/another ...
"""

import csv
import os
import sys

HEAD = ["scene", "level", "girth mm", "T N/mm", "T/r kPa", "pressure kPa", "mmHg", "+- kPa", "smallest to largest kPa"]


def number(row, column, digits):
    return f"{float(row[column]):.{digits}f}" if row[column] else "-"


def cells(row):
    pressure = number(row, "mean pressure [kPa]", 2)
    return [row["level"], number(row, "girth [mm]", 0), number(row, "hoop tension T [N/mm]", 4),
            number(row, "Laplace T/r [kPa]", 2), f"**{pressure}**", number(row, "mean pressure [mmHg]", 1),
            number(row, "error of the mean pressure [kPa]", 2),
            number(row, "smallest pressure [kPa]", 2) + "-" + number(row, "largest pressure [kPa]", 2)]


def main(folders):
    print("| " + " | ".join(HEAD) + " |\n|" + "---|" * len(HEAD))
    for folder in folders:
        scene = os.path.basename(os.path.normpath(folder))
        with open(os.path.join(folder, "pressure-levels.csv"), newline="") as file:
            for row in csv.DictReader(file):
                print("| " + " | ".join([scene] + cells(row)) + " |")
                scene = ""


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
