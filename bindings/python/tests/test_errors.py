"""What is refused: a ValueError with the library's sentence, code and culprits."""
import math
import pickle

import numpy as np
import pytest

import quadloom
from quadloom import ErrorCode

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
NAN = math.nan

REFUSED = [
    (lambda: quadloom.quadrangulate_points([[0, 0], [1, NAN], [1, 1]]), "not-finite", [1], "point 1 has a coordinate"),
    (lambda: quadloom.quadrangulate_points([[0, 0], [1, 1]]), "too-few-points", [], None),
    (lambda: quadloom.quadrangulate_points([[0, 0], [1, 1], [2, 2]]), "all-collinear", [], None),
    (lambda: quadloom.quadrangulate_points([1, 2, 3]), "bad-option", [], r"shape \(n, 2\) or \(n, 3\), not \(3,\)"),
    (lambda: quadloom.quadrangulate_points(np.zeros((4, 5))), "bad-option", [], r"not \(4, 5\)"),
    (lambda: quadloom.quadrangulate_points([[1, 2], [3]]), "bad-option", [], "no array of numbers"),
    (lambda: quadloom.quadrangulate_points("towns.csv"), "bad-option", [], "real numbers"),
    (lambda: quadloom.quadrangulate_points([[1j, 2], [3, 4], [5, 6]]), "bad-option", [], "real numbers"),
    (lambda: quadloom.quadrangulate_points(SQUARE, method="nearest"), "bad-option", [],
     r"method: 'nearest' is none of delaunay\|spiral\|insertion\|subdivide"),
    (lambda: quadloom.quadrangulate_points(SQUARE, method=quadloom.OddBoundary.ON_EDGE), "bad-option", [], "method"),
    (lambda: quadloom.quadrangulate_points(SQUARE, method=3), "bad-option", [], "method: 3 is none of"),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [[0, 1, 4]]), "index-out-of-range", [0, 4], "face 0"),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [[0, 1, 2], [0, 2, -1]]), "index-out-of-range", [1, 0], "-1"),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [[0, 1, 2**40]]), "index-out-of-range", [0, 2**40], None),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [[0, 1, 2.5]]), "bad-option", [], "whole numbers"),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [0, 1, 2]), "bad-option", [], r"shape \(m, k\)"),
    (lambda: quadloom.quadrangulate_triangles([*SQUARE, [NAN, 0]], [[0, 1, 2]]), "not-finite", [4], None),
    (lambda: quadloom.quadrangulate_triangles(SQUARE, [[0, 1, 2], [0, 1, 3]]), "bad-mesh", None, None),
    (lambda: quadloom.quadrangulate_triangles(7), "bad-option", [], "a mesh is wanted"),
    (lambda: quadloom.quadrangulate_polygons([[0, 0], [1, 1], [1, 0], [0, 1]]), "crossing", [0, 2], "crosses"),
    (lambda: quadloom.quadrangulate_polygons([SQUARE, [[5, 5], [6, 5], [6, 6]]]), "bad-polygon", None, None),
    (lambda: quadloom.convex_quadrangulation(([[0, 1], [2]], 3)), "bad-option", [], "no array of numbers"),
    (lambda: quadloom.sequential_triangulation([object()]), "bad-option", [], "real numbers"),
    (lambda: quadloom.sequential_triangulation([[object()]]), "bad-option", [], "real numbers"),
    (lambda: quadloom.quadrangulate_polygons(3), "bad-option", [], "a polygon must be"),
    (lambda: quadloom.constrained_delaunay(SQUARE, segments=[[0, 1]]), "index-out-of-range", [0, 0], None),
    (lambda: quadloom.constrained_delaunay(points=SQUARE, segments=[0, 1, 2]), "bad-option", [], "two numbers each"),
    (lambda: quadloom.MeshFile((SQUARE, [[0, 1, 2, 3]]), edges=[[0, 1, 2]]), "bad-option", [], "two numbers each"),
    (lambda: quadloom.generate_points("towns", 5), "bad-option", [], "there are"),
    (lambda: quadloom.convex_hull([[0, 0], [1, 0], [0, 0]]), "bad-option", [0, 2], "point 2 is point 0 again"),
    (lambda: quadloom.orient2d([0, 0], [1, 0], [NAN, 1]), "not-finite", [0], None),
    (lambda: quadloom.orient2d([0, 0], [[1, 0]] * 2, [[1, 1]] * 3), "bad-option", [], "do not go together"),
    (lambda: quadloom.read_points("no/such/file.csv"), "file", [], "no/such/file.csv"),
    (lambda: quadloom.certify_points((SQUARE, [[0, 1, 2, 3]]), SQUARE, corners=2), "bad-option", [], None),
    (lambda: quadloom.draw_mesh("x.bmp", (SQUARE, [[0, 1, 2, 3]])), "bad-option", [], "x.bmp"),
    (lambda: quadloom.draw_mesh("x.svg", (SQUARE, [[0, 1, 2, 9]])), "index-out-of-range", [0, 9], None),
]


@pytest.mark.parametrize("call, code, culprits, words", REFUSED, ids=range(len(REFUSED)))
def test_refused(call, code, culprits, words):
    with pytest.raises(ValueError, match=words) as caught:
        call()
    error = caught.value
    assert isinstance(error, quadloom.Error)
    assert error.code == code and error.code is ErrorCode(code)
    if culprits is not None:
        assert error.culprits == culprits


def test_arguments_of_the_wrong_type_are_type_errors():
    with pytest.raises(TypeError):
        quadloom.quadrangulate_points(None)
    with pytest.raises(TypeError):
        quadloom.quadrangulate_points(SQUARE, progress=3)
    with pytest.raises(TypeError):
        quadloom.quadrangulate_points(SQUARE, "spiral")  # options are keywords


def test_errors_can_be_sent():
    error = quadloom.Error("a sentence", ErrorCode.CROSSING, [1, 2])
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.code, again.culprits) == ("a sentence", "crossing", [1, 2])
