"""Gmsh's recombination of INPUT.triangles over INPUT.points for bench/compare, called as measure.hpp says; the tasks are the
names in SETTINGS. The mesh is Gmsh's before the clock starts; recombine() alone is timed."""
import json
import re
import sys
import time

import gmsh
import numpy

SETTINGS = {
    "simple": {"Mesh.RecombinationAlgorithm": 0},
    "blossom": {"Mesh.RecombinationAlgorithm": 1},
    "blossom-no-topology": {"Mesh.RecombinationAlgorithm": 1, "Mesh.RecombineOptimizeTopology": 0},
    "blossom-all-pairs": {"Mesh.RecombinationAlgorithm": 1, "Mesh.RecombineOptimizeTopology": 0,
                          "Mesh.RecombineMinimumQuality": 0},
}
CORNERS = {2: 3, 3: 4}  # of Gmsh's types of elements


def read_mesh(name):
    """As one surface; node i has the tag i + 1."""
    points = numpy.fromfile(f"{name}.points").reshape(-1, 2)
    corners = numpy.fromfile(f"{name}.triangles").astype(numpy.uint64)
    surface = gmsh.model.addDiscreteEntity(2)
    places = numpy.column_stack([points, numpy.zeros(len(points))])
    gmsh.model.mesh.addNodes(2, surface, numpy.arange(1, len(points) + 1), places.ravel())
    gmsh.model.mesh.addElementsByType(surface, 2, [], corners + 1)


def faces():
    """Corners of the elements by their number of corners, as tags."""
    types, _, nodes = gmsh.model.mesh.getElements(2)
    return {CORNERS[int(kind)]: numpy.array(tags) for kind, tags in zip(types, nodes)}


def write_result(name):
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = numpy.zeros((int(tags.max()) + 1, 2))
    place[tags.astype(int)] = coordinates.reshape(-1, 3)[:, :2]
    place.tofile(f"{name}.points")
    for corners, nodes in faces().items():
        nodes.astype(float).tofile(f"{name}.{'quads' if corners == 4 else 'triangles'}")


def status_bytes(name):
    with open("/proc/self/status") as status:
        return 1024 * int(re.search(rf"^{name}:\s*(\d+)", status.read(), re.MULTILINE)[1])


def main(task, name, result=None):
    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    read_mesh(name)
    for option, value in SETTINGS[task].items():
        gmsh.option.setNumber(option, value)
    with open("/proc/self/clear_refs", "w") as peak:
        peak.write("5")
    before = status_bytes("VmRSS")
    start = time.perf_counter()
    gmsh.model.mesh.recombine()
    seconds = time.perf_counter() - start
    peak = status_bytes("VmHWM")
    if result:
        write_result(result)
    print(json.dumps({"seconds": seconds, "bytes": max(0, peak - before), "version": gmsh.__version__}))


main(*sys.argv[1:])
