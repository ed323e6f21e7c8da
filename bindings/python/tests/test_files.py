"""Files and pictures."""
import xml.etree.ElementTree

import numpy as np
import pytest

import quadloom


@pytest.fixture(scope="module")
def mesh(towns):
    return quadloom.convex_quadrangulation(np.column_stack([towns, towns[:, 0]]), method="spiral")


@pytest.mark.parametrize("name", ["a.obj", "a.off", "a.ply", "a.vtu", "a.msh"])
def test_meshes_come_back(tmp_path, mesh, name):
    mesh.save(tmp_path / name)
    again = quadloom.read_mesh(tmp_path / name)
    assert np.array_equal(again.points, mesh.points) and np.array_equal(again.quads, mesh.quads)


def test_data_comes_back(tmp_path, mesh):
    shape = np.arange(float(mesh.face_count))
    file = quadloom.MeshFile(mesh, vertex_data={"x": mesh.points[:, 0]}, face_data={"n": shape}, edges=[[0, 1]])
    quadloom.write_mesh(str(tmp_path / "a.vtu"), file)
    again = quadloom.read_mesh(tmp_path / "a.vtu")
    assert np.array_equal(again.vertex_data["x"], mesh.points[:, 0]) and np.array_equal(again.face_data["n"], shape)
    assert np.array_equal(again.vertex_data["added"], mesh.is_steiner)
    assert again.edges.tolist() == [[0, 1]]
    quadloom.write_mesh(tmp_path / "b", mesh, "off")
    assert len(quadloom.read_mesh(tmp_path / "b", "off").quads) == len(mesh.quads)
    with pytest.raises(quadloom.Error):
        quadloom.require_mesh_format(tmp_path / "a.doc")


def test_points_come_back(tmp_path, towns):
    for given in (towns, np.column_stack([towns, towns[:, 1]])):
        for name in ("a.csv", "a.xyz"):
            quadloom.write_points(tmp_path / name, given)
            assert np.array_equal(quadloom.read_points(tmp_path / name), given)
    (tmp_path / "t.csv").write_text("name,lat,lon\na,1,2\nb,3,4\n")
    assert quadloom.read_points(tmp_path / "t.csv", columns="lon,lat").tolist() == [[2, 1], [4, 3]]
    (tmp_path / "bad.csv").write_text("x,y\n1,2\n1,two\n")
    with pytest.raises(quadloom.Error, match="two") as caught:
        quadloom.read_points(tmp_path / "bad.csv")
    assert (caught.value.code, caught.value.culprits) == ("parse", [3])


def test_polygons_come_back(tmp_path, lake):
    quadloom.write_polygons(tmp_path / "lake.geojson", lake)
    file = quadloom.read_planar(tmp_path / "lake.geojson")
    assert all(np.array_equal(a, b) for a, b in zip(file.polygons[0], lake, strict=True))
    from_file, from_rings = quadloom.quadrangulate_polygons(file), quadloom.quadrangulate_polygons(lake)
    assert np.array_equal(from_file.quads, from_rings.quads)
    assert quadloom.certify_polygons(from_file, file)
    with pytest.raises(quadloom.Error, match="already"):
        quadloom.quadrangulate_polygons(file, [[1, 1]])
    (tmp_path / "s.poly").write_text("4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 1\n1 1 2 7\n2 2 3 7\n3 3 4 7\n4 4 1 7\n0\n")
    square = quadloom.read_planar(tmp_path / "s.poly")
    assert square.segments.shape == (4, 2)
    assert len(quadloom.quadrangulate_polygons(square).quads) == 1


def test_strips_come_back(tmp_path, towns):
    triangles = quadloom.delaunay(towns)
    code = quadloom.encode_strips(triangles).code
    quadloom.write_strips(tmp_path / "a.strip", triangles.points, code)
    again = quadloom.read_strips(tmp_path / "a.strip")
    assert np.array_equal(again.points, triangles.points) and np.array_equal(again.code.index, code.index)


def test_lines_and_text(tmp_path, towns):
    quadloom.write_polylines(tmp_path / "a.geojson", [towns[:3], towns[3:7]], name="depth", values=[1, 2])
    assert '"depth"' in (tmp_path / "a.geojson").read_text()
    quadloom.write_text(tmp_path / "a.txt", "a line\n")
    assert (tmp_path / "a.txt").read_text() == "a line\n"


def test_pictures(tmp_path, mesh):
    mesh.draw(tmp_path / "a.svg", width=400, colour="convexity", title="A title", overlay=[mesh.points[:5, :2]])
    root = xml.etree.ElementTree.parse(tmp_path / "a.svg").getroot()
    assert root.tag.endswith("svg") and root.get("width", "").startswith("400")
    quadloom.draw_sheet(tmp_path / "b.png", [quadloom.Panel(mesh, title="one", width=300),
                                             quadloom.Panel(mesh, colour=quadloom.ColourBy.NONE, width=300)], 2)
    assert (tmp_path / "b.png").read_bytes().startswith(b"\x89PNG")
    group = np.arange(mesh.face_count) % 2
    quadloom.draw_mesh(tmp_path / "c.pdf", mesh, colour="group", group=group, group_names=["even", "odd"])
    assert (tmp_path / "c.pdf").read_bytes().startswith(b"%PDF")


def test_notebooks_show_a_picture(mesh):
    picture = mesh._repr_svg_()
    assert xml.etree.ElementTree.fromstring(picture).tag.endswith("svg")
    assert mesh._repr_png_() is None
    many = quadloom.quadrangulate_points(quadloom.generate_points("uniform", 6000))
    assert many._repr_svg_() is None and many._repr_png_().startswith(b"\x89PNG")
    for no_picture in (quadloom.PolygonMesh([[0, 0], [1, 1]]), quadloom.PolygonMesh([[0, 0], [1, 1]], [[0, 1, 2]]),
                       quadloom.PolygonMesh([[0, 0], [1, 1], [np.nan, 0]], [[0, 1, 2]])):
        assert no_picture._repr_svg_() is None
