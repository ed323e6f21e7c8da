"""The towns of Germany as quads: every town a corner, no point added."""
# Needs the package alone.
import pathlib

import quadloom

here = pathlib.Path(__file__).parent
towns = quadloom.read_points(here / "../towns/towns.csv")
mesh = quadloom.quadrangulate_points(towns)
print(mesh, mesh.guarantee, sep="\n")
quadloom.draw_mesh("towns.png", mesh, width=560, colour="convexity")
