"""Meshes and polygons of other packages, in and out. They are known by the names of their classes, so that none of the
packages is needed, or loaded, but for making its own objects."""
import importlib

import numpy as np

from ._core import ErrorCode, Mesh, MeshFile, PolygonMesh, orient2d, to_polygon_mesh
from ._errors import Error


def package(name, extra):
    """The module of that name, of a package that one of our extras installs."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        wanted = name.partition(".")[0]
        if (error.name or name).partition(".")[0] != wanted:
            raise
        raise ImportError(f'this needs {wanted}: pip install "quadloom[{extra}]"', name=wanted) from None


def faces_by_size(mesh):
    """The faces in their order as arrays (m, k), one for each run of faces of the same size."""
    faces = to_polygon_mesh(mesh)
    sizes = np.diff(faces.face_begin)
    starts = np.flatnonzero(np.diff(sizes, prepend=0))
    return [faces.face_vertex[faces.face_begin[a]:faces.face_begin[b]].reshape(b - a, -1)
            for a, b in zip(starts, [*starts[1:], len(sizes)])]


def _in_space(points):
    """Points (n, 3)."""
    return np.column_stack([points, np.zeros(len(points))]) if points.shape[1] == 2 else points


# ---- Meshes in. ----

def is_mesh(given):
    """Whether it is a mesh of another package."""
    return _reader(given) is not None


def mesh(given):
    """A quadloom.Mesh of a mesh of another package."""
    return _reader(given)(given)


def _reader(given):
    for kind in type(given).__mro__:
        reader = _READERS.get((kind.__module__.partition(".")[0], kind.__name__))
        if reader is not None:
            return reader
    return None


def _from_matplotlib(given):
    """A matplotlib.tri.Triangulation, without the triangles that it masks; the clockwise ones are turned."""
    points = np.column_stack([given.x, given.y])
    triangles = np.array(given.triangles if given.mask is None else given.triangles[~given.mask])
    clockwise = orient2d(*points[triangles].transpose(1, 0, 2)) < 0
    triangles[clockwise] = triangles[clockwise, ::-1]
    return PolygonMesh(points, triangles)


def _from_scipy(given):
    """A scipy.spatial.Delaunay of points in the plane."""
    if given.points.shape[1] != 2:
        raise Error(f"a triangulation of the plane is wanted, not of dimension {given.points.shape[1]}",
                    ErrorCode.BAD_MESH)
    return PolygonMesh(given.points, given.simplices)


def from_meshio(mesh) -> MeshFile:
    """A meshio.Mesh of triangles, quads and polygons, with its lines and its data of one number a point or a cell. It may
    also be given as it is wherever a mesh is expected.

    Heights that are all 0 count as none. Vertex cells and data of several numbers are left out.

    Raises Error: bad-mesh for cells that are no faces, such as tetrahedra, or that have nodes on their edges."""
    def is_face(block):
        return block.type in ("triangle", "quad") or block.type.startswith("polygon")

    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 3 and not points[:, 2].any():
        points = points[:, :2]
    for block in mesh.cells:
        if not is_face(block) and block.type not in ("line", "vertex"):
            raise Error(f"cells of type {block.type}: triangles, quads and polygons are wanted", ErrorCode.BAD_MESH)
    lines = [block.data for block in mesh.cells if block.type == "line"]
    face_data = {name: np.concatenate([values for block, values in zip(mesh.cells, blocks) if is_face(block)])
                 for name, blocks in mesh.cell_data.items() if all(map(_is_scalar, blocks)) and any(map(is_face, mesh.cells))}
    return MeshFile(PolygonMesh(points, *(block.data for block in mesh.cells if is_face(block))),
                    vertex_data={name: values for name, values in mesh.point_data.items() if _is_scalar(values)},
                    face_data=face_data, edges=np.concatenate(lines) if lines else None)


def _is_scalar(values):
    values = np.asarray(values)
    return values.dtype.kind in "biuf" and values.size == len(values)


_READERS = {("matplotlib", "Triangulation"): _from_matplotlib, ("scipy", "Delaunay"): _from_scipy,
            ("meshio", "Mesh"): from_meshio}


# ---- Meshes out. ----

def to_meshio(mesh: Mesh):
    meshio = package("meshio", "meshio")
    file = MeshFile(mesh)
    faces = faces_by_size(file)
    cells = [({3: "triangle", 4: "quad"}.get(block.shape[1], "polygon"), block) for block in faces]
    ends = np.cumsum([len(block) for block in faces])[:-1]
    data = {name: np.split(values, ends) for name, values in file.face_data.items()}
    if len(file.edges) > 0:
        cells.append(("line", file.edges))
        for blocks in data.values():
            blocks.append(np.full(len(file.edges), np.nan))
    return meshio.Mesh(_in_space(file.points), cells, point_data=file.vertex_data, cell_data=data)


def to_pyvista(mesh: Mesh):
    pyvista = package("pyvista", "pyvista")
    file = MeshFile(mesh)
    padded = [np.insert(block.astype(np.int64), 0, block.shape[1], axis=1).ravel() for block in faces_by_size(file)]
    surface = pyvista.PolyData(_in_space(file.points), np.concatenate(padded) if padded else None)
    for name, values in file.vertex_data.items():
        surface.point_data[name] = values
    for name, values in file.face_data.items():
        surface.cell_data[name] = values
    return surface


# ---- Polygons in. ----

def is_polygons(given):
    """Whether it has the polygons of GeoJSON to offer, as those of shapely and GeoPandas do."""
    return hasattr(given, "__geo_interface__")


def polygons(given):
    """The polygons of an object with `__geo_interface__`, as lists of rings."""
    return [[np.array(ring, float) for ring in polygon] for polygon in _polygons(given.__geo_interface__)]


def _polygons(geometry):
    kind = geometry["type"]
    if kind == "Polygon":
        return [geometry["coordinates"]] if geometry["coordinates"] else []
    if kind == "MultiPolygon":
        return geometry["coordinates"]
    if kind == "Feature":
        return _polygons(geometry["geometry"])
    if kind in ("GeometryCollection", "FeatureCollection"):
        parts = geometry["geometries" if kind == "GeometryCollection" else "features"]
        return [polygon for part in parts for polygon in _polygons(part)]
    raise Error(f"polygons are wanted, not a {kind}")
