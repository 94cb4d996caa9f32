#!/usr/bin/python3
"""Picture of a result: the garment coloured by a field, with its seams, and the body beside it with the field mapped on it.

Usage: render.py result.exo picture.png [--field pressure] [--mmhg] [--angle 30] [--step -1] [--up z] [--largest 1]

Needs python3-vtk9; without a display also xvfb and xauth (see cmake/debian-packages.txt).
"""

import argparse
import math
import os
import shutil
import sys

BODY = "body"
LABELS = {"pressure": "contact pressure\n(kPa)", "gap": "gap (mm)", "thickness": "thickness (mm)"}
# Perceptually even from dark to bright (value 0..1, red, green, blue).
COLOURS = [(0.00, 0.27, 0.00, 0.33), (0.25, 0.23, 0.32, 0.55), (0.50, 0.13, 0.57, 0.55), (0.75, 0.37, 0.79, 0.38),
           (1.00, 0.99, 0.91, 0.14)]
GREY = (0.78, 0.77, 0.75)
SEAM = (0.12, 0.10, 0.10)
MMHG_PER_KPA = 7.50062
BAR_WIDTH = 0.3  # of the picture's height: the strip of the colour bar, beside what is shown


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input", help="Exodus file of a run")
    parser.add_argument("output", help="PNG file")
    parser.add_argument("--field", default="pressure", help="field that colours the surfaces (default: pressure)")
    parser.add_argument("--angle", type=float, default=30.0, help="view angle about the vertical (default: 30 degrees)")
    parser.add_argument("--elevation", type=float, default=0.0, help="how far from above it is seen (default: 0 degrees, level)")
    parser.add_argument("--step", type=int, default=-1, help="step of the run, counted from 0; -1: the last (default)")
    parser.add_argument("--up", choices="xyz", default="z", help="vertical axis (default: z)")
    parser.add_argument("--largest", type=float, help="value of the brightest colour, in the unit that is shown (default: the largest value)")
    parser.add_argument("--mmhg", action="store_true", help="show a pressure in mmHg (default: kPa)")
    parser.add_argument("--no-seams", action="store_true", help="do not draw the seams")
    parser.add_argument("--label", help="text at the colour bar (default: the field with its unit)")
    parser.add_argument("--height", type=int, default=1200, help="height of the picture in pixels (default: 1200)")
    return parser.parse_args()


def ensure_display():
    """VTK of Debian draws through X: without a display, start again inside a virtual one."""
    if os.environ.get("DISPLAY") or sys.platform != "linux":
        return
    if shutil.which("xvfb-run") is None:
        sys.exit("render.py: no display and no xvfb-run; install the packages xvfb and xauth")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", sys.executable] + sys.argv)


def read(vtk, path, step):
    """The element blocks at one step, by name, with displacements applied."""
    if not os.path.isfile(path):
        sys.exit(f"render.py: '{path}': no such file")
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    steps = reader.GetNumberOfTimeSteps()
    if steps == 0:
        sys.exit(f"render.py: '{path}' has no steps")
    if not -steps <= step < steps:
        sys.exit(f"render.py: '{path}' has the steps 0 to {steps - 1}, not {step}")
    for kind in (reader.NODAL, reader.ELEM_BLOCK):
        reader.SetAllArrayStatus(kind, 1)
    reader.ApplyDisplacementsOn()
    reader.SetDisplacementMagnitude(1.0)
    times = reader.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    reader.UpdateTimeStep(times[step])
    elements = reader.GetOutput().GetBlock(0)
    names = [elements.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()) for i in range(elements.GetNumberOfBlocks())]
    return {name: elements.GetBlock(i) for i, name in enumerate(names) if elements.GetBlock(i) is not None}


def has_field(grid, field):
    return bool(grid.GetPointData().HasArray(field) or grid.GetCellData().HasArray(field))


def field_names(blocks):
    names = set()
    for grid in blocks.values():
        for data in (grid.GetPointData(), grid.GetCellData()):
            names.update(data.GetArrayName(i) for i in range(data.GetNumberOfArrays()))
    return sorted(names)


def to_mmhg(blocks, field):
    """Changes the values of a pressure from kPa to mmHg, where they are."""
    for grid in blocks.values():
        for data in (grid.GetPointData(), grid.GetCellData()):
            values = data.GetArray(field)
            for i in range(values.GetNumberOfTuples() if values is not None else 0):
                values.SetValue(i, MMHG_PER_KPA * values.GetValue(i))
            if values is not None:
                values.Modified()


def seams(vtk, grids):
    """Lines where edges of panels lie on each other, of the same panel or of two; empty before they are sewn."""
    edges = vtk.vtkAppendPolyData()
    size = 0.0
    for grid in grids:
        boundary = vtk.vtkFeatureEdges()
        geometry = vtk.vtkGeometryFilter()
        geometry.SetInputData(grid)
        boundary.SetInputConnection(geometry.GetOutputPort())
        boundary.FeatureEdgesOff()
        boundary.NonManifoldEdgesOff()
        boundary.ManifoldEdgesOff()
        boundary.ColoringOff()
        boundary.Update()
        edges.AddInputData(boundary.GetOutput())
        size = max(size, grid.GetLength())
    merged = vtk.vtkCleanPolyData()
    merged.SetInputConnection(edges.GetOutputPort())
    merged.ToleranceIsAbsoluteOn()
    merged.SetAbsoluteTolerance(1e-6 * size)
    merged.Update()
    lines = {}
    for i in range(merged.GetOutput().GetNumberOfCells()):
        cell = merged.GetOutput().GetCell(i)
        if cell.GetNumberOfPoints() == 2:
            pair = tuple(sorted((cell.GetPointId(0), cell.GetPointId(1))))
            lines[pair] = lines.get(pair, 0) + 1
    cells = vtk.vtkCellArray()
    for pair, times in lines.items():
        if times > 1:
            cells.InsertNextCell(2)
            cells.InsertCellPoint(pair[0])
            cells.InsertCellPoint(pair[1])
    result = vtk.vtkPolyData()
    result.SetPoints(merged.GetOutput().GetPoints())
    result.SetLines(cells)
    return result


def value_range(grids, field):
    """Limits of the colours from the given blocks alone; from zero unless that would hide the differences."""
    ranges = []
    for grid in grids:
        data = grid.GetPointData() if grid.GetPointData().HasArray(field) else grid.GetCellData()
        ranges.append(data.GetArray(field).GetRange())
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    if 0.0 <= low < 0.5 * high:
        low = 0.0
    if high - low > 1e-9 * max(abs(low), abs(high)):
        return low, high
    # A field that is the same everywhere, but for rounding.
    return (min(low, 0.0), max(high, 0.0)) if low != 0.0 or high != 0.0 else (0.0, 1.0)


def label_format(limits, number):
    """Format of so many digits that no two of `number` even labels are the same."""
    step = (limits[1] - limits[0]) / (number - 1)
    digits = math.ceil(math.log10(max(abs(limits[0]), abs(limits[1])) / step)) + 1
    return f"%.{max(digits, 3)}g"


def colour_map(vtk, limits, grey_below=False):
    """256 colours over the limits; `grey_below` shows what nothing touches, at zero or below the limits, in grey."""
    function = vtk.vtkColorTransferFunction()
    for value, red, green, blue in COLOURS:
        function.AddRGBPoint(value, red, green, blue)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255.0))
    table.SetRange(*limits)
    if grey_below:
        shift = 1e-3 if limits[0] == 0.0 else -1e-3
        table.SetRange(limits[0] + shift * (limits[1] - limits[0]), limits[1])
        table.SetBelowRangeColor(*GREY, 1.0)
        table.UseBelowRangeColorOn()
    return table


def surface(vtk, grid):
    geometry = vtk.vtkGeometryFilter()
    geometry.SetInputData(grid)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(geometry.GetOutputPort())
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def actor(vtk, grid, field=None, colours=None, in_front=False):
    """One block, in the field's colours or in grey."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface(vtk, grid))
    if field is None:
        mapper.ScalarVisibilityOff()
    else:
        if grid.GetPointData().HasArray(field):
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(field)
        mapper.SetLookupTable(colours)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    if in_front:
        # The fabric lies so close to the body that coarse triangles of the body would show through.
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-4.0, -400.0)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(*GREY)
    result.GetProperty().SetAmbient(0.25)
    result.GetProperty().SetDiffuse(0.8)
    return result


def seam_actor(vtk, lines, width):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(lines)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-8.0, -800.0)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(*SEAM)
    result.GetProperty().SetLineWidth(width)
    result.GetProperty().LightingOff()
    return result


def colour_bar(vtk, colours, label, font_size):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(label)
    bar.SetNumberOfLabels(6)
    bar.SetLabelFormat(label_format(colours.GetRange(), 6))
    bar.SetUnconstrainedFontSize(True)
    bar.SetVerticalTitleSeparation(16)
    bar.SetBarRatio(0.18)
    bar.SetMaximumNumberOfColors(256)
    bar.SetPosition(0.05, 0.15)
    bar.SetWidth(0.9)
    bar.SetHeight(0.70)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(font_size)
        text.ShadowOff()
        text.ItalicOff()
        text.BoldOff()
    return bar


def camera_axes(up, angle, elevation):
    """Unit vectors from the scene to the camera, to the right and upwards."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    level, above = math.cos(math.radians(elevation)), math.sin(math.radians(elevation))
    third = "xyz".index(up)
    first, second = (third + 1) % 3, (third + 2) % 3
    towards, right, upwards = [0.0] * 3, [0.0] * 3, [0.0] * 3
    towards[first], towards[second], towards[third] = level * cosine, level * sine, above
    right[first], right[second] = -sine, cosine
    upwards[first], upwards[second], upwards[third] = -above * cosine, -above * sine, level
    return towards, right, upwards


def extent(bounds, direction):
    """Width of a box seen along a direction."""
    return sum(abs(direction[k]) * (bounds[2 * k + 1] - bounds[2 * k]) for k in range(3))


def bounds_of(grids):
    boxes = [grid.GetBounds() for grid in grids]
    return [(min if k % 2 == 0 else max)(box[k] for box in boxes) for k in range(6)]


def build_scene(vtk, blocks, options, label):
    """What is shown and, in a strip of its own, the colour bar; and how much wider than high the picture should be."""
    field = options.field
    renderer, strip = vtk.vtkRenderer(), vtk.vtkRenderer()
    for one in (renderer, strip):
        one.SetBackground(1.0, 1.0, 1.0)
    garment = {name: grid for name, grid in blocks.items() if name != BODY}
    limits = value_range([grid for grid in garment.values() if has_field(grid, field)], field)
    if options.largest is not None:
        limits = (min(limits[0], options.largest), options.largest)
    colours = colour_map(vtk, limits)
    for grid in garment.values():
        renderer.AddActor(actor(vtk, grid, field if has_field(grid, field) else None, colours, in_front=True))
    if not options.no_seams:
        renderer.AddActor(seam_actor(vtk, seams(vtk, garment.values()), width=options.height / 500))
    axes = camera_axes(options.up, options.angle, options.elevation)
    if BODY in blocks:
        body = blocks[BODY]
        renderer.AddActor(actor(vtk, body))
        if has_field(body, field):
            shift = 1.15 * extent(bounds_of(blocks.values()), axes[1])
            beside = actor(vtk, body, field, colour_map(vtk, limits, grey_below=limits[0] >= 0.0))
            beside.SetPosition(*[shift * component for component in axes[1]])
            renderer.AddActor(beside)
    ratio = look_at(renderer, *axes)
    strip.AddViewProp(colour_bar(vtk, colours, label, font_size=options.height // 50))
    edge = ratio / (ratio + BAR_WIDTH)
    renderer.SetViewport(0.0, 0.0, edge, 1.0)
    strip.SetViewport(edge, 0.0, 1.0, 1.0)
    return (renderer, strip), ratio + BAR_WIDTH


def look_at(renderer, towards, right, upwards):
    """Parallel view of everything. Returns width / height."""
    bounds = renderer.ComputeVisiblePropBounds()
    height, width = 1.08 * extent(bounds, upwards), 1.05 * extent(bounds, right)
    if min(height, width) < 1e-6 * max(height, width):
        sys.exit("render.py: the result is flat and is seen from its edge; choose another --up or --angle")
    ratio = min(max(width / height, 0.5), 2.5)
    scale = max(height, width / ratio)
    centre = [0.5 * (bounds[2 * k] + bounds[2 * k + 1]) for k in range(3)]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*[centre[k] + 2.0 * (height + width) * towards[k] for k in range(3)])
    camera.SetViewUp(*upwards)
    camera.SetParallelScale(0.5 * scale)
    renderer.ResetCameraClippingRange()
    return ratio


def main():
    options = arguments()
    try:
        import vtk
    except ImportError:
        sys.exit(f"render.py: {sys.executable} has no module vtk; install python3-vtk9 and use /usr/bin/python3")
    ensure_display()
    blocks = read(vtk, options.input, options.step)
    if not any(has_field(grid, options.field) for name, grid in blocks.items() if name != BODY):
        sys.exit(f"render.py: no field '{options.field}' on the garment; there are: {', '.join(field_names(blocks))}")
    label = options.label or LABELS.get(options.field, options.field)
    if options.mmhg:
        if not options.field.startswith("pressure"):
            sys.exit(f"render.py: --mmhg is for pressures, but the field is '{options.field}'")
        to_mmhg(blocks, options.field)
        label = options.label or LABELS.get(options.field, options.field).replace("kPa", "mmHg")
    renderers, ratio = build_scene(vtk, blocks, options, label)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(round(ratio * options.height), options.height)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.output)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
