#!/usr/bin/python3
"""Runs input/leave-out.xml and makes of it doc/leave-out.md: what each optional part costs when it is on.

Usage, from the project's folder: doc/leave-out.py [PATH-OF-toile]
"""
import sys

import study_tables as tables

HEAD = """# What can be left out, and what it costs

Made by `doc/leave-out.py` from `input/leave-out.xml`: a strip of 3,072 elements pulled in a few steps, and the same with one
part more. The least processor time of three runs, in which starting the program is contained; what is not asked for is not
built: no unknown and no object of it is there, which `test/run/leave_out_test.cpp` counts.

| part | unknowns | Newton iterations | factorisations | processor time s | of that without | memory MB | force N |
|---|---|---|---|---|---|---|---|
"""


def main(toile="build/release/toile"):
    if toile != "--page" and tables.run(toile, "input/leave-out.xml", "results/leave-out", 2) != 0:
        sys.exit("the study could not be run")
    parts = {}
    for row in tables.table("results/leave-out", "study"):
        parts.setdefault(row["part"], []).append(row)
    without = None
    text = HEAD
    for part, rows in parts.items():
        rows = [row for row in rows if row["status"] == "0"]
        if not rows:
            text += f"| {part} | refused | | | | | | |\n"
            continue
        seconds = min(float(row["processor time [s]"]) for row in rows)
        without = without or seconds
        memory = min(float(row["peak memory [MB]"]) for row in rows)
        one = rows[0]
        text += (f"| {part} | {one['unknowns']} | {one['Newton iterations']} | {one['factorisations']} | {seconds:.2f} | "
                 f"{100 * seconds / without:.0f} % | {memory:.0f} | {tables.rounded(one['force'], 6)} |\n")
    with open("doc/leave-out.md", "w") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
