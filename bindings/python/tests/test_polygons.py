"""Polygons, segments and points of the plane."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import quadloom
from quadloom import NONE

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
HOLE = [[1, 1], [1, 2], [2, 2], [2, 1]]
BESIDE = [[4, 0], [8, 0], [8, 4], [4, 4]]


@pytest.mark.parametrize("polygons, count", [
    (SQUARE, 1), (np.array(SQUARE), 1), ([SQUARE], 1), ([SQUARE, HOLE], 1), ((np.array(SQUARE), HOLE), 1),
    ([[SQUARE, HOLE], [BESIDE]], 2), (np.array([[SQUARE], [BESIDE]]), 2), ([*SQUARE, SQUARE[0]], 1),
])
def test_polygons_may_be_given_as(polygons, count):
    result = quadloom.quadrangulate_polygons(polygons)
    assert len(set(result.triangulation.part)) == count
    assert quadloom.certify_polygons(result, polygons)


def test_a_lake(lake):
    result = quadloom.quadrangulate_polygons(lake)
    assert quadloom.certify_polygons(result, lake, steiner_inside=True)
    assert np.array_equal(result.points[result.input_to_vertex], np.concatenate(lake))
    assert not quadloom.certify_polygons(result, lake[:1])


@given(st.integers(3, 60), st.integers(0, 5), st.integers(0, 1000),
       st.sampled_from([g.name for g in quadloom.polygon_generators()]))
def test_any_polygon(corners, holes, seed, kind):
    least = {g.name: g.min_corners for g in quadloom.polygon_generators()}[kind]
    polygon = quadloom.with_holes(quadloom.generate_polygon(kind, max(corners, least), seed), holes, seed)
    assert quadloom.certify_polygons(quadloom.quadrangulate_polygons(polygon), polygon)


def test_points_segments_holes_and_regions():
    inner = [[1, 3], [3, 3], [3, 1]]
    result = quadloom.constrained_delaunay(SQUARE, inner, [[0, 1]])
    assert len(result.points) == 7
    kept = {tuple(sorted((result.triangles[t, i], result.triangles[t, (i + 1) % 3])))
            for t, i in np.argwhere(result.edge == 4)}
    assert kept == {(4, 5)}
    ring = [[0, 1], [1, 2], [2, 3], [3, 0]]
    alone = quadloom.constrained_delaunay(points=SQUARE + HOLE, segments=np.vstack([ring, np.add(ring, 4)]),
                                          holes=[[1.5, 1.5]], regions=[[0.5, 0.5]])
    assert set(alone.part) == {0}
    assert quadloom.certify_polygons(alone, [SQUARE, HOLE], corners=3)
    hull = quadloom.constrained_delaunay(points=SQUARE + HOLE, extent="hull")
    assert np.array_equal(np.sort(hull.triangles), np.sort(quadloom.delaunay(SQUARE + HOLE).triangles))


def test_points_outside_are_left_out():
    result = quadloom.constrained_delaunay(SQUARE, [[9, 9], [1, 1]])
    assert result.input_to_vertex.tolist() == [0, 1, 2, 3, NONE, 4]


def test_heights():
    ring = np.column_stack([SQUARE, [0, 1, 2, 3]])
    result = quadloom.quadrangulate_polygons(ring, [[1.0, 2.0, 7.0]])
    assert result.points[result.input_to_vertex, 2].tolist() == [0, 1, 2, 3, 7]


def test_hamiltonian_paths_of_polygons(lake):
    path = quadloom.hamiltonian_triangulation(SQUARE)
    assert path.order == "path" and quadloom.certify_order(path, "path")
    with pytest.raises(quadloom.Error) as caught:
        quadloom.hamiltonian_triangulation([SQUARE, HOLE])
    assert caught.value.code == "bad-polygon"
    star = quadloom.generate_polygon("star", 40)
    for polygon in (star, lake):
        for order in ("path", "cycle"):
            made = quadloom.hamiltonian_triangulation_with_points(polygon, order)
            assert quadloom.certify_order(made, order)
            assert quadloom.certify_polygons(made, polygon, corners=3)
    assert quadloom.sequential_triangulation([SQUARE]).order == "sequential"


def test_convex_parts(lake):
    parts = quadloom.convex_decomposition([SQUARE, HOLE])
    assert parts.face_count >= parts.at_least > 1
    assert quadloom.convex_decomposition(SQUARE).is_fewest
    assert len(quadloom.convex_decomposition(lake).face_begin) - 1 >= 4


def test_generators():
    assert {g.name for g in quadloom.generators()} >= {"uniform", "clusters"}
    for generator in quadloom.generators():
        points = quadloom.generate_points(generator.name, max(50, generator.min_points))
        assert points.shape[1] == 2 and np.isfinite(points).all()
    polygon = quadloom.generate_polygon("star", 20)
    assert len(polygon) == 1 and len(polygon[0]) == 20
