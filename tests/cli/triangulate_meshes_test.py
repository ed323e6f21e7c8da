"""quadloom triangulate of meshes, and sequential triangulations of points."""

import pathlib
import re

import independent_check
from harness import CommandLine, main
from meshes_test import grid, read_ply


def faces_of(path):
    return [tuple(map(int, line.split()[1:])) for line in path.read_text().splitlines()
            if line.startswith("f ")]


def share_an_edge(f, g):
    return len(set(f) & set(g)) == 2


def alternate(faces):
    """Whether one sequence of vertices goes through the triangles three at a time."""
    for start in [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]:
        s = [faces[0][i] for i in start]
        for f in faces[1:]:
            rest = set(f) - set(s[1:])
            if len(rest) != 1:
                break
            s = [*s[1:], *rest]
        else:
            return True
    return False


STRIP = "".join(f"v {i // 2} {i % 2} 0\n" for i in range(8)) + "".join(
    f"f {i + 1} {i + 3 - i % 2} {i + 2 + i % 2}\n" for i in [3, 0, 5, 1, 4, 2])
# A triangle with a triangle on each side, and one alone.
EARS = ("v 0 0 0\nv 4 0 0\nv 2 3 0\nv 2 -3 0\nv 5 3 0\nv -1 3 0\n"
        "f 1 2 3\nf 2 1 4\nf 3 2 5\nf 1 3 6\n")
APART = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0\nf 1 2 3\nf 4 5 6\nf 5 7 6\n"


class Meshes(CommandLine):
    def check_cycle(self, faces):
        self.assertTrue(all(map(share_an_edge, faces, [*faces[1:], faces[0]])))

    def test_a_point_in_each_triangle_makes_a_cycle(self):
        self.write("e.obj", EARS)
        run = self.succeeds("triangulate", "e.obj", "--kind", "hamiltonian-cycle", "-o", "c.obj",
                            "--picture", "c.svg")
        self.assertIn("4 points added, smallest angle", run.stdout)
        self.assertIn("the first beside the last", run.stdout)
        faces = faces_of(self.folder / "c.obj")
        self.assertEqual(len(faces), 12)
        self.check_cycle(faces)
        self.assertEqual(independent_check.check_mesh(self.folder / "c.obj", self.folder / "e.obj",
                                                      triangles=12), 4)

    def test_regions_and_data_are_carried_and_kept(self):
        self.write("g.ply", grid(4, regions=True))
        run = self.succeeds("triangulate", "g.ply", "--kind", "hamiltonian-cycle", "-o", "c.ply")
        self.assertIn("33 points added", run.stdout)  # the two regions hang on one midpoint
        self.assertIn("1 point on edges that stay", run.stdout)
        vertices, faces = read_ply(self.folder / "c.ply")
        self.assertEqual(len(faces), 3 * 32 + 2)
        self.assertEqual([f["order"] for f in faces], list(range(98)))
        self.check_cycle([f["corners"] for f in faces])
        for f in faces:
            corners = [vertices[v] for v in f["corners"]]
            self.assertTrue(all((v["x"] <= 2 if f["region"] == 1 else v["x"] >= 2) for v in corners))
            for v in corners:
                self.assertAlmostEqual(v["salt"], 10 + v["x"] + 3 * v["y"])

    def test_several_components_have_a_cycle_each(self):
        self.write("a.obj", APART)
        run = self.succeeds("triangulate", "a.obj", "--kind", "hamiltonian-cycle", "-o", "c.obj",
                            "--picture", "c.svg")
        self.assertIn("in each of 2 components", run.stdout)
        faces = faces_of(self.folder / "c.obj")
        self.check_cycle(faces[:3])
        self.check_cycle(faces[3:])

    def test_the_harbour(self):
        harbour = pathlib.Path(__file__).resolve().parents[2] / "examples/harbour/harbour.14"
        run = self.succeeds("triangulate", harbour, "--kind", "hamiltonian-cycle", "-o", "c.obj")
        after, before = map(float, re.search(r"smallest angle (\S+) degrees, (\S+) before",
                                             run.stdout).groups())
        self.assertGreaterEqual(after, before / 2)
        faces = faces_of(self.folder / "c.obj")
        self.assertEqual(len(faces), 3 * 670)
        self.check_cycle(faces)
        run = self.succeeds("triangulate", harbour, "--kind", "hamiltonian-path", "-o", "p.obj")
        self.assertIn("670 triangles", run.stdout)

    def test_orders_without_a_change(self):
        self.write("s.obj", STRIP)
        for kind, words in [("hamiltonian-path", "beside the one before"), ("sequential", "by turns")]:
            with self.subTest(kind):
                run = self.succeeds("triangulate", "s.obj", "--kind", kind, "-o", "o.obj")
                self.assertIn(words, run.stdout)
                self.assertIn("8 points, 6 triangles", run.stdout)
                faces = faces_of(self.folder / "o.obj")
                self.assertEqual(sorted(map(sorted, faces)),
                                 sorted(map(sorted, faces_of(self.folder / "s.obj"))))
                self.assertTrue(all(map(share_an_edge, faces, faces[1:])))
        self.assertTrue(alternate(faces))
        self.succeeds("generate", "uniform", "-n", 60, "-o", "p.xyz")
        self.succeeds("triangulate", "p.xyz", "-o", "d.obj")
        self.succeeds("triangulate", "d.obj", "--kind", "hamiltonian-path", "-o", "o.obj")
        self.assertEqual(independent_check.check_mesh(self.folder / "o.obj", self.folder / "d.obj",
                                                      triangles=200), 0)
        faces = faces_of(self.folder / "o.obj")
        self.assertTrue(all(map(share_an_edge, faces, faces[1:])))

    def test_none_and_unknown_are_answers_of_their_own(self):
        self.write("e.obj", EARS)
        self.write("a.obj", APART)
        self.write("g.ply", grid(4))
        self.succeeds("generate", "uniform", "-n", 60, "-o", "p.xyz")
        self.succeeds("triangulate", "p.xyz", "-o", "d.obj")
        none = [("e.obj", "hamiltonian-path", "3 triangles with one neighbour"),
                ("e.obj", "hamiltonian-cycle", "--steiner allow"),
                ("e.obj", "sequential", "sequential"), ("a.obj", "hamiltonian-path", "2 components"),
                ("g.ply", "hamiltonian-path", "by exhaustion")]
        for file, kind, words in none:
            with self.subTest(file + " " + kind):
                self.refuses(4, ["none: ", words], "triangulate", file, "--kind", kind, "--steiner", "none",
                             "-o", "o.obj")
        self.refuses(4, ["unknown: ", "--limit"], "triangulate", "d.obj", "--kind", "hamiltonian-path",
                     "--limit", 5, "-o", "o.obj")

    def test_wrong_options(self):
        self.write("s.obj", STRIP)
        self.write("p.xyz", "0 0\n4 0\n0 4\n1 1\n")
        self.refuses(2, ["is a mesh already", "sequential"], "triangulate", "s.obj", "-o", "o.obj")
        self.refuses(2, ["--steiner allow"], "triangulate", "s.obj", "--kind", "sequential",
                     "--steiner", "allow", "-o", "o.obj")
        self.refuses(2, ["--keep", "meshes"], "triangulate", "p.xyz", "--keep", "none", "-o", "o.obj")
        self.refuses(2, ["--limit"], "triangulate", "s.obj", "--limit", "0", "-o", "o.obj")


class Points(CommandLine):
    def test_sequential(self):
        self.write("p.xyz", "0 0\n6 0\n7 4\n3 8\n-1 4\n2 2\n3 4\n4 3\n")
        run = self.succeeds("triangulate", "p.xyz", "--kind", "sequential", "-o", "s.obj")
        self.assertIn("turning left and right by turns", run.stdout)
        faces = faces_of(self.folder / "s.obj")
        self.assertEqual(len(faces), 2 * 8 - 2 - 5)
        self.assertTrue(alternate(faces))

    def test_none_and_unknown(self):
        self.succeeds("generate", "ahms-nine", "-n", 9, "-o", "nine.xyz")
        self.refuses(4, ["none: "], "triangulate", "nine.xyz", "--kind", "sequential", "-o", "s.obj")
        self.refuses(4, ["unknown: ", "--limit"], "triangulate", "nine.xyz", "--kind", "sequential",
                     "--limit", 3, "-o", "s.obj")
        self.succeeds("generate", "uniform", "-n", 50, "-o", "many.xyz")
        self.refuses(4, ["unknown: ", "32 points"], "triangulate", "many.xyz", "--kind", "sequential",
                     "-o", "s.obj")


if __name__ == "__main__":
    main()
