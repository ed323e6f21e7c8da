#!/usr/bin/env python3
"""What calling from Python costs over C++: a million points to quads, in turn by the package (an array in, arrays of quads
out) and by the program that comes with it (the library's call alone, as its report has it), medians of both.

    python bench/python_overhead.py [POINTS] [ROUNDS]     with the Python that the package is installed in
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import quadloom


def seconds_in_cpp(folder, points):
    report = folder / "report.json"
    subprocess.run([sys.executable, "-m", "quadloom", "quadrangulate", points, "-o", folder / "mesh.obj", "--report", report],
                   check=True, capture_output=True)
    return json.loads(report.read_text())["mesh"]["seconds"]["mesh"]


def seconds_in_python(points):
    begin = time.perf_counter()
    mesh = quadloom.quadrangulate_points(points)
    quads, vertices = mesh.quads, mesh.points
    seconds = time.perf_counter() - begin
    assert len(quads) > 0 and len(vertices) >= len(points)
    return seconds


def main():
    count, rounds = (int(a) for a in (sys.argv[1:] + ["1000000", "9"][len(sys.argv) - 1:]))
    points = quadloom.generate_points("uniform", count)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        file = folder / "points.xyz"
        quadloom.write_points(file, points)
        in_cpp, in_python = [], []
        for _ in range(rounds):
            in_cpp.append(seconds_in_cpp(folder, file))
            in_python.append(seconds_in_python(points))
    cpp, python = statistics.median(in_cpp), statistics.median(in_python)
    print(f"{count:,} points, medians of {rounds}: C++ {cpp:.3f} s, Python {python:.3f} s, {python / cpp - 1:+.1%}")


if __name__ == "__main__":
    main()
