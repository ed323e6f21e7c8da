"""Triangles in order, strips, and what the kernel has for points."""
import numpy as np
import pytest

import quadloom


@pytest.fixture(scope="module")
def points():
    return quadloom.generate_points("uniform", 150, seed=5)


def test_orders_of_point_sets(points):
    for splitter in quadloom.Splitter:
        cycle = quadloom.hamiltonian_cycle_triangulation(points, splitter=splitter)
        assert cycle.cycle == "yes" and quadloom.certify_order(cycle, "cycle")
    few = quadloom.sequential_triangulation(points[:8])
    assert few.answer == "yes" and quadloom.certify_order(few, "sequential")
    assert np.array_equal(np.sort(few.sequence[:3]), np.sort(few.triangles[0]))
    many = quadloom.sequential_triangulation(points)
    assert many.answer == "unknown" and many.face_count == 0
    spiral = quadloom.spiral_polygon(points)
    assert quadloom.certify_spiral_polygon(spiral.points[spiral.ring], points)
    assert quadloom.certify_order(spiral, "path")


def test_orders_of_meshes(points):
    mesh = quadloom.delaunay(points)
    found = quadloom.hamiltonian_order(mesh)
    assert found.answer == "yes"
    ordered = quadloom.reorder_triangles(mesh, found.order)
    assert quadloom.certify_order(ordered, "path")
    assert not quadloom.certify_order(quadloom.reorder_triangles(mesh, found.order[::2].tolist() +
                                                                 found.order[1::2].tolist()), "path")
    fan = quadloom.Triangulation([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 1, 2], [0, 2, 3]])
    order = quadloom.sequential_order(fan)
    assert sorted(order.order) == [0, 1] and len(order.sequence) == 4
    assert quadloom.sequential_order(mesh) is None
    alone = quadloom.hamiltonian_order(fan, kind="cycle")
    assert (alone.answer, alone.reason) == ("no", "too-few")


def test_refinement(points):
    mesh = quadloom.delaunay(points)
    refined = quadloom.hamiltonian_refinement(mesh)
    assert len(refined.triangles) == 3 * len(mesh.triangles)
    assert quadloom.certify_order(refined, "cycle") and quadloom.certify_mesh(refined, mesh, corners=3)
    assert refined.min_angle_after >= refined.min_angle_before / 2 - 1e-9
    sources = refined.source_triangles[refined.source_triangles != quadloom.NONE]
    assert set(sources) == set(range(len(mesh.triangles)))


@pytest.mark.parametrize("encoding", list(quadloom.StripEncoding))
@pytest.mark.parametrize("effort", list(quadloom.PathEffort))
def test_strips(points, encoding, effort):
    mesh = quadloom.delaunay(points)
    made = quadloom.encode_strips(mesh, encoding=encoding, effort=effort)
    assert quadloom.same_triangles(quadloom.decode_strips(made.code), mesh.triangles)
    again = quadloom.StripCode(encoding, made.code.index, made.code.swap if encoding == "swap" else None)
    assert np.array_equal(quadloom.decode_strips(again), quadloom.decode_strips(made.code))
    assert not quadloom.same_triangles(mesh.triangles, mesh.triangles[1:])


def test_paths(points):
    mesh = quadloom.delaunay(points)
    graph = quadloom.dual_graph(mesh)
    paths = quadloom.path_partition(graph, goal="fewest-indices", effort="fast")
    assert quadloom.is_path_partition(graph, paths)
    code = quadloom.encode_paths(mesh, paths, "repeat").code
    assert quadloom.same_triangles(quadloom.decode_strips(code), mesh.triangles)
    forest = quadloom.spanning_forest(graph)
    fewest = quadloom.minimum_path_partition(forest)
    assert quadloom.is_path_partition(forest, fewest)
    assert len(fewest) <= len(quadloom.path_partition(forest))
    broken = quadloom.PathPartition(paths.leave[::-1], paths.begin)
    assert not quadloom.is_path_partition(graph, broken)
    with pytest.raises(quadloom.Error):
        quadloom.encode_paths(mesh, broken, "repeat")


def test_predicates(points):
    a, b, c, d = [0, 0], [1, 0], [0, 1], [0.25, 0.25]
    assert (quadloom.orient2d(a, b, c), quadloom.orient2d(a, c, b), quadloom.orient2d(a, b, [2, 0])) == (1, -1, 0)
    assert quadloom.orient2d([0.1, 0.3], [0.2, 0.6], [0.3, 0.9]) != 0  # 0.3 is not three times 0.1
    assert quadloom.incircle(a, b, c, d) == 1 and quadloom.incircle(a, b, c, [1, 1]) == 0
    assert quadloom.cross_sign(a, b, a, c) == 1 and quadloom.dot_sign(a, b, a, c) == 0
    assert quadloom.quad_shape(a, b, [1, 1], c) == pytest.approx(1)
    signs = quadloom.orient2d(points[:50], points[50:100], [5, 5])
    assert signs.dtype == np.int8
    assert signs.tolist() == [quadloom.orient2d(p, q, [5, 5]) for p, q in zip(points[:50], points[50:100])]


def test_hull_layers_and_orders(points):
    hull = quadloom.convex_hull(points)
    layers = quadloom.convex_layers(points)
    assert np.array_equal(layers.layer(0), hull)
    assert sum(len(layers.layer(i)) for i in range(len(layers))) == len(points)
    with pytest.raises(IndexError):
        layers.layer(len(layers))
    assert sorted(quadloom.convex_spiral(points)) == sorted(quadloom.spatial_order(points)) == list(range(len(points)))
    assert quadloom.convex_spiral(points, int(hull[2]))[0] == hull[2]
    with pytest.raises(quadloom.Error):
        quadloom.convex_spiral(points, 10**6)
    distinct = quadloom.distinct_points([[1, 2], [3, 4], [1, 2]])
    assert distinct.points.tolist() == [[1, 2], [3, 4]] and distinct.input_to_vertex.tolist() == [0, 1, 0]


def test_small_convex_pieces():
    hexagon = [[0, 0], [4, 0], [2, 1], [4, 4], [0, 4], [1, 2]]
    patch = quadloom.convexify_hexagon(hexagon)
    assert quadloom.certify_polygons((np.vstack([hexagon, patch.steiner]), patch.quads), hexagon, strictly_convex=True)
    dart = [[0, 0], [4, 0], [1, 1], [0, 4]]
    assert len(quadloom.convexify_quad(dart).steiner) == 4
    with_point = quadloom.convexify_quad_with_point([[0, 0], [4, 0], [4, 4], [0, 4]], [1, 2])
    assert len(with_point.steiner) == 3
    with pytest.raises(quadloom.Error, match="6 corners"):
        quadloom.convexify_hexagon(dart)


def test_exact_answers_for_few_points():
    points = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 2], [3, 2]]
    exact = quadloom.exact_convex_quadrangulation(points)
    verdict = quadloom.certify_points(exact, points)
    assert exact.convex == "no" and verdict.strictly_convex == exact.most_convex < exact.quad_count == len(exact.quads)
    square = quadloom.exact_convex_quadrangulation(points[:4])
    assert square.convex == "yes" and square.most_convex == 1
    line = quadloom.generate_points("bhrs-line", 11)
    assert quadloom.certify_points(quadloom.mesh_of_bhrs_line(line), line, strictly_convex=True)
    ring = quadloom.generate_points("bhrs-ring", 12)
    assert quadloom.certify_points(quadloom.mesh_of_bhrs_ring(ring), ring, strictly_convex=True)
    many = quadloom.generate_points("uniform", 14)
    assert quadloom.exact_convex_quadrangulation(many, work_at_most=1).convex == "unknown"


def test_texts_of_results(points):
    result = quadloom.quadrangulate_points(points)
    assert repr(result).startswith("<PointResult: 15")
    statistics = result.statistics
    assert f"hull_points={statistics.hull_points}" in repr(statistics)
    assert statistics.as_dict()["walks"] == statistics.walks
    assert "twin=array(" in repr(quadloom.dual_graph(quadloom.delaunay(points)))
