#!/usr/bin/env python3
"""Makes bay.geojson, lake.geojson and part.stl again, byte for byte."""
import json
import math
import pathlib

HERE = pathlib.Path(__file__).parent

BAY = [(0, 0), (3, 1), (4, -1), (6, 2), (9, 0), (8, 3), (11, 4), (8, 5), (10, 8), (7, 6), (6, 9), (5, 6), (2, 8), (3, 5),
       (0, 6), (2, 3)]


def ring(centre, radius, corners, wave=0.0, waves=3, turn=1):
    """A closed ring of whole coordinates around a centre, its radius going up and down."""
    places = []
    for i in range(corners):
        angle = 2 * math.pi * i / corners
        r = radius * (1 + wave * math.sin(waves * angle + 0.4))
        places.append((round(centre[0] + 1.5 * r * math.cos(angle)), round(centre[1] + turn * r * math.sin(angle))))
    return places + places[:1]


def write_polygon(name, rings):
    geometry = {"type": "Polygon", "coordinates": [[list(place) for place in places] for places in rings]}
    (HERE / name).write_text(json.dumps(geometry) + "\n")


def prism(outline, triangles, height):
    """The facets of a plate: the outline's sides, its bottom and its top."""
    low = [(x, y, 0) for x, y in outline]
    high = [(x, y, height) for x, y in outline]
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        yield low[i], low[j], high[j]
        yield low[i], high[j], high[i]
    for a, b, c in triangles:
        yield low[a], low[c], low[b]
        yield high[a], high[b], high[c]


def write_stl(name, facets):
    lines = ["solid part"]
    for facet in facets:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex {} {} {}".format(*place) for place in facet), "endloop",
                  "endfacet"]
    (HERE / name).write_text("\n".join([*lines, "endsolid part", ""]))


def main():
    write_polygon("bay.geojson", [BAY + BAY[:1]])
    write_polygon("lake.geojson", [ring((0, 0), 400, 48, wave=0.18), ring((-220, 60), 70, 12, turn=-1),
                                   ring((200, -90), 100, 16, wave=0.2, turn=-1)])
    # An angle iron, seen from above:  0-1-2 below, 2-3-4 inside the angle, 5 at the far end.
    angle = [(0, 0), (40, 0), (40, 10), (10, 10), (10, 40), (0, 40)]
    write_stl("part.stl", prism(angle, [(0, 1, 3), (1, 2, 3), (0, 3, 5), (3, 4, 5)], 12))


if __name__ == "__main__":
    main()
