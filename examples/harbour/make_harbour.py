#!/usr/bin/env python3
"""Makes harbour.14, a made-up harbour: python3 make_harbour.py path/to/quadloom

The outline and the sizes are invented here; the triangles are `quadloom triangulate`'s. The same bytes
on every platform: coordinates are whole metres, random numbers are Python's Mersenne twister.
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

# The coast from west to east with a basin behind two moles, then the open sea on an arc back.
COAST = [(0, 2000), (350, 2060), (700, 1980), (1050, 2080), (1400, 2150), (1640, 2120), (1700, 1760),
         (1900, 1600), (1930, 1640), (1760, 1790), (1720, 2200), (1650, 2420), (1800, 2560), (2050, 2600),
         (2280, 2520), (2330, 2300), (2270, 2150), (2240, 1800), (2110, 1640), (2140, 1600), (2300, 1770),
         (2340, 2080), (2600, 2130), (2950, 2020), (3300, 2090), (3650, 1990), (4000, 2050)]
ISLAND = [(1180, 1380), (1260, 1450), (1390, 1440), (1440, 1400), (1450, 1350), (1400, 1270), (1270, 1250), (1190, 1300)]
ENTRANCE = (2020, 1620)


def size(x, y):
    """How long edges should be: short at the entrance and around the island, long far out."""
    near = min(math.hypot(x - ENTRANCE[0], y - ENTRANCE[1]), 0.6 * math.hypot(x - 1320, y - 1350) + 150)
    return 55 + 0.13 * near


def along(points, closed):
    """The corners and points between them, as far apart as size() says."""
    out = []
    for a, b in zip(points, points[1:] + points[:1] if closed else points[1:]):
        pieces = max(1, round(math.dist(a, b) / size((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)))
        out += [(round(a[0] + (b[0] - a[0]) * i / pieces), round(a[1] + (b[1] - a[1]) * i / pieces))
                for i in range(pieces)]
    return out if closed else out + [points[-1]]


def inside(p, ring):
    hit = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > p[1]) != (by > p[1]) and p[0] < ax + (bx - ax) * (p[1] - ay) / (by - ay):
            hit = not hit
    return hit


def fill(rings):
    """Points thrown at random, kept where they are far enough from the others."""
    rng = random.Random(3)
    kept = [p for ring in rings for p in ring]
    border = len(kept)
    for _ in range(20000):
        p = (rng.randrange(4001), rng.randrange(2601))
        if not inside(p, rings[0]) or any(inside(p, ring) for ring in rings[1:]):
            continue
        if all(math.dist(p, q) > 0.8 * size(*p) for q in kept):
            kept.append(p)
    return kept[border:]


def depth(x, y):
    """In metres below the sea's level: a dredged channel, a shelf that falls off to the south."""
    channel = 7 * math.exp(-((x - 2020) / 160) ** 2) if y > 900 else 0
    island = 9 * math.exp(-math.hypot(x - 1320, y - 1350) / 160)
    return round(max(0.5, 4 + (2100 - y) / 90 + channel - island), 2)


def triangulate(quadloom, rings, points):
    closed = [[*ring, ring[0]] for ring in rings]
    collection = {"type": "GeometryCollection", "geometries": [
        {"type": "Polygon", "coordinates": closed}, {"type": "MultiPoint", "coordinates": points}]}
    with tempfile.TemporaryDirectory() as folder:
        source, mesh = pathlib.Path(folder, "harbour.geojson"), pathlib.Path(folder, "harbour.obj")
        source.write_text(json.dumps(collection))
        subprocess.run([quadloom, "triangulate", source, "-o", mesh], check=True, stdout=sys.stderr)
        words = [line.split() for line in mesh.read_text().splitlines()]
    return ([(int(w[1]), int(w[2])) for w in words if w[0] == "v"],
            [[int(i) for i in w[1:]] for w in words if w[0] == "f"])


def main():
    arc = [(2000 + 2000 * math.cos(t), 2050 - 2000 * math.sin(t) * 0.98)
           for t in (math.pi * i / 40 for i in range(1, 40))]
    sea = along([COAST[-1], *[(round(x), round(y)) for x, y in arc[::3]], COAST[0]], False)
    land = along(COAST, False)
    island = along(ISLAND, True)
    rings = [land + sea[1:-1], island]
    vertices, triangles = triangulate(sys.argv[1], rings, fill(rings))
    number = {v: i + 1 for i, v in enumerate(vertices)}
    lines = ["a made-up harbour", f"{len(triangles)} {len(vertices)}"]
    lines += [f"{i} {x} {y} {depth(x, y)}" for i, (x, y) in enumerate(vertices, 1)]
    lines += [f"{i} 3 {a} {b} {c}" for i, (a, b, c) in enumerate(triangles, 1)]
    lines += ["1 = open boundaries", f"{len(sea)} = open boundary nodes", f"{len(sea)} = boundary 1"]
    lines += [str(number[v]) for v in sea]
    lines += ["2 = land boundaries", f"{len(land) + len(island)} = land boundary nodes"]
    for kind, line in [(0, land), (1, island)]:
        lines += [f"{len(line)} {kind} = boundary"] + [str(number[v]) for v in line]
    pathlib.Path(__file__).with_name("harbour.14").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
