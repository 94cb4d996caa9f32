#!/usr/bin/python3
"""Picture of a flat pattern from its JSON file: panels side by side; edges with the same number are sewn together.

Usage: pattern.py pattern.json picture.svg
"""

import json
import sys

GAP = 40.0  # mm between panels, and round them
PANEL, EDGE, STITCH = "#dbe4ee", "#23364d", "#b3471d"


def to_space(start, end, control):
    """A control point that is given relative to its edge: along it and to its left."""
    across = (start[1] - end[1], end[0] - start[0])
    return [start[i] + control[0] * (end[i] - start[i]) + control[1] * across[i] for i in (0, 1)]


def curve(start, end, controls):
    """Points of a Bezier curve, or the ends and the middle of a line."""
    points, pieces = [], 20 if controls else 2
    for k in range(pieces + 1):
        level, t = [start, *controls, end], k / pieces
        while len(level) > 1:
            level = [[(1.0 - t) * a[i] + t * b[i] for i in (0, 1)] for a, b in zip(level, level[1:])]
        points.append(level[0])
    return points


def points_of(panel, edge, relative):
    start, end = (panel["vertices"][k] for k in edge["endpoints"])
    bent = edge.get("curvature", [])
    controls = bent["params"] if isinstance(bent, dict) else [bent] if bent else []
    if isinstance(bent, dict) and bent["type"] == "circle":
        sys.exit("pattern.py: arcs of circles are not drawn")
    return curve(start, end, [to_space(start, end, c) for c in controls] if relative else controls)


def path_of(points):
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)


def text(x, y, content, colour, size):
    return (f'<text x="{x:.1f}" y="{y + size / 3:.1f}" font-size="{size}" text-anchor="middle" fill="{colour}">{content}</text>')


def draw(name, place, number):
    """Elements of one panel: its area, its edges, its name, the number of each stitch."""
    outline = [p for points in place for p in points[:-1]]
    drawn = [f'<polygon points="{path_of(outline)}" fill="{PANEL}"/>']
    for k, points in enumerate(place):
        sewn = (name, k) in number
        drawn.append(f'<polyline points="{path_of(points)}" fill="none" stroke="{STITCH if sewn else EDGE}" stroke-width="3"/>')
        if sewn:
            x, y = points[len(points) // 2]
            drawn.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="13" fill="white" stroke="{STITCH}" stroke-width="1.5"/>')
            drawn.append(text(x, y, number[name, k], STITCH, 15))
    middle = [(min(p[i] for p in outline) + max(p[i] for p in outline)) / 2.0 for i in (0, 1)]
    return drawn + [text(*middle, name.replace("_", " "), EDGE, 20)]


def main(path, picture):
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    relative = data["properties"].get("curvature_coords", "relative") == "relative"
    unit = 1000.0 / data["properties"].get("units_in_meter", 100.0)
    number = {}
    for k, pair in enumerate(data["pattern"]["stitches"]):
        for side in pair[:2]:
            number[side["panel"], side["edge"]] = k
    drawn, shift, height = [], GAP, 0.0
    for name, panel in data["pattern"]["panels"].items():
        edges = [[[unit * x for x in p] for p in points_of(panel, edge, relative)] for edge in panel["edges"]]
        every = [p for points in edges for p in points]
        left, low = (min(p[i] for p in every) for i in (0, 1))
        # SVG counts downwards.
        place = [[(p[0] - left + shift, low - p[1]) for p in points] for points in edges]
        drawn += draw(name, place, number)
        width = max(p[0] for p in every) - left
        height = max(height, max(p[1] for p in every) - low)
        drawn.append(text(shift + width / 2.0, GAP / 2.0, f"{width:.0f} mm wide", EDGE, 14))
        shift += width + GAP
    with open(picture, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 {-height - GAP:g} {shift:g} {height + 2 * GAP:g}" '
                   f'width="900" font-family="sans-serif">\n')
        file.write('<rect x="0" y="-100%" width="100%" height="200%" fill="white"/>\n' + "\n".join(drawn) + "\n</svg>\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
