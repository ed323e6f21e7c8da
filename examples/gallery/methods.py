"""The same points by every method, side by side."""
# Needs the package alone.
import quadloom

points = quadloom.generate_points("uniform", 50, seed=5)
meshes = {f"points, {m.value}": quadloom.quadrangulate_points(points, method=m) for m in quadloom.PointMethod}
meshes |= {f"convex, {m.value}": quadloom.convex_quadrangulation(points, method=m) for m in quadloom.ConvexMethod}

panels = [quadloom.Panel(quadloom.delaunay(points), width=420, colour="none", title="Delaunay triangles")]
for name, mesh in meshes.items():
    assert quadloom.certify_points(mesh, points, outer_steiner=True)
    added = f", {mesh.is_steiner.sum()} added" if mesh.is_steiner.any() else ""
    panels.append(quadloom.Panel(mesh, width=420, title=f"{name}: {len(mesh.quads)} quads{added}"))
quadloom.draw_sheet("methods.svg", panels, 4)
