"""NumPy in and out: every layout is the same points, results are views."""
import gc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import quadloom
import strategies

LAYOUTS = {
    "fortran": np.asfortranarray,
    "list": lambda a: a.tolist(),
    "rows backwards": lambda a: a[::-1].copy()[::-1],
    "columns of a table": lambda a: np.column_stack([a[:, 0], np.ones(len(a)), a[:, 1]])[:, ::2],
    "every second row": lambda a: np.repeat(a, 2, axis=0)[::2],
    "big-endian": lambda a: a.astype(">f8"),
    "long double": lambda a: a.astype(np.longdouble),
    "objects": lambda a: a.astype(object),
    "read-only": lambda a: np.frombuffer(a.tobytes()).reshape(a.shape),
    "not aligned": lambda a: np.frombuffer(b"x" + a.tobytes(), offset=1).reshape(a.shape),
}


@given(strategies.finite_points(), st.sampled_from(sorted(LAYOUTS)))
def test_layouts_agree(points, layout):
    given_points = LAYOUTS[layout](points)
    try:
        expected = quadloom.quadrangulate_points(points)
    except quadloom.Error as error:
        with pytest.raises(quadloom.Error) as again:
            quadloom.quadrangulate_points(given_points)
        assert again.value.code == error.code
        return
    result = quadloom.quadrangulate_points(given_points)
    assert np.array_equal(result.points, expected.points)
    assert np.array_equal(result.quads, expected.quads)


@pytest.mark.parametrize("dtype", [bool, np.int8, np.uint8, np.int16, np.int32, np.int64, np.uint64, np.float16,
                                   np.float32])
def test_number_types_agree(dtype):
    points = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    result = quadloom.quadrangulate_points(points.astype(dtype))
    assert result.points.dtype == np.float64
    assert np.array_equal(result.points, points)


@pytest.mark.parametrize("dtype", [np.int8, np.uint16, np.int32, np.int64, np.uint32, ">i4"])
def test_index_types_agree(dtype):
    points = [[0, 0], [2, 0], [2, 2], [0, 2]]
    triangles = np.array([[0, 1, 2], [0, 2, 3]], dtype)
    for given_triangles in (triangles, np.asfortranarray(triangles), triangles.tolist()):
        assert quadloom.quadrangulate_triangles(points, given_triangles).quads.shape == (1, 4)


def test_results_are_views_that_live_on():
    points = quadloom.generate_points("uniform", 1000)
    result = quadloom.quadrangulate_points(points)
    assert np.shares_memory(result.quads, result.quads)
    assert np.shares_memory(result.points, result.points)
    quads, vertices = result.quads, result.points
    copy = quads.copy()
    del result
    gc.collect()
    quadloom.quadrangulate_points(points[::-1])
    assert np.array_equal(quads, copy) and np.array_equal(vertices[:1000], points)


def test_results_are_read_only(towns):
    result = quadloom.quadrangulate_points(towns)
    for array in (result.points, result.quads, result.triangles, result.is_steiner, result.input_to_vertex):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    assert (result.quads.dtype, result.points.dtype, result.is_steiner.dtype) == (np.uint32, np.float64, bool)
    assert (result.quads.shape[1], result.triangles.shape) == (4, (0, 3))


def test_the_input_is_left_alone(towns):
    given_points = towns.copy()
    quadloom.convex_quadrangulation(given_points)
    assert np.array_equal(given_points, towns)


def test_a_result_is_an_input(towns):
    result = quadloom.quadrangulate_points(towns)
    again = quadloom.quadrangulate_points(result.points)
    assert np.array_equal(again.quads, result.quads)
