"""Opens a run's frames in ParaView, checks times and counts, and renders the last one to a PNG.

usage: xvfb-run -a -s -noreset pvbatch paraview_frames.py FRAMES_FOLDER PICTURE.png [PARTICLES]

Loads particles.hdf.series, polyhedra.hdf.series, liner.hdf.series and contacts.hdf.series, those that
are there, the way the file dialog does.
The times are compared with the series files, the number of particles of each frame (spheres and
polyhedra) with PARTICLES if given; all fields must be there. The picture is seen along -z, in
perspective so that the shell shows: spheres of true size and polyhedra in their true shapes
coloured by speed, the liner as a translucent surface. A picture of one colour only means
that nothing was drawn and counts as a failure. Exits 1 on any failure.
"""

import json
import os
import sys

import paraview.simple as pv
from paraview import servermanager
from vtkmodules.vtkIOImage import vtkPNGReader


def fail(message):
    print(f"error: {message}", file=sys.stderr)
    sys.stderr.flush()
    os._exit(1)  # pvbatch turns sys.exit into 0


def load(folder, name):
    """Reader of a series, and the times it should have; (None, []) if there is none."""
    path = os.path.join(folder, f"{name}.hdf.series")
    if not os.path.isfile(path):
        return None, []
    with open(path, encoding="utf-8") as file:
        times = [entry["time"] for entry in json.load(file)["files"]]
    reader = pv.OpenDataFile(path)
    if reader is None:
        fail(f"ParaView does not open {path}")
    reader.UpdatePipelineInformation()
    found = reader.TimestepValues
    found = list(found) if hasattr(found, "__len__") else [found]
    if found != times:
        fail(f"{path}: ParaView finds the times {found}, the series has {times}")
    return reader, times


def check_spheres(reader, times):
    """The number of spheres at each time."""
    found = []
    for time in times:
        reader.UpdatePipeline(time)
        info = reader.GetDataInformation()
        points, cells = info.GetNumberOfPoints(), info.GetNumberOfCells()
        found.append(points)
        if points != cells:
            fail(f"t = {time}: {points} points and {cells} cells")
        if points == 0:
            continue
        for name, components in (("radius", 1), ("velocity", 3), ("speed", 1), ("spin", 3),
                                 ("id", 1), ("species", 1), ("class", 1),
                                 ("contacts", 1)):
            array = reader.PointData.GetArray(name)
            if array is None or array.GetNumberOfComponents() != components:
                fail(f"t = {time}: no point data '{name}' of {components} components")
        low, high = reader.PointData.GetArray("radius").GetRange()
        if not 0 < low <= high:
            fail(f"t = {time}: radii from {low} to {high}")
        print(f"t = {time}: {points} spheres, radius {low} ... {high} m")
    return found


def check_polyhedra(reader, times):
    """The number of polyhedra at each time."""
    found = []
    for time in times:
        reader.UpdatePipeline(time)
        if reader.GetDataInformation().GetNumberOfCells() == 0:
            found.append(0)
            continue
        for name in ("id", "species", "class", "contacts", "speed", "spin_magnitude"):
            if reader.CellData.GetArray(name) is None:
                fail(f"t = {time}: no cell data '{name}'")
        ids = servermanager.Fetch(reader).GetCellData().GetArray("id")
        found.append(len({ids.GetValue(k) for k in range(ids.GetNumberOfTuples())}))
        print(f"t = {time}: {found[-1]} polyhedra of {ids.GetNumberOfTuples()} triangles")
    return found


def check_contacts(reader, times):
    for time in times:
        reader.UpdatePipeline(time)
        info = reader.GetDataInformation()
        points, cells = info.GetNumberOfPoints(), info.GetNumberOfCells()
        if points != cells:
            fail(f"t = {time}: {points} points and {cells} cells of contacts")
        print(f"t = {time}: {points} contacts")
        if points == 0:
            continue
        for name, components in (("force", 3), ("normal", 3), ("overlap", 1), ("normal_force", 1),
                                 ("tangential_force", 1), ("first", 1), ("second", 1), ("wall", 1),
                                 ("kind", 1)):
            array = reader.PointData.GetArray(name)
            if array is None or array.GetNumberOfComponents() != components:
                fail(f"t = {time}: no point data '{name}' of {components} components")


def check_liner(reader, times):
    for time in times:
        reader.UpdatePipeline(time)
        if reader.GetDataInformation().GetNumberOfCells() == 0:
            fail(f"t = {time}: the liner is empty")
        for name in ("wall", "speed"):
            if reader.CellData.GetArray(name) is None:
                fail(f"t = {time}: no cell data '{name}'")


def speed_range(reader, data):
    array = getattr(reader, data).GetArray("speed")
    return array.GetRange() if array is not None else (0.0, 0.0)


def show_spheres(particles, view):
    spheres = pv.Glyph(Input=particles, GlyphType="Sphere")
    spheres.GlyphType.Radius = 1.0
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 16
    spheres.ScaleArray = ["POINTS", "radius"]
    spheres.ScaleFactor = 1.0
    spheres.OrientationArray = ["POINTS", "No orientation array"]
    spheres.GlyphMode = "All Points"
    shown = pv.Show(spheres, view)
    pv.ColorBy(shown, ("POINTS", "speed"))


def render(particles, polyhedra, liner, time, picture):
    view = pv.CreateRenderView()
    view.ViewSize = [1000, 860]
    view.OrientationAxesVisibility = 0
    view.ViewTime = time
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    ranges = []
    particles.UpdatePipeline(time)
    if particles.GetDataInformation().GetNumberOfPoints() > 0:
        show_spheres(particles, view)
        ranges.append(speed_range(particles, "PointData"))
    if polyhedra is not None:
        polyhedra.UpdatePipeline(time)
        shown = pv.Show(polyhedra, view)
        shown.Representation = "Surface"
        pv.ColorBy(shown, ("CELLS", "speed"))
        ranges.append(speed_range(polyhedra, "CellData"))
    colours = pv.GetColorTransferFunction("speed")
    colours.RescaleTransferFunction(min(low for low, _ in ranges), max(high for _, high in ranges))
    bar = pv.GetScalarBar(colours, view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle = "speed (m/s)", ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.RangeLabelFormat = bar.LabelFormat = "%.1f"
    if liner is not None:
        # The first wall only: a mill's ends would stand before the charge.
        first = pv.Threshold(liner, Scalars=["CELLS", "wall"])
        first.LowerThreshold = first.UpperThreshold = 0
        wall = pv.Show(first, view)
        wall.Representation = "Surface"
        wall.ColorArrayName = [None, ""]
        wall.DiffuseColor = [0.4, 0.4, 0.45]
        wall.Opacity = 0.3
    pv.ResetCamera(view)
    focus = view.CameraFocalPoint
    view.CameraPosition = [focus[0], focus[1], focus[2] + 10]
    view.CameraViewUp = [0, 1, 0]
    pv.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.25)
    pv.SaveScreenshot(picture, view)


def check_picture(picture):
    if not os.path.isfile(picture):
        fail(f"{picture} was not written")
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    ranges = [reader.GetOutput().GetPointData().GetScalars().GetRange(c) for c in range(3)]
    if all(low == high for low, high in ranges):
        fail(f"{picture} shows nothing")


def main():
    if len(sys.argv) not in (3, 4):
        fail(__doc__)
    folder, picture = sys.argv[1:3]
    expected = int(sys.argv[3]) if len(sys.argv) == 4 else None
    particles, times = load(folder, "particles")
    if particles is None or not times:
        fail(f"{folder}: no particles.hdf.series")
    polyhedra, polyhedron_times = load(folder, "polyhedra")
    liner, liner_times = load(folder, "liner")
    counts = check_spheres(particles, times)
    if polyhedra is not None:
        if polyhedron_times != times:
            fail(f"{folder}: spheres and polyhedra are of different times")
        bodies = check_polyhedra(polyhedra, times)
        counts = [sum(pair) for pair in zip(counts, bodies)]
    if expected is not None and set(counts) != {expected}:
        fail(f"{folder}: {counts} particles, expected {expected} in each frame")
    check_liner(liner, liner_times)
    contacts, contact_times = load(folder, "contacts")
    if contacts is not None:
        if contact_times != times:
            fail(f"{folder}: spheres and contacts are of different times")
        check_contacts(contacts, contact_times)
    render(particles, polyhedra, liner, times[-1], picture)
    check_picture(picture)
    print(f"{picture} written")


try:
    main()
except Exception as error:  # pvbatch would end with 0
    fail(f"{type(error).__name__}: {error}")
