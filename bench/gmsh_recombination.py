#!/usr/bin/env python3
"""Gmsh's recombination and ours on the same triangles, in one run; a table.

    python3 -m venv build/gmsh && build/gmsh/bin/pip install gmsh
    build/gmsh/bin/python bench/gmsh_recombination.py build/release/apps/quadloom/quadloom --points 100000
    build/gmsh/bin/python bench/gmsh_recombination.py QUADLOOM MESH.msh ...

Gmsh (GPL) is a peer to compare with and nothing that we depend on. Meshes are planar .msh files of triangles,
versions 2.2 and 4.1; random points are triangulated by Gmsh (Delaunay) and written as such a file. For an odd number
of triangles Gmsh's blossom does what its simple algorithm does.

The columns, all counted here and by the exact signs of determinants:
  quads, triangles   faces of the result; triangles are those left over
  non-convex         quads, the right way around, with a corner that does not turn left
  turned over        faces that are not simple and counter-clockwise, or have no area
  dropped, moved     vertices of the source that no face has any more, or that have other coordinates
  added              vertices that the source does not have
  seconds            Gmsh: its recombine() alone; ours: the whole command, which also reads the file, checks the
                     result and writes it
"""
import argparse
import pathlib
import random
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

import gmsh

ERROR = 3.3306690738754716e-16 * 1.01  # of the float filter
OURS = {
    "quadloom, default": [],
    "quadloom, triangles stay": ["--leftover", "triangle"],
    "quadloom, subdivide": ["--method", "subdivide"],
}
ALGORITHMS = {"simple": 0, "blossom": 1}
SETTINGS = {
    "default": {},
    "minimum quality 0": {"Mesh.RecombineMinimumQuality": 0},
    "no topology": {"Mesh.RecombineOptimizeTopology": 0},
    "no topology, quality 0": {"Mesh.RecombineOptimizeTopology": 0, "Mesh.RecombineMinimumQuality": 0},
}


def turn(a, b, c):
    """The exact sign of the turn a, b, c."""
    left = (a[0] - c[0]) * (b[1] - c[1])
    right = (a[1] - c[1]) * (b[0] - c[0])
    if abs(left - right) > ERROR * (abs(left) + abs(right)) + 1e-290:
        return 1 if left > right else -1
    ax, ay, bx, by, cx, cy = map(Fraction, (*a, *b, *c))
    det = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
    return (det > 0) - (det < 0)


def judge(corners):
    """'good', 'non-convex' or 'turned over'."""
    k = len(corners)
    turns = [turn(corners[i - 1], corners[i], corners[(i + 1) % k]) for i in range(k)]
    if min(turns) > 0:
        return "good"
    if k == 4 and ((turns[0] > 0 and turns[2] > 0) or (turns[1] > 0 and turns[3] > 0)):
        return "non-convex"
    return "turned over"


class Mesh:
    """Places of the vertices that faces have, by tag, and the faces as lists of tags."""

    def __init__(self, place, faces):
        used = {v for face in faces for v in face}
        self.place = {v: place[v] for v in used}
        self.faces = faces

    def turned(self):
        """The same with every face the other way around."""
        return Mesh(self.place, [face[::-1] for face in self.faces])


def mesh_of_gmsh():
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = {int(t): (coordinates[3 * i], coordinates[3 * i + 1]) for i, t in enumerate(tags)}
    faces = []
    types, _, nodes = gmsh.model.mesh.getElements(2)
    for kind, corners in zip(types, nodes):
        size = {2: 3, 3: 4}[int(kind)]
        faces += [[int(v) for v in corners[i:i + size]] for i in range(0, len(corners), size)]
    return Mesh(place, faces)


def mesh_of_obj(path, source):
    """Vertices at places of the source get its tags."""
    tag = {place: v for v, place in source.place.items()}
    place, name, faces = {}, [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ["v"]:
            at = (float(words[1]), float(words[2]))
            name.append(tag.get(at, -len(name) - 1))
            place[name[-1]] = at
        elif words[:1] == ["f"]:
            faces.append([name[int(w.split("/")[0]) - 1] for w in words[1:]])
    return Mesh(place, faces)


def count(source, result, seconds):
    verdicts = [judge([result.place[v] for v in face]) for face in result.faces]
    sizes = [len(face) for face in result.faces]
    return [sizes.count(4), sizes.count(3), verdicts.count("non-convex"), verdicts.count("turned over"),
            sum(v not in result.place for v in source.place),
            sum(v in result.place and result.place[v] != at for v, at in source.place.items()),
            sum(v not in source.place for v in result.place), f"{seconds:.2f}"]


def run_gmsh(path, algorithm, settings):
    gmsh.clear()
    gmsh.option.restoreDefaults()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(path)
    before = mesh_of_gmsh()
    gmsh.option.setNumber("Mesh.RecombinationAlgorithm", algorithm)
    for option, value in settings.items():
        gmsh.option.setNumber(option, value)
    start = time.perf_counter()
    gmsh.model.mesh.recombine()
    seconds = time.perf_counter() - start
    return before, mesh_of_gmsh(), seconds


def run_ours(program, path, options, source, folder):
    out = f"{folder}/ours.obj"
    start = time.perf_counter()
    done = subprocess.run([program, "quadrangulate", path, "-o", out, "--quiet", *options], text=True,
                          stderr=subprocess.PIPE)
    seconds = time.perf_counter() - start
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    return mesh_of_obj(out, source), seconds


def write_random_triangles(path, n, seed):
    numbers = random.Random(seed)
    points = [(numbers.random(), numbers.random()) for _ in range(n)]
    triangles = gmsh.algorithm.triangulate([x for p in points for x in p])
    with open(path, "w") as f:
        f.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{n}\n")
        f.writelines(f"{i} {x!r} {y!r} 0\n" for i, (x, y) in enumerate(points, 1))
        f.write(f"$EndNodes\n$Elements\n{len(triangles) // 3}\n")
        for t in range(0, len(triangles), 3):
            a, b, c = (int(v) for v in triangles[t:t + 3])
            if turn(points[a - 1], points[b - 1], points[c - 1]) < 0:
                b, c = c, b
            f.write(f"{t // 3 + 1} 2 2 1 1 {a} {b} {c}\n")
        f.write("$EndElements\n")


def is_planar():
    coordinates = gmsh.model.mesh.getNodes()[1]
    return all(z == coordinates[2] for z in coordinates[2::3])


def compare(program, path, title, folder):
    gmsh.open(path)
    if not is_planar():
        sys.exit(f"{path}: not in a plane z = constant")
    source = mesh_of_gmsh()
    clockwise = sum(judge([source.place[v] for v in face]) == "turned over" for face in source.faces)
    turned = 2 * clockwise > len(source.faces)
    print(f"\n{title}: {len(source.place)} vertices, {len(source.faces)} faces")
    row = "{:<34}" + "{:>9}{:>10}{:>11}{:>12}{:>9}{:>8}{:>8}{:>9}"
    print(row.format("", "quads", "triangles", "non-convex", "turned over", "dropped", "moved", "added", "seconds"))
    for name, algorithm in ALGORITHMS.items():
        for setting, options in SETTINGS.items():
            before, after, seconds = run_gmsh(path, algorithm, options)
            if turned:
                after = after.turned()
            print(row.format(f"Gmsh {name}, {setting}", *count(before, after, seconds)), flush=True)
    for name, options in OURS.items():
        try:
            after, seconds = run_ours(program, path, options, source, folder)
            print(row.format(name, *count(source, after, seconds)), flush=True)
        except RuntimeError as error:
            print(f"{name:<34}{error}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("quadloom", help="our program")
    parser.add_argument("meshes", nargs="*", metavar="MESH.msh")
    parser.add_argument("--points", type=int, action="append", default=[], help="so many random points")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not options.meshes and not options.points:
        parser.error("meshes or --points are wanted")
    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    print(f"Gmsh {gmsh.__version__}")
    with tempfile.TemporaryDirectory() as folder:
        for n in options.points:
            path = f"{folder}/random.msh"
            write_random_triangles(path, n, options.seed)
            compare(options.quadloom, path, f"{n} random points, seed {options.seed}", folder)
        for path in options.meshes:
            compare(options.quadloom, path, pathlib.Path(path).name, folder)
    gmsh.finalize()


if __name__ == "__main__":
    main()
