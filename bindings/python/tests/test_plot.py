"""Mesh.plot, by what it hands to Matplotlib and by what is to be seen."""
import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import quadloom  # noqa: E402


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


@pytest.fixture
def mesh():
    made = quadloom.convex_quadrangulation(np.random.default_rng(1).random((60, 2)), method="spiral")
    assert made.is_steiner.any()
    return made


def pixels(figure):
    figure.canvas.draw()
    return np.asarray(figure.canvas.buffer_rgba())[:, :, :3]


def test_the_quads_are_drawn_by_shape(mesh):
    figure, ax = plt.subplots()
    drawn = mesh.plot(ax)
    assert drawn.axes is ax and ax.get_aspect() == 1
    corners = [path.vertices[:4] for path in drawn.get_paths()]
    assert np.array_equal(corners, mesh.points[mesh.quads])
    assert np.array_equal(drawn.get_array(), quadloom.quad_shape(*mesh.points[mesh.quads].transpose(1, 0, 2)))
    assert drawn.get_clim() == (0, 1)
    box = np.array([mesh.points.min(axis=0), mesh.points.max(axis=0)])
    assert np.all(np.column_stack([ax.get_xlim(), ax.get_ylim()])[0] <= box[0])
    assert np.all(np.column_stack([ax.get_xlim(), ax.get_ylim()])[1] >= box[1])


def test_added_points_are_marked_and_may_be_left_out(mesh):
    figure, (a, b) = plt.subplots(1, 2)
    mesh.plot(a)
    assert np.array_equal(a.lines[0].get_xydata(), mesh.points[mesh.is_steiner])
    mesh.plot(b, added=False)
    assert len(b.lines) == 0


def test_the_current_axes_are_taken(mesh):
    figure, ax = plt.subplots()
    assert mesh.plot().axes is ax


def test_one_number_a_face(mesh):
    figure, ax = plt.subplots()
    values = np.arange(len(mesh.quads), dtype=float)
    drawn = mesh.plot(ax, colour=values, cmap="plasma")
    assert np.array_equal(drawn.get_array(), values) and drawn.cmap.name == "plasma"
    figure.colorbar(drawn)


def test_one_number_a_vertex_is_shaded(mesh):
    figure, ax = plt.subplots()
    drawn = mesh.plot(ax, colour=mesh.points[:, 0], cmap="gray", edges=False, added=False)
    figure.colorbar(drawn)
    seen = pixels(figure).astype(float)
    to_pixels = ax.transData.transform
    for quad in mesh.quads:
        x, y = mesh.points[quad].mean(axis=0)
        column, row = to_pixels((x, y))
        low, high = drawn.get_clim()
        assert seen[len(seen) - 1 - int(row), int(column), 0] == pytest.approx(255 * (x - low) / (high - low), abs=8)


def test_edges_are_drawn_over_the_shading_and_may_be_left_out(mesh):
    figure, (a, b) = plt.subplots(1, 2)
    mesh.plot(a, colour=mesh.points[:, 0])
    mesh.plot(b, colour=mesh.points[:, 0], edges=False)
    assert len(a.collections) == len(b.collections) + 1


def test_quads_that_are_not_convex_are_shaded_inside_alone():
    arrow = quadloom.PolygonMesh([(0, 0), (4, -4), (0, 8), (-4, -4)], [[0, 1, 2, 3]])
    figure, ax = plt.subplots()
    arrow.plot(ax, colour=[1, 1, 1, 1], edges=False)
    ax.set_axis_off()
    seen = pixels(figure)
    column, row = ax.transData.transform((0, -3))
    assert np.all(seen[len(seen) - 1 - int(row), int(column)] == 255)
    column, row = ax.transData.transform((0, 3))
    assert not np.all(seen[len(seen) - 1 - int(row), int(column)] == 255)


def test_faces_that_are_no_quads_are_grey():
    points = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 6)]
    drawn = quadloom.PolygonMesh(points, [[0, 1, 2, 3], [3, 2, 4]]).plot()
    drawn.update_scalarmappable()
    assert drawn.get_array().mask.tolist() == [False, True]
    assert matplotlib.colors.to_hex(drawn.get_facecolor()[1]) == "#b8b3bd"


def test_without_colours(mesh):
    assert mesh.plot(colour="none").get_array() is None
    assert mesh.plot(colour="none", edges=False, facecolors="red").get_facecolor().tolist() == [[1, 0, 0, 1]]


def test_a_mesh_without_faces_is_drawn():
    quadloom.PolygonMesh([(0, 0), (1, 0)]).plot()


@pytest.mark.parametrize("colour", ["size", [1, 2, 3]])
def test_wrong_colours_are_refused(mesh, colour):
    with pytest.raises(quadloom.Error, match="colour"):
        mesh.plot(colour=colour)
