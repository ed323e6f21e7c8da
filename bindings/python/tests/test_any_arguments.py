"""Every function and class with arguments that make no sense: an answer or an exception that is meant, never a crash."""
import itertools

import numpy as np
import pytest

import quadloom as q

POINTS = [[0, 0], [1, 0], [0, 1]]
ODD = [None, 0, "x", [], [[]], [[[]]], object(), {}, np.zeros((0, 2)), np.zeros((3, 3)), np.full((4, 2), np.nan), POINTS,
       (POINTS, [[0, 1, 2]]), (POINTS, [[0, 1, 7]]), ({},), q.DualGraph(np.zeros((0, 3), int)), q.DualMatching([]),
       q.PathPartition([5], [0, 9]), q.StripCode("repeat", []), q.PolygonMesh(POINTS, [[0, 1, 9]]),
       q.PolygonMesh([*POINTS, [np.nan, 1]], [[0, 1, 3]]), q.Triangulation([*POINTS, [1, 1]], [[0, 2, 1], [0, 1, 3]]),
       q.MaximumMatching(q.DualMatching([3]), [9]), q.delaunay([*POINTS, [0.3, 0.3]])]
NAMES = [name for name in q.__all__ if callable(getattr(q, name)) and not name.startswith(("write_", "draw_mesh"))]


def look_at(result):
    repr(result)
    if isinstance(result, q.Mesh):
        _ = result.points, result.quads, result.triangles, result.is_steiner, result.steiner, result._repr_svg_()


@pytest.mark.parametrize("name", NAMES)
def test_any_arguments(name):
    arguments = [(), *itertools.product(ODD), *itertools.product(ODD[::2], ODD)]
    for given in arguments:
        try:
            look_at(getattr(q, name)(*given))
        except (ValueError, TypeError, AttributeError, KeyError):
            pass
