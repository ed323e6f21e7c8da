"""Strictly convex quads, which solvers want: a few points are added, each marked with a ring."""
# Needs the package alone.
import quadloom

points = quadloom.generate_points("uniform", 50, seed=6)
panels = []
for method in ("delaunay", "spiral"):
    mesh = quadloom.convex_quadrangulation(points, method=method)
    assert quadloom.certify_points(mesh, points, outer_steiner=True, strictly_convex=True)
    print(method, mesh, mesh.guarantee, sep="\n")
    panels.append(quadloom.Panel(mesh, width=480, title=f"{method}, points added: {mesh.is_steiner.sum()}"))
quadloom.draw_sheet("convex.svg", panels, 2)
