#!/usr/bin/python3
"""Runs the stability matrix input/stability.xml and makes of it doc/stability.md.

Usage, from the project's folder: doc/stability.py [PATH-OF-toile] [jobs]
Results stay in results/stability; cells that are there already are not run again. With --page in the place of the program
only the page is made, of the results that are there. What doc/stability-explained.md says of
the worst cells stands at the end of the page.
"""
import collections
import os
import re
import sys

import study_tables as tables

HEAD = """# Stability matrix

Made by `doc/stability.py` from `input/stability.xml`; see [study](study.md) for the verdicts. A cell is right if its error is at
most its own error bar and 2 % together; one that only ran has no reference, and the reason is what it warns of. The bar
is the one that the run tells; the force of a support has none.
The condition number is that of the last tangent in its unknowns (mm, radians), on the surface in contact.

"""
VERDICTS = ["right", "ran", "warned", "refused", "wrong", "crashed", "endless"]


def reason_of(text):
    """The first sentence of a reason, without the path of the file and without the numbers that differ from cell to cell."""
    sentence = re.split(r"\. |; |\n", re.sub(r"^\S*?input/", "input/", text))[0]
    return re.sub(r"-?\d+\.?\d*(e[-+]\d+)?", "..", sentence).replace("|", "/")


def part(folder):
    rows = tables.table(folder, "study")
    axes = list(rows[0])[1:list(rows[0]).index("verdict")]
    text = ""
    verdicts = [v for v in VERDICTS if v != "ran" or any(row["verdict"] == v for row in rows)]
    for axis in axes:
        counts = collections.OrderedDict()
        for row in rows:
            counts.setdefault(row[axis], collections.Counter())[row["verdict"]] += 1
        if len(counts) > 1:
            text += f"\n| {axis} | " + " | ".join(verdicts) + " | largest condition number |\n|---|" + "---|" * len(verdicts)
            text += "---|\n"
            for value, count in counts.items():
                conditions = [float(row["condition number"]) for row in rows if row[axis] == value and row["condition number"]]
                text += f"| {value} | " + " | ".join(str(count[v]) if count[v] else "" for v in verdicts)
                text += f" | {max(conditions):.0e} |\n" if conditions else " | |\n"
    reasons = collections.Counter((row["verdict"], reason_of(row["reason"])) for row in rows if row["verdict"] != "right")
    if reasons:
        text += "\n| cells | verdict | reason |\n|---|---|---|\n"
        for (verdict, reason), count in reasons.most_common():
            text += f"| {count} | {verdict} | {reason} |\n"
    return text


def worst(folder, most=8):
    """The largest errors of cells that have a result."""
    rows = [row for row in tables.table(folder, "study") if row["error [%]"]]
    rows.sort(key=lambda row: -float(row["error [%]"]))
    text = "\n| cell | verdict | error % | warning |\n|---|---|---|---|\n"
    for row in rows[:most]:
        text += f"| {row['case'][5:]} | {row['verdict']} | {tables.rounded(row['error [%]'])} | {reason_of(row['reason'])} |\n"
    return text


def main(toile="build/release/toile", jobs=1):
    status = 0 if toile == "--page" else tables.run(toile, "input/stability.xml", "results/stability", jobs)
    if status not in (0, 4):
        sys.exit("the matrix could not be run")
    total, text = collections.Counter(), ""
    for name in sorted(os.listdir("results/stability")):
        folder = os.path.join("results", "stability", name)
        if not os.path.exists(os.path.join(folder, "study.csv")):
            continue
        total.update(row["verdict"] for row in tables.table(folder, "study"))
        text += f"\n## {tables.title(f'input/stability/{name}.xml')}\n" + part(folder) + "\nLargest errors:\n" + worst(folder)
    summary = f"{sum(total.values())} cells: " + ", ".join(f"{total[v]} {v}" for v in VERDICTS if total[v]) + ".\n"
    with open("doc/stability-explained.md") as file:
        explained = file.read()
    with open("doc/stability.md", "w") as file:
        file.write(HEAD + summary + text + "\n" + explained)


if __name__ == "__main__":
    main(*sys.argv[1:])
