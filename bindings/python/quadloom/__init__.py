"""Quadrilateral meshes of points, polygons and triangle meshes: exact, and certified.

Points are arrays of shape (n, 2), or (n, 3) with heights; results are meshes with ``.points``, ``.quads`` and
``.triangles``. Every function of the C++ library is here under its C++ name.
"""
from ._core import *  # noqa: F403
from ._core import __version__
from ._errors import Error
from ._interop import from_meshio

__all__ = [name for name in dir() if not name.startswith("_")]
