"""A mesh of triangles for a coastal model becomes quads alone: its nodes, its shore and its depths stay."""
# Needs the package alone.
import pathlib

import quadloom

here = pathlib.Path(__file__).parent
triangles = quadloom.read_mesh(here / "../harbour/harbour.14")
quads = quadloom.convex_quadrangulation(triangles)
assert quadloom.certify_mesh(quads, triangles, steiner_inside=True, strictly_convex=True)
print(quads, quads.guarantee, sep="\n")
quads.save("coast.vtu")          # for ParaView, depths and all

quadloom.draw_sheet("coast.svg", [
    quadloom.Panel(triangles, width=640, colour="none", title=f"{triangles.face_count} triangles"),
    quadloom.Panel(quads, width=640, title=f"{quads.face_count} strictly convex quads, no node added or moved")], 1)
