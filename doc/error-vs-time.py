#!/usr/bin/python3
"""Runs the shipped studies input/studies/*.xml and makes of them doc/error-vs-time.md with its figures.

Usage, from the project's folder: doc/error-vs-time.py [PATH-OF-toile] [jobs]
Results stay in results/studies; cases that are there already are not run again. With --page in the place of the program
only the page is made, of the results that are there.
"""
import glob
import os
import sys

import study_tables as tables

HEAD = """# Error against run time

Made by `doc/error-vs-time.py` from the studies in `input/studies`; see [study](study.md) for what the words mean.
The time is that of the processors, with reading, bodies and results; a run needs some tenths of a second of it before it begins to solve.
The error is the largest of the quantities that are named, against the exact value where there is one, else against the limit
of the meshes. A target counts as reached if the error and that of the reference together are below it.

"""

EFFECTIVITY = """
## Is the told error right?

The error that a run tells beside a pressure, over the true one, from the coarsest to the finest mesh: 1 is exact, more is
careful, less too bold. The last column counts the meshes on which the true error is the larger one. Only where the exact value
is known; on noisy scans the same ratio is 1.0 (`cases_scan_noise_test`), of the body's curvature 0.9 to 1.2
(`test_body_doubt`).

| study | elements | pressure | coarsest | | | finest | too bold |
|---|---|---|---|---|---|---|---|
"""


def cheapest(name, title, folder):
    row = f"| [{title}](#{name}) |"
    for line in tables.table(folder, "cheapest"):
        seconds = next(value for key, value in line.items() if "time" in key)
        row += f" {line['setting']}: {tables.rounded(seconds)} s |" if line["setting"] else " none |"
    return row


def cases(folder):
    rows = tables.table(folder, "study")
    quantities = [key[:-len(": error [%]")] for key in rows[0] if key.endswith(": error [%]")]
    axes = list(rows[0])[1:list(rows[0]).index("verdict")]
    text = "| " + " | ".join(axes + ["unknowns", "time s", "memory MB"] + [f"{q}: error %" for q in quantities]) + " | |\n"
    text += "|" + "---|" * (len(axes) + len(quantities) + 4) + "\n"
    for row in rows:
        cells = [row[a] for a in axes] + [row["unknowns"], tables.rounded(row["processor time [s]"]),
                                          tables.rounded(row["peak memory [MB]"])]
        cells += [tables.rounded(row[f"{q}: error [%]"]) for q in quantities]
        note = "Pareto" if row["on the Pareto front"] == "1" else ""
        if row["status"] != "0":
            note = row["reason"].split("\n")[0]
        text += "| " + " | ".join(cells) + f" | {note} |\n"
    return text


def effectivities(name, title, folder):
    """Error that a run tells over the true one, of each pressure whose exact value is known, from coarse to fine."""
    rows = tables.table(folder, "study")
    text = ""
    for q in [key[:-len(": its error")] for key in rows[0] if key.endswith(": its error")]:
        ratios = {}
        for row in rows:
            told, reference, doubt = (row[f"{q}: {of}"] for of in ("its error", "reference", "error of the reference"))
            if not told or not reference or float(doubt or 0) > 0 or row["status"] != "0":
                continue
            true = abs(float(row[q]) - float(reference))
            kind = ", ".join(row[a] for a in ("elements", "integration") if a in row)
            ratios.setdefault(kind, []).append(float(told) / true if true > 0 else float("inf"))
        for kind, values in ratios.items():
            text += f"| [{title}](#{name}) | {kind} | {q} | " + " | ".join(f"{v:.2g}" for v in values[:4]) + " | " * (
                4 - len(values)) + f" | {sum(v < 1 for v in values)} of {len(values)} |\n"
    return text


def limits(folder):
    text = ""
    for row in tables.table(folder, "limits"):
        what = ", ".join(x for x in (row["setting"], row["quantity"]) if x)
        if row["trusted"] != "1":
            text += f"- {what}: no limit can be trusted: {row['why not trusted']}\n"
            continue
        spread = list(row.values())[7]
        order = f", order {tables.rounded(row['order'])}" if row["order"] else ", the meshes agree"
        text += f"- {what}: {tables.rounded(row['value'], 7)}{order}" + (f" +- {tables.rounded(spread, 2)}\n" if spread else "\n")
    return text


def main(toile="build/release/toile", jobs=1):
    overview, effectivity, sections = "", "", ""
    for study in sorted(glob.glob("input/studies/*.xml")):
        name = os.path.splitext(os.path.basename(study))[0]
        folder = os.path.join("results", "studies", name)
        if toile != "--page" and tables.run(toile, study, folder, jobs) not in (0, 4):
            sys.exit(f"{study} could not be run")
        title = tables.title(study)
        overview += cheapest(name, title, folder) + "\n"
        effectivity += effectivities(name, title, folder)
        sections += f"\n## {name}\n\n{title}, `{study}`.\n\n" + cases(folder) + "\n" + limits(folder)
        picture = tables.keep(os.path.join(folder, "error-time.svg"), f"doc/figures/error-time-{name}.svg")
        if picture:
            sections += f"\n![Error against time: {title}](figures/error-time-{name}.svg)\n"
    head = HEAD + "## The cheapest setting\n\n| study | 5 % | 1 % | 0.2 % |\n|---|---|---|---|\n"
    with open("doc/error-vs-time.md", "w") as file:
        file.write(head + overview + EFFECTIVITY + effectivity + sections)


if __name__ == "__main__":
    main(*sys.argv[1:])
