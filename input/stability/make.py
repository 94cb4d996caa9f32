#!/usr/bin/python3
"""Makes what the stability matrix (../stability.xml) is run on: fabrics, exact pressures, bodies, and the studies.

    make.py      writes fabrics.xml, *.csv (but tips.csv), *.obj, tip-*.xml and the studies beside itself

The exact pressure of a sleeve of radius R0 on a body of curvature k, held to the wale stretch w, is k N with the tension
N = t dW/dc / w at the hoop stretch c: both laws are written down here once more, without Toile. mm, N, MPa.
"""
import csv
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))
R0, WALE = 50.0, 1.1  # radius of the flat sleeve over 2 pi, wale stretch

REBAR = {"pantyhose": [8.4667e-3, [0.0001, 0.1672, -2.225, 21.199, -62.05, 61.746],
                       [0.0032, -0.075, 0.4653, -1.340, 1.9400, -0.986]],
         "t-shirt": [3.82e-2, [0.0064, 0.0786, -0.287, 0.2156, 0, 0], [-0.010, 0.0206, 0.0291, -0.013, 0, 0]]}
ITSKOV = {"pantyhose": [[1.2755e-2, 4.727, 1.003, 0.771, 0.229], [2.0569e-3, 1.475, 16.16, 0.585, 0.415],
                        [4.5867e-2, 1.736, 1.063, 0.652, 0.348]],
          "t-shirt": [[6.8837e-3, 3.52, 1.004, 0.321, 0.565], [8.6240e-2, 1.28, 13.49, 0.585 / 1.02, 0.435 / 1.02],
                      [1.2354e-1, 1.00, 1.002, 0.781, 0.219]]}
FACTORS = {"as is": 1.0, "10 times": 10.0, "1e3 times": 1e3, "1e5 times": 1e5}


def scaled(model, data, factor):
    if model == "rebar":
        return [data[0] * factor, [x * factor for x in data[1]], [x * factor for x in data[2]]]
    return [[term[0] * factor] + term[1:] for term in data]


def fabrics():
    """{name: (model, parameters)}"""
    found = {}
    for model, sets in (("rebar", REBAR), ("itskov", ITSKOV)):
        for name, data in sets.items():
            for text, factor in FACTORS.items():
                found[f"{model} {name} {text}"] = (model, scaled(model, data, factor))
            if model == "rebar":
                # Strain counts twice: e^i becomes (2 e)^i.
                steep = [data[0], [x * 2**i for i, x in enumerate(data[1])], [x * 2**i for i, x in enumerate(data[2])]]
                stiff_wale = [data[0], [1e3 * data[0]] + data[1][1:], data[2]]
                fibres = [1e-4, [1.0] + [0.0] * 5, [1.0] + [0.0] * 5]
            else:
                steep = [[m, 2 * a, 2 * b, u, v] for m, a, b, u, v in data]
                stiff_wale = data[:2] + [[1e3 * data[2][0], 1.0, 1.0, 1.0, 0.0]]
                fibres = [[1e-4, 1.0, 1.0, 0.333, 0.333], [1.0, 1.5, 1.0, 1.0, 0.0], [1.0, 1.5, 1.0, 0.0, 1.0]]
            found[f"{model} {name} exponents doubled"] = (model, steep)
            found[f"{model} {name} stiff wale"] = (model, stiff_wale)
            if name == "pantyhose":
                found[f"{model} soft matrix"] = (model, fibres)
    return found


def fibre_stress(coefficients, e):
    """dW/de of a fibre family; beyond e = 1 it goes on linearly, shortened it carries nothing."""
    if e <= 0.0:
        return 0.0
    end = min(e, 1.0)
    stress = sum(c * end ** (i + 1) / (i + 1) for i, c in enumerate(coefficients))
    return stress + (e - end) * sum(c * end**i for i, c in enumerate(coefficients))


def tension(model, data, wale, course, thickness=1.0):
    """N/mm round the sleeve, a current length along it."""
    a, b = wale * wale, course * course
    c = 1.0 / (a * b)
    if model == "rebar":
        derivative = data[0] * 2.0 * (course - c / course)  # dW/dcourse
        derivative += fibre_stress(data[2], math.log(course)) / course
    else:
        derivative = 0.0
        for mu, alpha, beta, w1, w2 in data:
            w3 = 1.0 - w1 - w2
            j, k = w1 * a + w2 * b + w3 * c, w1 / a + w2 / b + w3 / c
            dj, dk = 2.0 * (w2 * course - w3 * c / course), 2.0 * (-w2 / b / course + w3 / c / course)
            derivative += 0.25 * mu * (j ** (alpha - 1.0) * dj + k ** (beta - 1.0) * dk)
    return thickness * derivative / wale


def parameter(name, kind, value):
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def material(name, model, data):
    lines = [f'    <ParameterList name="{name}">', "      " + parameter("type", "string", model)]
    if model == "rebar":
        values = {"C10": data[0], **{f"c{i}": x for i, x in enumerate(data[1])},
                  **{f"d{i}": x for i, x in enumerate(data[2])}}
    else:
        values = {}
        for r, term in enumerate(data, 1):
            for key, x in zip((f"mu{r}", f"alpha{r}", f"beta{r}", f"w1_{r}", f"w2_{r}"), term):
                values[key] = x
    lines += ["      " + parameter(key, "double", repr(float(x))) for key, x in values.items()]
    return "\n".join(lines + ["    </ParameterList>"])


def write(name, text):
    with open(os.path.join(HERE, name), "w") as file:
        file.write(text)


def write_csv(name, rows):
    with open(os.path.join(HERE, name), "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows(rows)


def change(name, paths, values, labels=None, **more):
    lines = [f'    <ParameterList name="{name}">']
    for key, value in more.items():
        kind = "bool" if value is True else "string"
        lines.append("      " + parameter(key.rstrip("_"), kind, "true" if value is True else value))
    lines.append("      " + parameter("paths", "Array(string)", "{" + ", ".join(paths) + "}"))
    lines.append("      " + parameter("values", "Array(string)", "{" + ", ".join(str(v) for v in values) + "}"))
    if labels:
        lines.append("      " + parameter("labels", "Array(string)", "{" + ", ".join(labels) + "}"))
    return "\n".join(lines + ["    </ParameterList>"]) + "\n"


def study(name, title, scene, changes, quantities, limit=120):
    text = f'<!-- Made by make.py. -->\n<ParameterList name="study">\n  {parameter("title", "string", title)}\n'
    text += f'  {parameter("scene", "string", scene)}\n  {parameter("time limit", "double", limit)}\n'
    text += f'  {parameter("tolerance", "double", 2)}\n  {parameter("targets", "Array(double)", "{}")}\n'
    text += '  <ParameterList name="Vary">\n' + "".join(changes) + "  </ParameterList>\n"
    text += '  <ParameterList name="Quantities">\n'
    for key, kind, of, more in quantities + [("condition number", "figure", "condition number", [])]:
        text += f'    <ParameterList name="{key}">\n      {parameter("type", "string", kind)}\n'
        if of:
            text += f'      {parameter("of", "string", of)}\n'
        for line in more:
            text += "      " + line + "\n"
        text += "    </ParameterList>\n"
    write(name + ".xml", text + "  </ParameterList>\n</ParameterList>\n")


def reference_file(name):
    return [parameter("reference file", "string", name)]


def sheets(all_fabrics):
    """Every fabric, as a membrane and as shells of three thicknesses, stretched little to four times."""
    sheet = {"membrane": 1.0, "shell 1": 1.0, "shell 0.1": 0.1, "shell 0.01": 0.01}
    radii = {"1.05": 52.5, "1.2": 60.0, "4": 200.0}
    rows = [["fabric", "sheet", "stretch", "value"]]
    for name, (model, data) in all_fabrics.items():
        for text, thickness in sheet.items():
            for stretch, radius in radii.items():
                rows.append([name, text, stretch,
                             repr(1e3 * tension(model, data, WALE, radius / R0, thickness) / radius)])
    write_csv("fabrics.csv", rows)
    names = list(all_fabrics)
    study("fabrics-matrix", "Fabrics, thickness and stretch", "sleeve.xml", [
        change("fabric", ["Panels/sleeve/material"], names, problem=True),
        change("sheet", ["include"], ["-", "shell.xml", "shell.xml", "shell.xml"], list(sheet), problem=True),
        change("thickness", [f"Materials/{n}/thickness" for n in names], sheet.values(), with_="sheet"),
        change("stretch", ["Body/radius"], radii.values(), list(radii), problem=True)],
          [("pressure", "level", "middle", reference_file("fabrics.csv"))])


def lengths(all_fabrics):
    """The same sleeve a thousand times smaller to a hundred times larger: its pressure is the same."""
    factors = [0.001, 0.01, 0.1, 1, 10, 100]
    names = [n for n in all_fabrics if n.endswith("as is")]
    rows = [["fabric", "value"]]
    for name in names:
        rows.append([name, repr(1e3 * tension(*all_fabrics[name], WALE, 1.2) / 60.0)])
    write_csv("lengths.csv", rows)
    scaled_paths = {"width": ("Panels/sleeve/width", 2 * math.pi * R0), "height": ("Panels/sleeve/height", 40),
                    "to": ("Panels/sleeve/Placement/to", 44), "radius": ("Body/radius", 60), "top": ("Body/top", 200),
                    "level": ("Output/Levels/middle/height", 22)}
    changes = [change("fabric", ["Panels/sleeve/material"], names, problem=True),
               change("size", [f"Materials/{n}/thickness" for n in names], factors, problem=True)]
    for name, (path, value) in scaled_paths.items():
        changes.append(change(name, [path], [repr(value * f) for f in factors], with_="size"))
    study("lengths-matrix", "Lengths", "sleeve.xml", changes,
          [("pressure", "level", "middle", reference_file("lengths.csv"))])


def strips():
    """Elements of any shape, in one step to many, against an independent solution."""
    meshes = {"square": (30, 10), "1 to 20": (150, 3), "20 to 1": (12, 80), "90 to 1": (8, 240)}
    force = [("force", "reaction", "right", [parameter("component", "string", "x"),
                                             parameter("reference", "Array(double)", "{0.8221763, 2.2156}")])]
    study("strips-matrix", "Shapes of elements and sizes of steps", "strip.xml", [
        change("fabric", ["Materials/fabric/type"], ["rebar", "itskov"], problem=True),
        change("elements", ["Panels/sheet/elements"], ["quadrilateral", "triangle"]),
        change("mesh", ["Panels/sheet/elements across"], [m[0] for m in meshes.values()], list(meshes)),
        change("rows", ["Panels/sheet/elements along"], [m[1] for m in meshes.values()], with_="mesh"),
        change("first step", ["Stages/pull/first step"], [1, 0.05])], force)
    study("free-matrix", "Free meshes, whose elements have every shape", "free-strip.xml", [
        change("fabric", ["Materials/fabric/type"], ["rebar", "itskov"], problem=True),
        change("elements", ["Panels/sheet/elements"], ["quadrilateral", "triangle"]),
        change("size", ["Panels/sheet/element size"], [12, 7, 4, 2]),
        change("first step", ["Stages/pull/first step"], [1, 0.05])], force)


def column(path, sections):
    """A closed body from sections, each a ring of points and its height."""
    n = len(sections[0][0])
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for ring, z in sections for x, y in ring]
    faces = []
    for s in range(len(sections) - 1):
        for i in range(n):
            j = (i + 1) % n
            faces.append((s * n + i, s * n + j, (s + 1) * n + j, (s + 1) * n + i))
    return lines, faces, n


def write_bodies(name, columns):
    """Columns from z = 0 to 120 mm with flat ends."""
    lines, faces = [], []
    for ring in columns:
        start = len(lines)
        sections = [(ring, 10.0 * k) for k in range(13)]
        own, quads, n = column(name, sections)
        centre = [sum(p[d] for p in ring) / n for d in (0, 1)]
        lines += own + [f"v {centre[0]:.6f} {centre[1]:.6f} 0", f"v {centre[0]:.6f} {centre[1]:.6f} 120"]
        faces += [tuple(start + v for v in quad) for quad in quads]
        bottom, top, last = start + len(own), start + len(own) + 1, start + 12 * n
        faces += [(bottom, start + (i + 1) % n, start + i) for i in range(n)]
        faces += [(top, last + i, last + (i + 1) % n) for i in range(n)]
    text = "\n".join(lines + ["f " + " ".join(str(v + 1) for v in face) for face in faces])
    write(name, text + "\n")


def circle(radius, n, x=0.0):
    return [(x + radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


def outline(radius, distance, n):
    """Two circles that overlap: the outline has two folds."""
    half = distance / 2
    opening = math.acos(half / radius)
    right = [(half + radius * math.cos(a), radius * math.sin(a))
             for a in (-math.pi + opening + (2 * math.pi - 2 * opening) * i / n for i in range(n))]
    return right + [(-x, -y) for x, y in right]


def ellipse_perimeter(a, b):
    n = 200000
    return sum(math.hypot(a * math.sin(t), b * math.cos(t)) for t in ((i + 0.5) * 2 * math.pi / n for i in range(n))
               ) * 2 * math.pi / n


def bodies(all_fabrics):
    """Edges, gaps, folds, facets, and a sleeve beyond the end of the body."""
    write_bodies("facets.obj", [circle(60, 16)])
    write_bodies("gap.obj", [circle(30, 48, -30.25), circle(30, 48, 30.25)])
    write_bodies("fold.obj", [outline(30, 40, 36)])
    whole = 2 * math.pi * R0
    kinds = {  # file: curvature where the sleeve is looked at, girth of the body there, width of the sleeve
        "edge.xml": (100 / 10.0**2, ellipse_perimeter(100, 10), whole),
        "facets.xml": (1 / 60, 2 * 16 * 60 * math.sin(math.pi / 16), whole),
        "gap.xml": (1 / 30, 2 * math.pi * 30, 2 * math.pi * 25),
        "fold.xml": (1 / 30, 2 * math.pi * 30 + 2 * 40.0, 224.0),
        "beyond-tip.xml": (None, None, None),  # to be refused
    }
    names = [n for n in all_fabrics if n.endswith("as is")]
    rows = [["fabric", "body", "value"]]
    for name in names:
        for kind, (curvature, girth, width) in kinds.items():
            value = "nan" if curvature is None else repr(
                1e3 * curvature * tension(*all_fabrics[name], WALE, girth / width))
            rows.append([name, kind[:-4], value])
    write_csv("bodies.csv", rows)
    study("bodies-matrix", "Bodies", "sleeve.xml", [
        change("fabric", ["Panels/sleeve/material"], names, problem=True),
        change("body", ["include"], kinds, [k[:-4] for k in kinds], problem=True),
        change("around", ["Panels/sleeve/elements across"], [48, 192])],
          [("pressure", "point", "there", reference_file("bodies.csv"))])


def tips(all_fabrics):
    """A sheet drawn over a tip: what its sides carry has a limit on finer meshes, the pressure on a sharp tip has none.

    tips.csv is kept, not made: the same sheets on free meshes of 4 mm, at the tip of 0.25 to 1 mm ("Sizes", over 25 mm);
    between 1 and 0.25 mm the force changes by 0.5 %. Over sharper tips none is given: the rebar fabrics tear on fine
    meshes before the end of the way, and the force of the others has not converged.
    """
    height = 60.0
    shapes = {"round 1 mm": ("ellipsoid", {"radius": math.sqrt(height), "half height": height})}
    for angle in (15, 30, 45, 60):
        slope = math.tan(math.radians(angle))
        shapes[f"{angle} degrees"] = ("cone", {"radius": height * slope, "slope": -slope, "bottom": 0.0,
                                               "top": height - 0.01})
    files = {name: f"tip-{name.replace(' ', '-')}.xml" for name in shapes}
    for name, (kind, values) in shapes.items():
        lines = [parameter("replace", "bool", "true"), parameter("type", "string", kind)]
        lines += [parameter(key, "double", repr(value)) for key, value in values.items()]
        write(files[name], '<!-- Made by make.py. -->\n<ParameterList name="scene">\n  <ParameterList name="Body">\n' +
              "".join(f"    {line}\n" for line in lines) + "  </ParameterList>\n</ParameterList>\n")
    study("tips-matrix", "A sheet over a tip", "sheet-on-tip.xml", [
        change("fabric", ["Panels/sheet/material"], [n for n in all_fabrics if n.endswith("as is")], problem=True),
        change("body", ["include"], files.values(), list(files), problem=True),
        change("tip", ["Panels/sheet/Placement/origin"], ["-50 -50 61", "-51.3 -52.1 61"], ["centre", "beside"],
               problem=True),
        change("mesh", ["Panels/sheet/elements across", "Panels/sheet/elements along"], [13, 25, 49])],
          [("force", "body force", "", [parameter("component", "string", "z")] + reference_file("tips.csv"))])


def main():
    found = fabrics()
    write("fabrics.xml", '<!-- Made by make.py. -->\n<ParameterList name="scene">\n  <ParameterList name="Materials">\n' +
          "\n".join(material(name, *data) for name, data in found.items()) + "\n  </ParameterList>\n</ParameterList>\n")
    sheets(found)
    lengths(found)
    strips()
    bodies(found)
    tips(found)


if __name__ == "__main__":
    main()
