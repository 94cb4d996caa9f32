#!/usr/bin/python3
"""Runs the T-shirt in 20 variations of body, pattern, mesh and fabric, and prints a table in Markdown of how they ended.

Usage: variations.py [toile] [folder]     (build/release/toile, results/tshirt-variations)
"""

import os
import re
import sys

from runs import levels, run, told

INPUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "input")
MESHES = {"coarse": 15.2, "middle": 6.6, "fine": 3.9}
# Size of the body, size of the pattern, mesh, fabric.
CASES = ([(body, pattern, "coarse", "rebar") for body in (0.92, 1.0, 1.08) for pattern in (0.94, 1.0, 1.06)]
         + [(body, pattern, "coarse", "itskov") for body in (0.92, 1.08) for pattern in (0.94, 1.06)]
         + [(body, pattern, "middle", "rebar") for body in (0.92, 1.08) for pattern in (0.94, 1.06)]
         + [(0.92, 1.06, "middle", "itskov"), (1.08, 0.94, "middle", "itskov"), (1.0, 1.0, "fine", "rebar")])


def vector(values):
    return "{" + ", ".join(f"{value:.10g}" for value in values) + "}"


def sleeve(side, name, body, pattern):
    """The sleeve starts round the arm, whose place goes with the body."""
    return f"""
    <ParameterList name="{name}">
      <ParameterList name="Placement">
        <Parameter name="axis bottom" type="Array(double)" value="{vector([side * 290 * body, -26 * body, 1098 * body])}"/>
        <Parameter name="axis top" type="Array(double)" value="{vector([side * 210 * body, -20 * body, 1196 * body])}"/>
        <Parameter name="from" type="double" value="{24 * body:.10g}"/>
        <Parameter name="to" type="double" value="{24 * body + 212 * pattern:.10g}"/>
        <Parameter name="around" type="Array(double)" value="{vector([50 * body, 50 * body])}"/>
      </ParameterList>
    </ParameterList>"""


def level(name, height):
    return f"""
      <ParameterList name="{name}"><Parameter name="height" type="double" value="{height:.10g}"/></ParameterList>"""


def scene(folder, body, pattern, mesh, law):
    """Writes the scene and its pattern, whose unit makes it larger or smaller; returns the scene's path."""
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(INPUT, "patterns", "tshirt.json")) as file:
        text = file.read()
    with open(os.path.join(folder, "pattern.json"), "w") as file:
        file.write(re.sub(r'("units_in_meter":\s*)1000', lambda found: f"{found.group(1)}{1000 / pattern:.10g}", text))
    path = os.path.join(folder, "scene.xml")
    with open(path, "w") as file:
        file.write(f"""<ParameterList name="scene">
  <Parameter name="include" type="Array(string)" value="{{{os.path.relpath(os.path.join(INPUT, "tshirt.xml"), folder)}}}"/>
  <ParameterList name="Body">
    <Parameter name="file" type="string" value="{os.path.relpath(os.path.join(INPUT, "bodies", "female_body.obj"), folder)}"/>
    <Parameter name="scale" type="double" value="{body}"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="knit"><Parameter name="type" type="string" value="{law}"/></ParameterList>
  </ParameterList>
  <ParameterList name="Pattern">
    <Parameter name="file" type="string" value="pattern.json"/>
    <Parameter name="element size" type="double" value="{MESHES[mesh]}"/>
    <ParameterList name="Placement">
      <Parameter name="origin" type="Array(double)" value="{vector([0, 0, 905 * body])}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Panels">{sleeve(1, "left_sleeve", body, pattern)}{sleeve(-1, "right_sleeve", body, pattern)}
  </ParameterList>
  <ParameterList name="Output">
    <ParameterList name="Points">
      <Parameter name="replace" type="bool" value="true"/>
    </ParameterList>
    <ParameterList name="Levels">{level("bust", 1160 * body)}{level("underbust", 1110 * body)}{level("waist", 1020 * body)}
    </ParameterList>
  </ParameterList>
</ParameterList>
""")
    return path


def main(toile, results):
    print("| body | pattern | mesh | fabric | status | nodes | iterations | s | bust kPa | underbust kPa | waist kPa |")
    print("|---|---|---|---|---|---|---|---|---|---|---|", flush=True)
    for body, pattern, mesh, law in CASES:
        folder = os.path.join(results, f"body-{body}-pattern-{pattern}-{mesh}-{law}")
        status, text, seconds = run(scene(folder, body, pattern, mesh, law), folder, toile)
        pressure = levels(folder) if status == 0 else {}
        print(f"| {body} | {pattern} | {mesh} | {law} | {status} | {told(text, r'mesh: ([0-9]+) nodes')} | "
              f"{told(text, r'([0-9]+) Newton iterations')} | {seconds:.0f} | "
              + " | ".join(pressure.get(name, "-") for name in ("bust", "underbust", "waist")) + " |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) > 3:
        sys.exit(__doc__)
    main(sys.argv[1] if len(sys.argv) > 1 else "build/release/toile",
         sys.argv[2] if len(sys.argv) > 2 else "results/tshirt-variations")
