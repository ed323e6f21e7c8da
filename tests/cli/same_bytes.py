#!/usr/bin/env python3
"""Two builds of the command line, of different compilers, say, write the same bytes. Prints what differs.

    same_bytes.py QUADLOOM OTHER_QUADLOOM
"""
import pathlib
import subprocess
import sys
import tempfile

KINDS = ["uniform", "grid", "circle", "lines", "decades"]
SIZE = "1500"
LARGE = "70000"  # of points, for Delaunay triangles in ranges
RUNS = [
    ["quadrangulate", "{points}", "-o", "quads.obj"],
    ["quadrangulate", "{points}", "--method", "spiral", "-o", "spiral.vtu"],
    ["quadrangulate", "{points}", "--convex", "-o", "convex.obj"],
    ["triangulate", "{points}", "-o", "triangles.off"],
    ["quadrangulate", "triangles.off", "-o", "of-triangles.ply"],
    ["strip", "triangles.off", "-o", "triangles.strip"],
    ["polygonize", "{points}", "-o", "polygon.geojson"],
]


def outputs(program, folder):
    """{what was run: what it wrote}"""
    def run(*arguments):
        done = subprocess.run([program, *arguments], cwd=folder, capture_output=True)
        return done.returncode, done.stderr

    found = {}
    for kind in KINDS:
        points = f"{kind}.xyz"
        found[f"generate {kind}"] = run("generate", kind, "-n", SIZE, "-o", points), (folder / points).read_bytes()
        for command in RUNS:
            done = run(*(part.format(points=points) for part in command))
            found[f"{kind}: {' '.join(command)}"] = done, (folder / command[-1]).read_bytes()
    run("generate", "uniform", "-n", LARGE, "-o", "large.xyz")
    found["large"] = run("triangulate", "large.xyz", "-o", "large.off"), (folder / "large.off").read_bytes()
    return found


def main():
    both = []
    for program in map(pathlib.Path, sys.argv[1:3]):
        with tempfile.TemporaryDirectory() as folder:
            both.append(outputs(program.resolve(), pathlib.Path(folder)))
    differing = [run for run in both[0] if both[0][run] != both[1][run]]
    if differing:
        sys.exit("not the same:\n" + "\n".join(differing))
    print(f"{len(both[0])} runs, the same bytes")


if __name__ == "__main__":
    main()
