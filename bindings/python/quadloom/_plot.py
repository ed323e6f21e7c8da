"""Meshes as pictures by Matplotlib: Mesh.plot."""
import numpy as np

from . import _interop
from ._core import Mesh, connect_triangles, quad_shape
from ._errors import Error

_OTHER_FACE = "#b8b3bd"   # as in the library's own pictures: what is no quad where quads are coloured by shape
_PLAIN = "#f6f7f9"
_ADDED = "#db0061"


def plot(mesh: Mesh, ax=None, *, colour="quality", edges=True, added=True, **options):
    """Draws the mesh into Matplotlib's axes; see Mesh.plot."""
    faces = _interop.faces_by_size(mesh)
    xy = mesh.points[:, :2]
    values, at_vertices = _values(mesh, faces, colour)
    if ax is None:
        ax = _interop.package("matplotlib.pyplot", "plot").gca()
    if at_vertices:
        coloured = _shade(ax, mesh, xy, values, options)
        if edges:
            _add_faces(ax, xy, faces, facecolors="none", **_lines(faces))
    else:
        fill = {"facecolors": _PLAIN} if values is None else {"array": values}
        if values is not None and isinstance(colour, str):
            fill |= {"clim": (0, 1)}
        coloured = _add_faces(ax, xy, faces, **(fill | (_lines(faces, values is None) if edges else {}) | options))
        if isinstance(colour, str):
            coloured.set_cmap(coloured.cmap.with_extremes(bad=_OTHER_FACE))
    if added and mesh.is_steiner.any():
        ax.plot(*xy[mesh.is_steiner].T, "o", markerfacecolor="none", markeredgecolor=_ADDED, zorder=coloured.zorder + 2)
    ax.set_aspect("equal")
    ax.autoscale_view()
    return coloured


def _values(mesh, faces, colour):
    """The numbers to colour by, or None, and whether they are those of the vertices."""
    if isinstance(colour, str):
        if colour == "quality":
            return _shapes(mesh.points[:, :2], faces), False
        if colour == "none":
            return None, False
        raise Error(f'colour must be "quality", "none" or numbers, not "{colour}"')
    values = np.ma.asarray(colour)
    vertices, count = len(mesh.points), mesh.face_count
    if values.shape not in ((vertices,), (count,)):
        raise Error(f"colour needs one number a vertex ({vertices}) or a face ({count}), not an array of shape "
                    f"{values.shape}")
    return values, len(values) == vertices


def _shapes(xy, faces):
    """quad_shape of each face, masked for what is no quad."""
    parts = [np.ma.asarray(quad_shape(*xy[block].transpose(1, 0, 2))) if block.shape[1] == 4
             else np.ma.masked_all(len(block)) for block in faces]
    return np.ma.concatenate(parts) if parts else np.ma.zeros(0)


def _lines(faces, dark=True):
    """Thin lines, thinner where there are many faces."""
    width = np.clip(14 / np.sqrt(1 + sum(map(len, faces))), 0.1, 1)
    return {"edgecolors": "#21242b" if dark else "white", "linewidths": width}


def _add_faces(ax, xy, faces, **options):
    collections = _interop.package("matplotlib.collections", "plot")
    corners = [face for block in faces for face in xy[block]]
    return ax.add_collection(collections.PolyCollection(corners, **options))


def _shade(ax, mesh, xy, values, options):
    """Smooth colours between the vertices: linear on two triangles of each quad, parted by a diagonal that is inside."""
    triangles = connect_triangles(mesh).triangles
    return ax.tripcolor(*xy.T, triangles, values, **({"shading": "gouraud"} | options))
