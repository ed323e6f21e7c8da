"""Triangles in one strip along the convex spiral of the points, and the quads that pairs of them make."""
# Needs the package alone.
import quadloom

points = quadloom.generate_points("uniform", 50, seed=2)
serpentine = quadloom.serpentine_triangulation(points)
corners = serpentine.points[serpentine.triangles]
path = corners.mean(axis=1)                      # through the triangles in their order
spiral = serpentine.points[serpentine.spiral]
quads = quadloom.quadrangulate_points(points, method="spiral")

assert quadloom.certify_order(serpentine, "path")
quadloom.draw_sheet("strips.svg", [
    quadloom.Panel(serpentine, width=480, colour="none", overlay=[spiral], title="the spiral of the points"),
    quadloom.Panel(serpentine, width=480, colour="none", overlay=[path], title="the strip between its turns"),
    quadloom.Panel(quads, width=480, title="quads of the strip")], 3)
