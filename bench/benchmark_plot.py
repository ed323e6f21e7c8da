"""FOLDER/benchmarks/seconds.svg from the figures of bench/compare: time a million points against their number. Its
description is what is drawn, which tests compare with the figures.

    benchmark_plot.py FOLDER
"""
import json
import pathlib
import sys

import benchmark_page
from catalogue import TABLES

CURVES = {  # title of a panel: (table, key of a row, label, colour, marker); ours are solid
    "Delaunay triangulation": [
        ("delaunay", "quadloom delaunay", "Quadloom", "#00796b", "o"),
        ("delaunay", "quadloom delaunay@2", "Quadloom, 2 threads", "#440154", "D"),
        ("delaunay", "CGAL delaunay", "CGAL", "#c2185b", "s"),
        ("delaunay", "delaunator delaunay", "delaunator (node)", "#f9a825", "^"),
    ],
    "Quads": [
        ("quads", "quadloom quads", "Quadloom, default", "#00796b", "o"),
        ("quads", "quadloom convex", "Quadloom, strictly convex", "#440154", "D"),
        ("recombination", "quadloom pair", "Quadloom, pair", "#26a69a", "v"),
        ("recombination", "Gmsh blossom", "Gmsh, blossom", "#c2185b", "s"),
        ("recombination", "Gmsh simple", "Gmsh, simple", "#f9a825", "^"),
    ],
}


def points_of(folder, name, key):
    """Numbers of uniform points, and seconds a million of them."""
    table = next(table for table in TABLES if table.name == name)
    groups = [group for group in benchmark_page.read_groups(folder, table) if group["kind"] == "uniform"]
    found = [(group["points"], benchmark_page.seconds(group["figures"].get(key))) for group in groups]
    return [(n, 1e6 * seconds / n) for n, seconds in found if seconds]


def description(folder):
    return json.dumps({label: points_of(folder, name, key) for curves in CURVES.values() for name, key, label, *_ in curves})


def draw(folder):
    import matplotlib
    import matplotlib.pyplot as plt
    matplotlib.rcParams.update({"svg.hashsalt": "quadloom", "svg.fonttype": "none", "font.family": "sans-serif"})
    figure, panels = plt.subplots(1, 2, figsize=(10, 4.6), layout="constrained", sharey=True)
    for panel, (title, curves) in zip(panels, CURVES.items()):
        for name, key, label, colour, marker in curves:
            at = points_of(folder, name, key)
            if at:
                panel.plot(*zip(*at), label=label, color=colour, marker=marker, markersize=6,
                           linestyle="-" if key.startswith("quadloom") else "--")
        panel.set(title=f"{title}, uniform points", xscale="log", yscale="log", xlabel="points")
        panel.grid(which="major", alpha=0.4)
        panel.grid(which="minor", alpha=0.12)
        panel.legend(frameon=False)
    panels[0].set_ylabel("seconds a million points")
    panels[0].yaxis.set_major_formatter("{x:g}")
    figure.savefig(folder / "benchmarks/seconds.svg", metadata={"Date": None, "Description": description(folder)})


if __name__ == "__main__":
    draw(pathlib.Path(sys.argv[1]))
