#!/usr/bin/python3
"""Pressure round the trunk at a height, of one run or of several side by side: a picture, and a CSV file beside it.

Usage: line.py picture.svg height results/one results/another ... [--panels front,back]

Lengths count along the fabric from the middle of the front towards the wearer's left, on both sides of it. Bands are the
told errors. Needs python3-vtk9 and gnuplot (see cmake/debian-packages.txt).
"""

import argparse
import csv
import math
import os
import subprocess

import render


def around(vtk, folder, height, panels):
    """[(mm along the fabric, kPa, its error)] of the points where the plane cuts the elements' sides."""
    blocks = render.read(vtk, os.path.join(folder, "results.exo"), -1)
    plane = vtk.vtkPlane()
    plane.SetOrigin(0.0, 0.0, height)
    plane.SetNormal(0.0, 0.0, 1.0)
    points = []
    for name in panels:
        cutter = vtk.vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputData(blocks[name])
        cutter.Update()
        cut = cutter.GetOutput()
        pressure, error = (cut.GetPointData().GetArray(field) for field in ("pressure", "pressure_error"))
        for i in range(cut.GetNumberOfPoints()):
            x, y, _ = cut.GetPoint(i)
            points.append((math.atan2(x, -y), x, y, pressure.GetValue(i), error.GetValue(i)))
    points.sort()  # by the angle from the front, which is towards -y
    length, line = 0.0, []
    for i, (angle, x, y, pressure, error) in enumerate(points):
        if i > 0:
            length += math.hypot(x - points[i - 1][1], y - points[i - 1][2])
        line.append((length, pressure, error, angle))
    middle = min(line, key=lambda point: abs(point[3]))[0]
    return [(length - middle, pressure, error) for length, pressure, error, _ in line]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", help="SVG file")
    parser.add_argument("height", type=float, help="mm")
    parser.add_argument("folders", nargs="+", help="results of runs")
    parser.add_argument("--panels", default="front,back", help="of the trunk (default: front,back)")
    arguments = parser.parse_args()
    import vtk  # pylint: disable=import-outside-toplevel
    table = os.path.splitext(arguments.picture)[0] + ".csv"
    plots = []
    with open(table, "w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["run", "length [mm]", "pressure [kPa]", "its error [kPa]"])
        for k, folder in enumerate(arguments.folders):
            name = os.path.basename(os.path.normpath(folder))
            line = around(vtk, folder, arguments.height, arguments.panels.split(","))
            rows.writerows([name, f"{length:.3f}", f"{pressure:.6g}", f"{error:.3g}"] for length, pressure, error in line)
            block = "\n".join(f"{length} {pressure} {max(0.0, pressure - error)} {pressure + error}"
                              for length, pressure, error in line)
            plots.append((k, name, block))
    script = (f'set terminal svg size 900,420 font "sans-serif,14" background "white"\nset output "{arguments.picture}"\n'
              'set xlabel "mm along the fabric from the middle of the front (left: positive)"\nset ylabel "kPa"\n'
              "set grid\nset yrange [0:*]\nset style fill transparent solid 0.2 noborder\n")
    colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"]
    for k, _, block in plots:
        script += f"$line{k} << end\n{block}\nend\n"
    script += "plot " + ", ".join(
        f'$line{k} using 1:3:4 with filledcurves lc rgb "{colours[k % 4]}" notitle, '
        f'$line{k} using 1:2 with lines lw 2 lc rgb "{colours[k % 4]}" title "{name}" noenhanced' for k, name, _ in plots)
    subprocess.run(["gnuplot"], input=script + "\n", text=True, check=True)


if __name__ == "__main__":
    main()
