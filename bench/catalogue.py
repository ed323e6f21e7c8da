"""What bench/compare measures: the tables, their rows (a task of a program) and their inputs."""
import dataclasses

UNIFORM = [("uniform", 10**k) for k in (4, 5, 6, 7)]
OTHERS = [("clusters", 10**6), ("grid", 10**6)]
HARD = [("circle", 10**5), ("lines", 10**5)]
LARGE = tuple(f"quadloom {task}" for task in ("delaunay", "quads", "quads@2", "convex", "convex@2"))
TOWNS = [("towns", 7241), ("cities", 135233)]


@dataclasses.dataclass(frozen=True)
class Row:
    program: str
    task: str
    label: str
    unit: str = ""   # the key of the row that it is compared with; empty: the table's
    judge: str = ""  # what bench/judge is asked about the result; empty: nothing
    agree: str = ""  # the figure that must be that of the unit

    @property
    def key(self):
        return f"{self.program} {self.task}"


@dataclasses.dataclass(frozen=True)
class Table:
    name: str
    title: str
    unit: str     # the key of a row
    files: tuple  # what make_inputs makes beside the points
    rows: list
    inputs: list  # (kind, points), or (kind, points, keys of the rows)

    def row(self, key):
        return next(row for row in self.rows if row.key == key)

    def unit_of(self, row):
        return row.unit or self.unit


TABLES = [
    Table("delaunay", "Delaunay", "CGAL delaunay", (), [
        Row("quadloom", "delaunay", "Quadloom", judge="delaunay"),
        Row("quadloom", "delaunay@2", "Quadloom, 2 threads", judge="delaunay"),
        Row("CGAL", "delaunay", "CGAL", judge="delaunay"),
        Row("delaunator", "delaunay", "delaunator", judge="delaunay"),
    ], UNIFORM + OTHERS + HARD + TOWNS),
    Table("constrained", "constrained Delaunay", "CGAL constrained", ("segments",), [
        Row("quadloom", "constrained", "Quadloom", judge="constrained"),
        Row("CGAL", "constrained", "CGAL", judge="constrained"),
    ], [("uniform", 10**4), ("uniform", 10**5), ("uniform", 10**6), ("clusters", 10**6)]),
    Table("quads", "quads of points", "quadloom delaunay", (), [
        Row("quadloom", "delaunay", "Delaunay triangulation: the unit"),
        Row("quadloom", "quads", "quads, the [default](algorithms/delaunay.md)", judge="quads"),
        Row("quadloom", "quads@2", "the same, 2 threads"),
        Row("quadloom", "convex", "strictly convex quads, [`--convex`](algorithms/convex.md)", judge="quads"),
        Row("quadloom", "convex@2", "the same, 2 threads"),
        Row("quadloom", "spiral", "quads of the [spiral](algorithms/spiral.md)", judge="quads"),
        Row("quadloom", "cycle-random", "[Hamiltonian cycle](algorithms/hamiltonian.md), random splitters", judge="cycle"),
        Row("quadloom", "cycle-balanced", "Hamiltonian cycle, balanced splitters", judge="cycle"),
        Row("quadloom", "spiral-polygon", "[spiral polygon](algorithms/spiral-polygon.md)", judge="polygon"),
        Row("quadloom", "certify", "[certify](algorithms/certify.md) the default quads"),
        Row("quadloom", "certify@2", "the same, 2 threads"),
    ], UNIFORM[:3] + [("uniform", 10**7, LARGE)] + OTHERS + TOWNS),
    Table("matchings", "matching", "LEMON cardinality", ("dual",), [
        Row("quadloom", "greedy", "pairs by shape, greedy"),
        Row("quadloom", "near", "near-optimal, of the greatest size"),
        Row("quadloom", "cardinality", "the greatest size", agree="pairs"),
        Row("LEMON", "cardinality", "LEMON, the greatest size"),
        Row("Boost.Graph", "cardinality", "Boost.Graph, the greatest size", agree="pairs"),
        Row("quadloom", "weight", "the greatest weight", unit="LEMON weight", agree="weight"),
        Row("LEMON", "weight", "LEMON, the greatest weight", unit="LEMON weight"),
        Row("Boost.Graph", "weight", "Boost.Graph, the greatest weight", unit="LEMON weight", agree="weight"),
        Row("quadloom", "perfect", "the greatest weight of the greatest size", unit="LEMON perfect", agree="weight"),
        Row("LEMON", "perfect", "LEMON, the greatest weight of perfect ones", unit="LEMON perfect"),
    ], UNIFORM[:3] + OTHERS[1:]),
    Table("recombination", "quads of triangles", "Gmsh blossom-no-topology", ("triangles",), [
        Row("Gmsh", "simple", "Gmsh simple", judge="quads"),
        Row("Gmsh", "blossom", "Gmsh blossom, default", judge="quads"),
        Row("Gmsh", "blossom-no-topology", "Gmsh blossom, no topological changes: the unit", judge="quads"),
        Row("Gmsh", "blossom-all-pairs", "Gmsh blossom, the same and minimum quality 0", judge="quads"),
        Row("quadloom", "pair-triangles", "Quadloom `pair --leftover triangle`", judge="quads"),
        Row("quadloom", "pair", "Quadloom `pair`, default", judge="quads"),
        Row("quadloom", "pair-exact", "Quadloom `pair`, exact weight", judge="quads"),
        Row("quadloom", "pair-convex", "Quadloom `--convex`", judge="quads"),
    ], UNIFORM[:3] + TOWNS[1:]),
    Table("strips", "strips", "meshoptimizer restart", ("triangles",), [
        Row("meshoptimizer", "restart", "meshoptimizer: the unit", judge="restart"),
        Row("quadloom", "restart-fast", "Quadloom, fast", judge="restart"),
        Row("quadloom", "restart", "Quadloom, standard", judge="restart"),
        Row("quadloom", "restart-thorough", "Quadloom, thorough", judge="restart"),
        Row("meshoptimizer", "repeat", "meshoptimizer, repeated vertices", unit="meshoptimizer repeat", judge="repeat"),
        Row("quadloom", "repeat", "Quadloom, repeated vertices, standard", unit="meshoptimizer repeat", judge="repeat"),
    ], UNIFORM[1:3] + OTHERS[1:] + TOWNS[:1]),
    Table("files", "files", "quadloom quads", (), [
        Row("quadloom", "quads", "quads in memory, the default: the unit"),
        *(Row("quadloom", f"{verb}-points.{ending}", f"{verb} points, .{ending}")
          for ending in ("xyz", "csv") for verb in ("read", "write")),
        *(Row("quadloom", f"{verb}-mesh.{ending}", f"{verb} quads, .{ending}")
          for ending in ("obj", "ply", "vtu", "msh") for verb in ("read", "write")),
    ], UNIFORM[1:3]),
]
