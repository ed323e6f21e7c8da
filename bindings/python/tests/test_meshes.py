"""Triangulations to quadrilaterals, and what meshes may be given as."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import quadloom
import strategies
from quadloom import NONE, TriangleMethod


@pytest.fixture(scope="module")
def plate():
    """The triangles of an even hull: all methods can do with them."""
    points = quadloom.generate_points("uniform", 200, seed=2)
    return quadloom.delaunay(points)


@pytest.mark.parametrize("method", list(TriangleMethod))
def test_every_method_is_certified(lake, method):
    source = quadloom.constrained_delaunay(lake)
    result = quadloom.quadrangulate_triangles(source, method=method)
    verdict = quadloom.certify_mesh(result, source, outer_steiner=True)
    assert verdict, verdict.sentence
    assert len(result.triangles) == 0
    assert result.statistics.triangles == len(source.triangles)
    assert result.source_triangles.shape == (len(result.quads), 2)
    used = result.source_triangles[result.source_triangles != NONE]
    assert set(used) == set(range(len(source.triangles)))
    assert result.guarantee.startswith("all faces are quads")


@given(strategies.finite_points(), st.sampled_from(list(TriangleMethod)), st.sampled_from(list(quadloom.OddBoundary)))
def test_any_triangles_are_certified_or_refused(points, method, odd_boundary):
    try:
        source = quadloom.delaunay(points)
        result = quadloom.quadrangulate_triangles(source.points, source.triangles, method=method,
                                                  odd_boundary=odd_boundary)
    except quadloom.Error as error:
        assert error.code in {"too-few-points", "all-collinear", "guarantee"}
        return
    verdict = quadloom.certify_mesh(result, source, triangles_allowed=len(result.triangles), outer_steiner=True)
    assert verdict, verdict.sentence


@given(st.lists(st.lists(st.integers(0, 8), min_size=3, max_size=3), min_size=1, max_size=12))
def test_any_faces_are_a_mesh_or_refused(triangles):
    points = [(i % 3, i // 3) for i in range(9)]
    try:
        connected = quadloom.connect_triangles(points, triangles)
    except quadloom.Error as error:
        assert error.code in {"bad-mesh", "too-few-points"}
        return
    result = quadloom.quadrangulate_triangles(points, triangles, leftover="triangle", odd_boundary="triangle")
    assert result.statistics.triangles == len(connected.triangles)


def test_options(plate):
    exact = quadloom.quadrangulate_triangles(plate, effort="exact")
    assert exact.statistics.weight_gap == 0
    left = quadloom.quadrangulate_triangles(plate, leftover="triangle", pairs="convex", min_quality=0.4)
    assert len(left.triangles) == left.statistics.unmatched > 0
    assert len(left.triangle_source) == len(left.triangles)
    assert quadloom.measure_quality(left).min_shape >= 0.4
    with pytest.raises(quadloom.Error) as caught:
        quadloom.quadrangulate_triangles(plate, leftover="error", pairs="convex", min_quality=0.9)
    assert caught.value.code == "guarantee"


def test_weights_of_your_own(plate):
    """The diagonal of weight is the one to go."""
    square = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [2, 1]]
    triangles = quadloom.connect_triangles(square, [[0, 1, 2], [0, 2, 3], [1, 4, 2], [4, 5, 2]])
    twin = triangles.triangle_mesh.twin
    weight = np.where(twin == NONE, 0, 1.0)
    result = quadloom.quadrangulate_triangles(triangles, weight="given", halfedge_weight=weight)
    assert len(result.quads) == 2
    with pytest.raises(quadloom.Error):
        quadloom.quadrangulate_triangles(triangles, weight="given", halfedge_weight=weight[:-1])
    three = quadloom.connect_triangles([[0, 0], [1, 0], [1, 1], [0, 1], [2, 0.5]], [[0, 1, 2], [0, 2, 3], [1, 4, 2]])
    for weight, quad in (([[0, 1, 2], [2, 0, 0], [0, 0, 1]], {0, 1, 2, 3}),
                         ([[0, 2, 1], [1, 0, 0], [0, 0, 2]], {0, 1, 2, 4})):
        result = quadloom.quadrangulate_triangles(three, weight="given", halfedge_weight=weight, leftover="triangle",
                                                  odd_boundary="triangle")
        assert [set(q) for q in result.quads.tolist()] == [quad]


def test_meshes_may_be_given_as(plate):
    expected = quadloom.quadrangulate_triangles(plate).quads
    points, triangles = plate.points, plate.triangles
    for mesh in ((points, triangles), (points.tolist(), triangles.tolist()), quadloom.PolygonMesh(points, triangles),
                 quadloom.Triangulation(points, triangles), quadloom.TriangleMesh(points, triangles),
                 quadloom.MeshFile(points, triangles), quadloom.connect_triangles(points, triangles)):
        assert np.array_equal(quadloom.quadrangulate_triangles(mesh).quads, expected)
    assert np.array_equal(quadloom.quadrangulate_triangles(points, triangles).quads, expected)


def test_source_triangles_are_those_that_were_given():
    """Clockwise ones are turned, one without area is taken out: numbers stay those of the input."""
    points = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 0]]
    triangles = [[0, 4, 1], [0, 2, 1], [0, 2, 3]]
    result = quadloom.quadrangulate_triangles(points, triangles, leftover="triangle", odd_boundary="triangle")
    assert set(result.source_triangles[result.source_triangles != NONE]) <= {0, 1, 2}
    connected = quadloom.connect_triangles(points, triangles)
    assert (connected.turned_faces, connected.flat_faces) == (1, 1)
    with pytest.raises(quadloom.Error, match="."):
        quadloom.connect_triangles(points, triangles, faulty="refuse")


def test_regions_and_edges_to_keep(plate):
    mesh = quadloom.TriangleMesh(plate)
    assert len(mesh.region) == 0 and len(mesh.keep) == 0
    mesh.region = (plate.points[plate.triangles].mean(axis=1)[:, 0] > 0.5).astype(int)
    result = quadloom.quadrangulate_triangles(mesh)
    pairs = result.source_triangles[(result.source_triangles != NONE).all(axis=1)]
    assert (mesh.region[pairs[:, 0]] == mesh.region[pairs[:, 1]]).all()
    mesh.keep = np.ones_like(mesh.twin, bool)
    kept = quadloom.quadrangulate_triangles(mesh, leftover="triangle", odd_boundary="triangle")
    assert len(kept.quads) == 0
    with pytest.raises(quadloom.Error, match="region has 3 values"):
        mesh.region = [1, 2, 3]


def test_a_surface():
    """A tetrahedron: closed, in space."""
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    connected = quadloom.connect_triangles(points, triangles)
    assert connected.space == "surface" and connected.boundary_edges == 0
    result = quadloom.quadrangulate_triangles(points, triangles)
    assert result.points.shape[1] == 3 and len(result.triangles) == 0
    assert quadloom.certify_surface(result, (points, triangles))
    mesh = connected.triangle_mesh
    assert quadloom.keep_sharp_edges(mesh, 30) == 6
    assert quadloom.space_of(points, triangles) == "surface"
    assert quadloom.measure_quality(result).quads == len(result.quads)
    for given_as in ((points, triangles), quadloom.PolygonMesh(points, triangles), connected,
                     quadloom.MeshFile(points, triangles), quadloom.Triangulation(points, triangles)):
        quality = quadloom.measure_quality(given_as)
        assert (quality.min_angle, quality.max_angle) == pytest.approx((45, 90))


def test_heights_over_the_plane_are_not_measured(plate, source):
    points = np.column_stack([plate.points, 100 * plate.points[:, 0]])
    flat = quadloom.measure_quality(plate).min_angle
    for given_as in ((points, plate.triangles), quadloom.MeshFile(points, plate.triangles),
                     quadloom.TriangleMesh(points, plate.triangles), quadloom.delaunay(points)):
        assert quadloom.measure_quality(given_as).min_angle == flat
    harbour = quadloom.read_mesh(source / "examples/harbour/harbour.14")
    plane = (harbour.points[:, :2], harbour.triangles)
    assert harbour.z_is_data
    assert quadloom.measure_quality(harbour).min_angle == quadloom.measure_quality(plane).min_angle


def test_depths_are_carried_along(plate):
    depth = plate.points[:, 0] + 2 * plate.points[:, 1]
    points = np.column_stack([plate.points, depth])
    result = quadloom.quadrangulate_triangles(points, plate.triangles, method="subdivide")
    x, y, z = result.points[: len(points)].T
    assert np.array_equal(z, x + 2 * y)
    x, y, z = result.points[[s.vertex for s in result.steiner if s.kind == "inner"]].T
    assert len(x) > 0 and np.allclose(z, x + 2 * y)
    kept = quadloom.TriangleMesh(points, plate.triangles)
    assert np.array_equal(kept.points, points)
    assert np.array_equal(quadloom.quadrangulate_triangles(kept, method="subdivide").points, result.points)


def test_quads_and_triangles_mixed():
    points = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0.5]]
    mesh = quadloom.PolygonMesh(points, [[0, 1, 2, 3]], [[1, 4, 2]])
    assert (mesh.quads.tolist(), mesh.triangles.tolist()) == ([[0, 1, 2, 3]], [[1, 4, 2]])
    assert mesh.face_begin.tolist() == [0, 4, 7]
    assert np.array_equal(quadloom.PolygonMesh(points, [[0, 1, 2, 3], [1, 4, 2]]).face_vertex, mesh.face_vertex)
    assert quadloom.certify_points(mesh, points, triangles_allowed=1)
    result = quadloom.quadrangulate_triangles(mesh, method="subdivide")
    assert len(result.quads) == 4 + 3


def test_strictly_convex_meshes(lake, plate):
    for source in (plate, quadloom.constrained_delaunay(lake)):
        result = quadloom.convex_quadrangulation(source)
        assert len(result.not_convex) == 0
        assert quadloom.certify_mesh(result, source, strictly_convex=True)
    again = quadloom.convex_quadrangulation((plate.points, plate.triangles))
    assert len(again.quads) > 0
    with pytest.raises(quadloom.Error):
        quadloom.convex_quadrangulation(plate, leftover="triangle")


def test_duals_and_matchings(plate):
    graph = quadloom.dual_graph(plate)
    assert graph.node_count == len(plate.triangles)
    assert np.array_equal(quadloom.DualGraph(graph.twin).twin, graph.twin)
    best = quadloom.maximum_matching(graph)
    assert quadloom.verify_tutte_berge(graph, best) and quadloom.is_matching(graph, best.matching)
    greedy = quadloom.greedy_shape_matching(plate)
    assert quadloom.is_matching(graph, greedy)
    assert quadloom.maximum_matching(graph, greedy).matching.unmatched == best.matching.unmatched
    assert not quadloom.verify_tutte_berge(graph, quadloom.MaximumMatching(greedy, [0]))
    weight = quadloom.shape_weights(plate)
    proven = quadloom.maximum_weight_matching(graph, weight, "weight")
    assert quadloom.verify_weight(graph, weight, "weight", proven)
    assert quadloom.weight_of(proven.matching, weight) == proven.weight >= quadloom.weight_of(greedy, weight)
    near = quadloom.near_maximum_weight_matching(graph, weight, quadloom.MatchingGoal.WEIGHT)
    assert near.weight <= proven.weight <= near.upper_bound
    forest = quadloom.spanning_forest(graph)
    up, down = quadloom.percolate_up(forest), quadloom.percolate_up_and_down(forest)
    assert up.unmatched == down.unmatched == quadloom.maximum_matching(forest).matching.unmatched
    heavy = quadloom.heavy_edges(graph, weight, 1)
    assert ((heavy.twin == NONE) == ((graph.twin == NONE) | (weight.reshape(-1, 3) < 1))).all()
    forbidden = np.ones_like(graph.twin, bool)
    assert (quadloom.dual_graph(plate, forbidden).twin == NONE).all()


def test_graphs_that_are_none():
    for twin in ([[0, NONE, NONE]], [[1, NONE, NONE]], [[9, NONE, NONE]], [[3, NONE, NONE], [1, NONE, NONE]]):
        with pytest.raises(quadloom.Error, match="."):
            quadloom.DualGraph(twin)
    graph = quadloom.DualGraph([[3, NONE, NONE], [0, NONE, NONE]])
    assert not quadloom.is_matching(graph, quadloom.DualMatching([7, 7]))
    with pytest.raises(quadloom.Error):
        quadloom.maximum_matching(graph, quadloom.DualMatching([7, 7]))
    with pytest.raises(quadloom.Error):
        quadloom.weight_of(quadloom.DualMatching([7, 7]), [1, 2])
    with pytest.raises(quadloom.Error):
        quadloom.percolate_up(quadloom.DualGraph([[3, 4, NONE], [0, 1, NONE]]))
