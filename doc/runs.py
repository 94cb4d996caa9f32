#!/usr/bin/python3
"""Runs scenes one after the other, and prints a table in Markdown of what they took and of their pressure.

Usage: runs.py scene.xml another.xml ...     (from the project's folder; results in results/<scene>)
"""

import csv
import os
import re
import subprocess
import sys
import tempfile

TOILE = "build/release/toile"


def told(text, pattern, default="-"):
    """The first group of the pattern in what a run told."""
    found = re.search(pattern, text)
    return found.group(1) if found else default


def levels(folder):
    """{level: "kPa +- error"} of a run; of several sections at a level the one with the largest girth."""
    path = os.path.join(folder, "pressure-levels.csv")
    largest = {}
    if not os.path.exists(path):
        return {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            name, girth = row["level"].split(" (")[0], float(row["girth [mm]"] or 0.0)
            if name not in largest or girth > largest[name][0]:
                largest[name] = (girth, f"{float(row['mean pressure [kPa]']):.3f} +- "
                                        f"{float(row['error of the mean pressure [kPa]']):.3f}")
    return {name: text for name, (_, text) in largest.items()}


def run(scene, folder, toile=TOILE):
    """Runs a scene: its exit status, what it told, and seconds of processor time. What it told is kept in log.txt."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([toile, "run", scene, "--output", folder], stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        output.seek(0)
        text = output.read()
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "log.txt"), "w") as file:
        file.write(text)
    return os.waitstatus_to_exitcode(status), text, usage.ru_utime + usage.ru_stime


def main(scenes):
    print("| scene | status | nodes | Newton iterations | processor time | of it body | memory | hem N | levels kPa |")
    print("|---|---|---|---|---|---|---|---|---|", flush=True)
    for scene in scenes:
        name = os.path.splitext(os.path.basename(scene))[0]
        folder = os.path.join("results", name)
        status, text, seconds = run(scene, folder)
        hem = [float(value) for value in told(text, r'support "hem" \(([^)]*)\)', "0, 0, 0").split(",")]
        print(f"| `{name}` | {status} | {told(text, r'mesh: ([0-9]+) nodes')} | "
              f"{told(text, r'([0-9]+) Newton iterations')} | {seconds:.0f} s | "
              f"{float(told(text, r'body +([0-9.]+) s ', '0')):.0f} s | {told(text, r'memory: ([0-9.]+ [A-Za-z]+)')} | "
              f"{abs(hem[2]):.2f} | " + ", ".join(f"{level} {value}" for level, value in levels(folder).items()) + " |",
              flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
