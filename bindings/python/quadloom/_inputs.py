"""What people give, as the library reads it: one function a kind. Objects of other packages are known here."""
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _interop
from ._core import ErrorCode, Mesh, PolygonMesh
from ._errors import Error

#: A quadloom.Mesh, (points, faces), or a mesh of another package: a matplotlib.tri.Triangulation, a
#: scipy.spatial.Delaunay, a meshio.Mesh.
MeshLike: TypeAlias = "Mesh | tuple[ArrayLike, ArrayLike] | Any"
#: A ring (k, 2), the rings of a polygon, several polygons, or an object with __geo_interface__, such as shapely's.
PolygonsLike: TypeAlias = "ArrayLike | Sequence[ArrayLike] | Sequence[Sequence[ArrayLike]] | Any"


# ---- Points and numbers. ----

def points(given):
    """Points as a C-contiguous, aligned float64 array of shape (n, 2) or (n, 3)."""
    array = _real(given, "points")
    if array.size == 0 and array.ndim <= 2:
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise Error(f"points must be of shape (n, 2) or (n, 3), not {array.shape}")
    return np.require(array, np.float64, "CA")


def operand(given):
    """One point (2,) or several (n, 2) as (n, 2)."""
    array = _real(given, "points")
    if array.ndim not in (1, 2) or array.shape[-1] != 2:
        raise Error(f"a point must be of shape (2,), points of (n, 2), not {array.shape}")
    return np.require(array.reshape(-1, 2), np.float64, "CA")


def numbers(given, name):
    """Numbers as a flat float64 array."""
    return np.require(_real(given, name), np.float64, "CA").reshape(-1)


def indices(given, name):
    """Whole numbers that are no less than 0, as a flat uint32 array."""
    return _whole(given, name).reshape(-1)


def weights(given, name):
    """Whole numbers as a flat int32 array."""
    array = _array(given, name)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise Error(f"{name} must be whole numbers, not {array.dtype}")
    if array.size > 0 and (array.min() < -2**31 or array.max() >= 2**31):
        raise Error(f"{name} must be of 32 bits")
    return np.require(array, np.int32, "CA").reshape(-1)


def flags(given, name):
    """Truth values as a flat uint8 array."""
    return np.require(np.asarray(given, dtype=bool).reshape(-1), np.uint8, "CA")


def _array(given, name):
    try:
        return np.asarray(given)
    except ValueError as error:
        raise Error(f"{name}: no array of numbers ({error})") from None


def _real(given, name):
    array = _array(given, name)
    if array.dtype.kind not in "biuf" and array.size > 0:
        try:
            return array.astype(np.float64, casting="safe" if array.dtype.kind == "c" else "unsafe")
        except (TypeError, ValueError):
            raise Error(f"{name} must be real numbers, not {array.dtype}") from None
    return array


def _whole(given, name):
    array = _array(given, name)
    if array.size == 0:
        return np.zeros(array.shape, np.uint32)
    if array.dtype.kind not in "iu":
        raise Error(f"{name} must be whole numbers, not {array.dtype}")
    wrong = (array < 0) | (array > 0xFFFFFFFF)
    if wrong.any():
        row = np.argwhere(wrong)[0]
        index = int(array[tuple(row)])
        raise Error(f"{name}: row {row[0]} has the number {index}, which names nothing",
                    ErrorCode.INDEX_OUT_OF_RANGE, [int(row[0]), max(index, 0)])
    return np.require(array, np.uint32, "CA")


# ---- Meshes. ----

def faces(given):
    """Faces as arrays (m, k) uint32, one for each run of faces of the same size."""
    try:
        array = np.asarray(given)
        if array.dtype != object:
            return [_face_array(array)]
    except ValueError:  # faces of different sizes
        pass
    try:
        rows = [np.asarray(face) for face in given]
        sizes = [len(face) for face in rows]
    except (TypeError, ValueError) as error:
        raise Error(f"faces must be of shape (m, k), or a list of faces ({error})") from None
    starts = [i for i, size in enumerate(sizes) if i == 0 or size != sizes[i - 1]]
    return [_face_array(np.stack(rows[a:b])) for a, b in zip(starts, [*starts[1:], len(rows)])]


def _face_array(given):
    array = _whole(given, "faces")
    if array.size == 0:
        return np.zeros((0, 3), np.uint32)
    if array.ndim != 2:
        raise Error(f"faces must be of shape (m, k), not {array.shape}")
    return array


def is_mesh(given):
    """Whether it is a mesh by itself, and no array of points."""
    return (isinstance(given, Mesh) or isinstance(given, tuple) and len(given) == 2 and np.ndim(given[0]) == 2
            or _interop.is_mesh(given))


def mesh(given, faces):
    """A quadloom.Mesh of what is given: (points, faces), or points with `faces` beside them."""
    if faces is not None:
        return PolygonMesh(given, faces)
    if isinstance(given, tuple) and len(given) >= 2:
        return PolygonMesh(*given)
    if _interop.is_mesh(given):
        return _interop.mesh(given)
    raise Error(f"a mesh is wanted, or points and faces, not {type(given).__name__}")


# ---- Polygons. ----

def polygons(given):
    """Polygons as lists of rings (k, 2) or (k, 3): a ring, a polygon's rings, or several polygons."""
    if given is None:
        return []
    if _interop.is_polygons(given):
        return _interop.polygons(given)
    depth = _depth(given)
    if depth == 2:
        return [[points(given)]]
    if depth == 3:
        return [[points(ring) for ring in given]]
    if depth == 4:
        return [[points(ring) for ring in polygon] for polygon in given]
    if depth == 0 and np.size(given) == 0:
        return []
    raise Error("a polygon must be a ring (k, 2), a list of rings, or a list of such lists")


def is_polygon(given):
    """Whether it is a polygon by itself, and no array of points."""
    return (_interop.is_polygons(given)
            or isinstance(given, Sequence | np.ndarray) and not isinstance(given, str) and _depth(given) > 2)


def _depth(given):
    """How deeply numbers are nested; 0 for nothing."""
    if isinstance(given, np.ndarray) and given.dtype != object:
        return given.ndim
    if np.isscalar(given):
        return 0
    if not isinstance(given, Sequence | np.ndarray):
        raise Error(f"a polygon must be a ring (k, 2), a list of rings, or a list of such lists, not "
                    f"{type(given).__name__}")
    return 1 + max((_depth(part) for part in given[:1]), default=-1)
