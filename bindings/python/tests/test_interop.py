"""Meshes and polygons of other packages, in and out."""
import subprocess
import sys

import meshio
import numpy as np
import pytest
import pyvista
import scipy.spatial
import shapely
from matplotlib.tri import Triangulation

import quadloom

SQUARE = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [2, 1]], float)


def scattered(n=200, seed=1):
    return np.random.default_rng(seed).random((n, 2))


def same_faces(a, b):
    return {frozenset(face) for face in a.tolist()} == {frozenset(face) for face in b.tolist()}


# ---- Triangulations in. ----

@pytest.mark.parametrize("function", [quadloom.quadrangulate_triangles, quadloom.convex_quadrangulation])
@pytest.mark.parametrize("make", [scipy.spatial.Delaunay, lambda points: Triangulation(*points.T)],
                         ids=["scipy", "matplotlib"])
def test_triangulations_of_others_become_quads(make, function):
    points = scattered()
    given = make(points)
    mesh = function(given)
    assert np.array_equal(mesh.points[:len(points)], points)
    triangles = given.simplices if hasattr(given, "simplices") else given.triangles
    assert quadloom.certify_mesh(mesh, (points, triangles))
    assert len(mesh.triangles) == 0


def test_masked_triangles_are_left_out():
    given = Triangulation(*SQUARE.T)
    mask = np.arange(len(given.triangles)) == 1
    given.set_mask(mask)
    assert same_faces(quadloom.Triangulation(given).triangles, given.triangles[~mask])


def test_clockwise_triangles_are_turned():
    mesh = quadloom.Triangulation(Triangulation(*SQUARE[:4].T, [[0, 2, 1], [0, 2, 3]]))
    assert np.array_equal(mesh.triangles, [[1, 2, 0], [0, 2, 3]])


def test_a_delaunay_triangulation_of_space_is_refused():
    with pytest.raises(quadloom.Error, match="dimension 3") as caught:
        quadloom.quadrangulate_triangles(scipy.spatial.Delaunay(np.random.default_rng(1).random((9, 3))))
    assert caught.value.code == "bad-mesh"


def test_others_are_not_taken_for_meshes():
    with pytest.raises(quadloom.Error, match="a mesh is wanted"):
        quadloom.quadrangulate_triangles(scipy.spatial.ConvexHull(SQUARE))


# ---- meshio. ----

def test_to_meshio_and_back():
    mesh = quadloom.quadrangulate_points(scattered(seed=3), method="insertion")
    there = mesh.to_meshio()
    assert there.points.shape == (len(mesh.points), 3) and not there.points[:, 2].any()
    assert np.array_equal(there.cells_dict["quad"], mesh.quads)
    back = quadloom.from_meshio(there)
    assert np.array_equal(back.points, mesh.points) and np.array_equal(back.quads, mesh.quads)


def test_faces_of_all_sizes_lines_and_data_come_back_in_their_order():
    points = np.array([[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1], [1, 3, 1], [3, 1, 2]], float)
    given = quadloom.MeshFile(quadloom.PolygonMesh(points, [[0, 1, 2, 3], [3, 2, 4], [1, 5, 2], [2, 3, 0, 1, 5]]),
                              vertex_data={"depth": range(6)}, face_data={"region": [7, 8, 9, 10]},
                              edges=[[0, 1], [3, 4]])
    there = given.to_meshio()
    assert [block.type for block in there.cells] == ["quad", "triangle", "polygon", "line"]
    back = quadloom.from_meshio(there)
    for name in ("points", "edges"):
        assert np.array_equal(getattr(back, name), getattr(given, name))
    a, b = (quadloom.to_polygon_mesh(mesh) for mesh in (back, given))
    assert np.array_equal(a.face_begin, b.face_begin) and np.array_equal(a.face_vertex, b.face_vertex)
    assert np.array_equal(back.vertex_data["depth"], range(6))
    assert np.array_equal(back.face_data["region"], [7, 8, 9, 10])


def test_added_points_are_marked():
    mesh = quadloom.convex_quadrangulation(scattered(60), method="spiral")
    assert mesh.is_steiner.any()
    for there in (mesh.to_meshio().point_data, mesh.to_pyvista().point_data):
        assert np.array_equal(there["added"], mesh.is_steiner)


def test_a_meshio_mesh_is_a_mesh(tmp_path):
    points = scattered()
    triangles = scipy.spatial.Delaunay(points).simplices
    meshio.Mesh(np.column_stack([points, 0 * points[:, 0]]), [("vertex", [[0]]), ("triangle", triangles)],
                point_data={"velocity": np.ones((len(points), 3))}).write(tmp_path / "mesh.vtu")
    read = meshio.read(tmp_path / "mesh.vtu")
    mesh = quadloom.quadrangulate_triangles(read)
    assert quadloom.certify_mesh(mesh, (points, triangles))
    assert quadloom.from_meshio(read).vertex_data == {}


@pytest.mark.parametrize("kind", ["tetra", "triangle6"])
def test_cells_that_are_no_faces_are_refused(kind):
    corners = {"tetra": 4, "triangle6": 6}[kind]
    with pytest.raises(quadloom.Error, match=f"cells of type {kind}") as caught:
        quadloom.from_meshio(meshio.Mesh(np.random.default_rng(1).random((6, 3)), [(kind, [range(corners)])]))
    assert caught.value.code == "bad-mesh"


# ---- pyvista. ----

def test_to_pyvista():
    mesh = quadloom.quadrangulate_points(scattered(101, seed=2), odd_boundary="triangle")
    surface = mesh.to_pyvista()
    assert isinstance(surface, pyvista.PolyData)
    assert surface.n_points == len(mesh.points) and surface.n_cells == mesh.face_count
    assert np.array_equal(surface.get_cell(0).point_ids, mesh.quads[0])
    x, y = mesh.points[quadloom.convex_hull(mesh.points)].T
    hull = (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    assert quadloom.convex_quadrangulation(scattered(101, seed=2)).to_pyvista().area == pytest.approx(hull, rel=0.1)


def test_to_pyvista_keeps_faces_of_all_sizes_and_data():
    faces = [[0, 1, 2, 3], [0, 1, 4]]
    given = quadloom.MeshFile((SQUARE, faces), face_data={"region": [1, 2]}, vertex_data={"depth": range(5)})
    surface = given.to_pyvista()
    assert [list(surface.get_cell(i).point_ids) for i in (0, 1)] == faces
    assert list(surface.cell_data["region"]) == [1, 2] and list(surface.point_data["depth"]) == [*range(5)]


# ---- Polygons in. ----

OUTER = [(0, 0), (9, 0), (9, 9), (0, 9)]
HOLE = [(3, 3), (3, 5), (5, 4)]


def test_shapely_polygons_are_polygons():
    lake = shapely.Polygon(OUTER, [HOLE])
    mesh = quadloom.quadrangulate_polygons(lake)
    assert quadloom.certify_polygons(mesh, [OUTER, HOLE])
    assert np.array_equal(mesh.quads, quadloom.quadrangulate_polygons([OUTER, HOLE]).quads)


def test_shapely_polygons_are_polygons_where_points_may_be_given():
    order = quadloom.sequential_triangulation(shapely.box(0, 0, 9, 9))
    assert isinstance(order, quadloom.PolygonOrder) and len(order.triangles) == 2


def test_shapely_multipolygons_are_polygons():
    lakes = shapely.MultiPolygon([shapely.Polygon(OUTER, [HOLE]), shapely.box(20, 0, 30, 10)])
    mesh = quadloom.quadrangulate_polygons(lakes)
    assert quadloom.certify_polygons(mesh, lakes)
    assert sum(shapely.Polygon(mesh.points[quad]).area for quad in mesh.quads) == pytest.approx(lakes.area)


def test_features_are_polygons():
    class Frame:
        __geo_interface__ = {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {}, "geometry": shapely.box(0, 0, 1, 1).__geo_interface__},
            {"type": "Feature", "properties": {}, "geometry": shapely.box(2, 0, 3, 1).__geo_interface__}]}

    assert len(quadloom.quadrangulate_polygons(Frame()).quads) == 2


def test_other_geometries_are_refused():
    with pytest.raises(quadloom.Error, match="polygons are wanted, not a LineString"):
        quadloom.quadrangulate_polygons(shapely.LineString(OUTER))
    with pytest.raises(quadloom.Error):
        quadloom.quadrangulate_polygons(shapely.Polygon())


# ---- None of it is needed. ----

WITHOUT = """
import sys
for name in ("matplotlib", "matplotlib.pyplot", "meshio", "pyvista", "scipy", "shapely"):
    sys.modules[name] = None          # as if it were not installed
import quadloom
mesh = quadloom.quadrangulate_points([(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)])
assert len(quadloom.quadrangulate_polygons([(0, 0), (4, 0), (4, 4), (0, 4)]).quads) == 1
for method, extra in (("plot", "plot"), ("to_meshio", "meshio"), ("to_pyvista", "pyvista")):
    try:
        getattr(mesh, method)()
    except ImportError as error:
        print(error)
"""


def test_numpy_alone_is_needed_and_the_extra_is_named():
    run = subprocess.run([sys.executable, "-c", WITHOUT], text=True, capture_output=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == [f'this needs {name}: pip install "quadloom[{extra}]"' for name, extra in
                                       (("matplotlib", "plot"), ("meshio", "meshio"), ("pyvista", "pyvista"))]


def test_nothing_else_is_loaded():
    loaded = "import sys, quadloom; quadloom.quadrangulate_points([(0, 0), (4, 0), (4, 4), (0, 4)]); print(*sys.modules)"
    modules = subprocess.run([sys.executable, "-c", loaded], text=True, capture_output=True, check=True).stdout.split()
    assert not {"matplotlib", "meshio", "pyvista", "scipy", "shapely"} & set(modules)
