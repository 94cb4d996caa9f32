#!/usr/bin/python3
"""Runs input/leave-out.xml and makes of it doc/leave-out.md: what each optional part costs when it is on.

Usage, from the project's folder: doc/leave-out.py [PATH-OF-toile]
"""
import glob
import os
import resource
import subprocess
import sys

import study_tables as tables

HEAD = """# What can be left out, and what it costs

Made by `doc/leave-out.py` from `input/leave-out.xml`: a strip of 3,072 elements pulled in a few steps, and the same with one
part more. The least processor time of three runs, in which starting the program is contained; what is not asked for is not
built: no unknown and no object of it is there, which `test/run/leave_out_test.cpp` counts.

| part | unknowns | Newton iterations | factorisations | processor time s | of that without | memory MB | force N |
|---|---|---|---|---|---|---|---|
"""


def always(folder, toile):
    """Of the strip on its body: what every run with files computes and writes, and the page that one may ask for."""
    rows = [row for row in tables.table(folder, "study") if row["part"] == "body and contact" and row["status"] == "0"]
    seconds = {of: min(float(row[of]) for row in rows) for of in ("processor time [s]", "fields", "restart")}
    run = os.path.dirname(glob.glob(os.path.join(folder, "case-*body*first*", "results.exo"))[0])
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([toile, "report", run], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds["report"] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    whole = seconds["processor time [s]"]
    return f"""
Fields (stresses, pressure with its recovery, errors) and the restart file are made at every step that is written; they are
parts of the runs above. The page of `toile report` is another command. Of the strip with body and contact:

| part | s | of its run |
|---|---|---|
| fields, recovery and errors | {seconds["fields"]:.2f} | {100 * seconds["fields"] / whole:.0f} % |
| restart file | {seconds["restart"]:.2f} | {100 * seconds["restart"] / whole:.0f} % |
| `toile report` | {seconds["report"]:.2f} | {100 * seconds["report"] / whole:.0f} % more |
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
    text += always("results/leave-out", toile if toile != "--page" else "build/release/toile")
    with open("doc/leave-out.md", "w") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
