"""Point sets to quadrilaterals."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import quadloom
import strategies
from quadloom import OddBoundary, PointMethod

METHODS = list(PointMethod)
REFUSED = {"not-finite", "too-few-points", "all-collinear", "guarantee"}


def certify(result, points, **options):
    verdict = quadloom.certify_points(result, points, **options)
    assert verdict, verdict.sentence
    return verdict


@given(strategies.one_of_a_kind(), st.sampled_from(METHODS), st.sampled_from(list(OddBoundary)))
def test_any_array_is_a_certified_mesh_or_refused(points, method, odd_boundary):
    try:
        result = quadloom.quadrangulate_points(points, method=method, odd_boundary=odd_boundary)
    except quadloom.Error as error:
        assert error.code in REFUSED
        return
    left = len(result.triangles)
    assert left <= (1 if odd_boundary == "triangle" else 0)
    verdict = certify(result, points, triangles_allowed=left)
    assert verdict.steiner == len(result.steiner) == result.is_steiner.sum()
    if method != "subdivide":
        assert len(result.steiner) + left == result.statistics.hull_points % 2


@given(strategies.one_of_a_kind(), st.sampled_from(list(quadloom.ConvexMethod)))
def test_any_array_is_strictly_convex_or_refused(points, method):
    try:
        result = quadloom.convex_quadrangulation(points, method=method)
    except quadloom.Error as error:
        assert error.code in REFUSED
        return
    certify(result, points, triangles_allowed=len(result.triangles),
            strictly_convex=len(result.not_convex) == 0)


@given(strategies.one_of_a_kind())
def test_delaunay_of_any_array(points):
    try:
        result = quadloom.delaunay(points)
    except quadloom.Error as error:
        assert error.code in REFUSED
        return
    certify(result, points, corners=3, steiner_at_most=0)
    assert np.array_equal(result.points[result.input_to_vertex], points)


@pytest.mark.parametrize("method", METHODS)
def test_words_and_members_are_the_same(towns, method):
    by_member = quadloom.quadrangulate_points(towns, method=method)
    by_word = quadloom.quadrangulate_points(towns, method=method.value)
    assert np.array_equal(by_member.quads, by_word.quads)


def test_the_seed_counts():
    points = quadloom.generate_points("uniform", 200)
    first, again, other = (quadloom.quadrangulate_points(points, method="insertion", seed=s) for s in (1, 1, 2))
    assert np.array_equal(first.quads, again.quads)
    assert not np.array_equal(first.quads, other.quads)


def test_an_odd_hull():
    points = [[0, 0], [4, 0], [0, 4], [1, 1], [2, 1]]
    outside = quadloom.quadrangulate_points(points)
    assert [s.kind for s in outside.steiner] == ["outside"]
    assert outside.is_steiner.tolist() == [False] * 5 + [True]
    assert "1 point added" in outside.guarantee and "odd" in outside.guarantee
    on_edge = quadloom.quadrangulate_points(points, odd_boundary="on-edge")
    assert [s.kind for s in on_edge.steiner] == [quadloom.SteinerKind.ON_EDGE]
    left = quadloom.quadrangulate_points(points, odd_boundary=OddBoundary.TRIANGLE)
    assert len(left.steiner) == 0 and len(left.triangles) == 1
    assert "one triangle left" in left.guarantee
    assert not quadloom.has_quadrangulation(points)


def test_repeated_points_are_one_vertex():
    points = [[0, 0], [1, 0], [0, 0], [1, 1], [0, 1]]
    result = quadloom.quadrangulate_points(points)
    assert result.input_to_vertex.tolist() == [0, 1, 0, 2, 3]
    assert result.input_vertices == 4


def test_faces_of_k_corners():
    points = quadloom.generate_points("uniform", 100)
    result = quadloom.k_angulate_points(points, 6)
    assert set(np.diff(result.face_begin)) == {6}
    certify(result, points, corners=6)
    with pytest.raises(quadloom.Error, match="at least 4"):
        quadloom.k_angulate_points(points, 3)


def test_the_serpentine_triangulation_is_a_path(towns):
    result = quadloom.serpentine_triangulation(towns)
    assert quadloom.certify_order(result, "path")
    assert sorted(result.spiral) == list(range(len(towns)))


def test_heights_are_carried_along():
    points = quadloom.generate_points("uniform", 50)
    height = 3 * points[:, 0] - points[:, 1]
    for make in (quadloom.quadrangulate_points, quadloom.convex_quadrangulation, quadloom.delaunay):
        result = make(np.column_stack([points, height]))
        assert result.points.shape[1] == 3
        given = result.points[: result.input_vertices]
        assert np.array_equal(given[:, 2], 3 * given[:, 0] - given[:, 1])
    flat = quadloom.quadrangulate_points(points, method="subdivide")
    full = quadloom.quadrangulate_points(np.column_stack([points, height]), method="subdivide")
    assert np.array_equal(flat.quads, full.quads)
    inner = [s.vertex for s in full.steiner if s.kind == "inner"]
    x, y, z = full.points[inner].T
    assert np.allclose(z, 3 * x - y)


def test_numbers_at_added_points_are_interpolated():
    points = quadloom.generate_points("uniform", 60)
    result = quadloom.quadrangulate_points(points, method="subdivide")
    values = result.interpolate(2 * points[:, 0] + 5)
    inner = [s.vertex for s in result.steiner if s.kind == "inner"]
    assert np.allclose(values[inner], 2 * result.points[inner, 0] + 5)
    with pytest.raises(quadloom.Error, match="60 input points"):
        result.interpolate([1, 2])
