"""Gmsh opens what is written."""
import gmsh
import numpy as np
import pytest

import quadloom

QUAD, TRIANGLE = 3, 2  # Gmsh's numbers of the element types


@pytest.fixture
def opened():
    """Opens a file; gives the nodes' coordinates by number, and the corners of the elements by type."""
    def open_file(path):
        gmsh.open(str(path))
        numbers, coordinates, _ = gmsh.model.mesh.getNodes()
        corners = {}
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2)):
            corners[kind] = nodes.reshape(-1, {QUAD: 4, TRIANGLE: 3}[kind])
        return dict(zip(numbers, coordinates.reshape(-1, 3))), corners

    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    yield open_file
    gmsh.finalize()


def the_same(mesh, opened_file):
    nodes, elements = opened_file
    assert len(nodes) == len(mesh.points)
    assert {kind: len(corners) for kind, corners in elements.items()} == {
        kind: len(faces) for kind, faces in ((QUAD, mesh.quads), (TRIANGLE, mesh.triangles)) if len(faces) > 0}
    for kind, faces in ((QUAD, mesh.quads), (TRIANGLE, mesh.triangles)):
        if len(faces) > 0:
            places = [[tuple(nodes[n][:2]) for n in corners] for corners in elements[kind]]
            assert places == [[tuple(p) for p in corners] for corners in mesh.points[faces][:, :, :2].tolist()]


@pytest.mark.parametrize("format", ["msh", "msh22"])
@pytest.mark.parametrize("odd_boundary", ["outside", "triangle"])
def test_a_file_of_ours_opens_with_the_same_nodes_and_faces(tmp_path, opened, format, odd_boundary):
    points = np.random.default_rng(5).random((500, 2))
    mesh = quadloom.convex_quadrangulation(points, odd_boundary=odd_boundary)
    path = tmp_path / "mesh.msh"
    quadloom.write_mesh(path, mesh, format)
    the_same(mesh, opened(path))


def test_a_file_by_meshio_opens_with_the_same_nodes_and_faces(tmp_path, opened):
    mesh = quadloom.quadrangulate_polygons([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 5), (5, 4)]])
    mesh.to_meshio().write(tmp_path / "mesh.msh", file_format="gmsh")
    the_same(mesh, opened(tmp_path / "mesh.msh"))
