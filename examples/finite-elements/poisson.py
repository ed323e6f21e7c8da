"""Poisson's equation on strictly convex quads with scikit-fem, and the order in which the error falls with the mesh size.

Needs scikit-fem beside the package (pip install scikit-fem), and the extra `plot` for the picture. Prints tables;
`python poisson.py picture.png` draws two coarse meshes with their solutions instead.
"""
import sys

import numpy as np
import scipy.stats
import skfem
from skfem.helpers import dot, grad

import quadloom


# ---- The problem: -laplace(u) = f, u known on the boundary. ----

def u(x, y):
    return np.sin(3 * x) * np.cos(2 * y)


def gradient_of_u(x, y):
    return np.array([3 * np.cos(3 * x) * np.cos(2 * y), -2 * np.sin(3 * x) * np.sin(2 * y)])


@skfem.BilinearForm
def stiffness(v, w, _):
    return dot(grad(v), grad(w))


@skfem.LinearForm
def load(v, at):
    return 13 * u(*at.x) * v


@skfem.Functional
def squared_error(at):
    return (at["solution"] - u(*at.x)) ** 2


@skfem.Functional
def squared_error_of_gradient(at):
    return np.sum((at["solution"].grad - gradient_of_u(*at.x)) ** 2, axis=0)


def solve(mesh):
    """The solution at the vertices, and its errors in L2 and in the H1 seminorm."""
    quads = skfem.MeshQuad(mesh.points.T.copy(), mesh.quads.T.astype(np.int64, order="C"))
    basis = skfem.Basis(quads, skfem.ElementQuad1(), intorder=5)
    boundary = basis.get_dofs()
    known = u(*basis.doflocs)
    solution = skfem.solve(*skfem.condense(stiffness.assemble(basis), load.assemble(basis), x=known, D=boundary))
    at = basis.interpolate(solution)
    return solution, *(np.sqrt(f.assemble(basis, solution=at)) for f in (squared_error, squared_error_of_gradient))


# ---- The meshes. ----

def scattered(n, seed):
    """About n points, each anywhere in its own cell of a grid over the unit square, and its border cut evenly: strictly
    convex quads."""
    k = round(np.sqrt(n))
    cells = np.indices((k - 1, k - 1)).reshape(2, -1).T
    inner = (cells + 0.5 + np.random.default_rng(seed).random(cells.shape)) / k
    side = np.column_stack([np.arange(k) / k, np.zeros(k)])
    border = [side, side[:, ::-1] + [1, 0], 1 - side, 1 - side[:, ::-1] - [1, 0]]
    return quadloom.convex_quadrangulation(np.concatenate([*border, inner]))


def coast(h, seed):
    """A bay with a wiggly coast in the north: triangles of size h at the coast, growing seawards, to strictly convex
    quads."""
    def size(points):
        return h * (1 + 2 * np.maximum(0, 0.6 - points[..., 1]))

    ring = shore(size)
    inner = graded_points(size, np.random.default_rng(seed))
    distance = np.min([np.hypot(*(inner - corner).T) for corner in ring], axis=0)
    triangles = quadloom.constrained_delaunay(ring, inner[distance > 0.7 * size(inner)])
    return quadloom.convex_quadrangulation(triangles)


def shore(size):
    """The bay as a ring of corners, an even number, whose distances are about size(there)."""
    angle = np.linspace(0, 2 * np.pi, 20001)
    wiggle = (0.09 * np.sin(9 * angle) + 0.03 * np.sin(31 * angle + 1)) * np.sqrt(np.maximum(0, np.sin(angle)))
    curve = ((1 + wiggle) * [np.cos(angle), np.sin(angle)]).T
    along = np.cumsum(np.hypot(*np.diff(curve, axis=0, prepend=curve[:1]).T) / size(curve))
    stops = np.linspace(0, along[-1], 2 * round(along[-1] / 2), endpoint=False)
    return np.column_stack([np.interp(stops, along, curve[:, i]) for i in (0, 1)])


def graded_points(size, random):
    """A point in each square of a quadtree over [-1.2, 1.2]^2 whose squares are as large as size(centre) at most."""
    centres, side, points = np.zeros((1, 2)), 2.4, []
    while len(centres) > 0:
        small = side <= size(centres)
        points.append(centres[small] + side * random.uniform(-0.4, 0.4, (small.sum(), 2)))
        side /= 2
        centres = (centres[~small, None] + side / 2 * np.array([[-1, -1], [1, -1], [-1, 1], [1, 1]])).reshape(-1, 2)
    return np.concatenate(points)


SERIES = {"scattered points": (scattered, [1000 * 2**i for i in range(6)]),
          "coast": (coast, [0.16 / 2**i for i in range(5)])}
REPEATS = 3


# ---- The order. ----

def measure(make, parameters):
    """Per mesh, REPEATS for each parameter: quads, added points, mesh size, error in L2, error in H1."""
    rows = []
    for parameter in parameters:
        for seed in range(REPEATS):
            mesh = make(parameter, seed)
            assert quadloom.measure_quality(mesh).strictly_convex == mesh.face_count
            rows.append([mesh.face_count, mesh.is_steiner.sum(), mesh_size(mesh), *solve(mesh)[1:]])
    return np.array(rows)


def mesh_size(mesh):
    """The mean size of the quads: the side of a square of their mean area."""
    x, y = mesh.points[mesh.quads].transpose(2, 0, 1)
    areas = ((x[:, 2] - x[:, 0]) * (y[:, 3] - y[:, 1]) - (x[:, 3] - x[:, 1]) * (y[:, 2] - y[:, 0])) / 2
    return np.sqrt(areas.mean())


def order(sizes, errors):
    """The order of convergence by least squares, and its margin: it is within that with a confidence of 99.9%."""
    fit = scipy.stats.linregress(np.log(sizes), np.log(errors))
    return fit.slope, scipy.stats.t.ppf(0.9995, len(sizes) - 2) * fit.stderr


def table(name, rows):
    """One row for each parameter, the means of its meshes, and one for the orders."""
    lines = [f"| {name}: quads | added points | mesh size | error in L2 | in H1 |", "|--:|--:|--:|--:|--:|"]
    for quads, added, size, l2, h1 in rows.reshape(-1, REPEATS, rows.shape[1]).mean(axis=1):
        lines.append(f"| {quads:,.0f} | {added:.1f} | {size:.4f} | {l2:.2e} | {h1:.2e} |")
    orders = [f"{slope:.2f} ± {margin:.2f}" for slope, margin in (order(rows[:, 2], rows[:, k]) for k in (3, 4))]
    return "\n".join([*lines, f"| order | | | {orders[0]} | {orders[1]} |"])


def draw(path):
    """Coarse meshes with their solutions."""
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    for ax, name, mesh in zip(axes, SERIES, (scattered(500, 0), coast(0.08, 0))):
        figure.colorbar(mesh.plot(ax, colour=solve(mesh)[0]), ax=ax, shrink=0.8)
        ax.set_title(f"{name}: {mesh.face_count} quads")
        ax.set_axis_off()
    figure.savefig(path, dpi=80)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        draw(sys.argv[1])
    else:
        for title, series in SERIES.items():
            print(table(title, measure(*series)), end="\n\n")
