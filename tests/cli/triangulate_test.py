"""quadloom triangulate: triangles in an order."""

import re

from harness import CommandLine, main

INNER = "0 0\n6 0\n6 6\n0 6\n1 1\n5 1\n5 5\n1 5\n3 3\n"
BAY = '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [2, 1], [0, 4], [0, 0]]]}'


def faces_of(path):
    return [tuple(map(int, line.split()[1:])) for line in path.read_text().splitlines()
            if line.startswith("f ")]


def share_an_edge(f, g):
    return len(set(f) & set(g)) == 2


class Order(CommandLine):
    def test_each_triangle_is_beside_the_one_before(self):
        self.write("p.xyz", INNER)
        for kind in ["hamiltonian-path", "serpentine"]:
            with self.subTest(kind):
                run = self.succeeds("triangulate", "p.xyz", "--kind", kind, "-o", "t.obj")
                self.assertIn("each triangle beside the one before", run.stdout)
                faces = faces_of(self.folder / "t.obj")
                self.assertEqual(len(faces), 12)
                self.assertTrue(all(map(share_an_edge, faces, faces[1:])))

    def test_the_order_is_in_the_file_and_in_the_picture(self):
        self.write("p.xyz", INNER)
        self.succeeds("triangulate", "p.xyz", "--kind", "serpentine", "-o", "t.vtu",
                      "--output-format", "vtu-ascii", "--picture", "t.svg")
        text = (self.folder / "t.vtu").read_text()
        order = re.search(r'Name="order"[^>]*>([^<]*)<', text)[1].split()
        self.assertEqual([float(x) for x in order], list(range(12)))
        self.succeeds("triangulate", "p.xyz", "-o", "d.obj", "--picture", "d.svg")
        plain, lined = ((self.folder / f).read_text() for f in ["d.svg", "t.svg"])
        self.assertGreater(lined.count("<path"), plain.count("<path"))

    def test_kinds_that_are_not_there(self):
        self.write("p.xyz", INNER)
        self.write("p.geojson", BAY)
        self.refuses(2, ["--kind", "'circle'", "serpentine"],
                     "triangulate", "p.xyz", "--kind", "circle", "-o", "t.obj")
        self.refuses(2, ["serpentine", "polygons", "delaunay"],
                     "triangulate", "p.geojson", "--kind", "serpentine", "-o", "t.obj")

class Cycle(CommandLine):
    def test_the_last_triangle_is_beside_the_first(self):
        self.write("p.xyz", INNER)
        self.succeeds("generate", "grid", "-n", "400", "-o", "g.xyz")
        for points, count in [("p.xyz", 12), ("g.xyz", 722)]:
            for splitter in ["random", "balanced"]:
                with self.subTest(points=points, splitter=splitter):
                    run = self.succeeds("triangulate", points, "--kind", "hamiltonian-cycle",
                                        "--splitter", splitter, "-o", "t.obj", "--picture", "t.svg")
                    self.assertIn("the first beside the last", run.stdout)
                    faces = faces_of(self.folder / "t.obj")
                    self.assertEqual(len(faces), count)
                    self.assertTrue(all(map(share_an_edge, faces, faces[1:] + faces[:1])))

    def test_the_seed_counts(self):
        self.succeeds("generate", "uniform", "-n", "50", "-o", "p.xyz")
        for name, seed in [("a.obj", 1), ("b.obj", 1), ("c.obj", 2)]:
            self.succeeds("triangulate", "p.xyz", "--kind", "hamiltonian-cycle", "--seed", seed,
                          "-o", name)
        a, b, c = (faces_of(self.folder / n) for n in ["a.obj", "b.obj", "c.obj"])
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)

    def test_none_is_an_answer(self):
        self.write("hull.xyz", "0 0\n1 0\n2 0\n1 2\n")
        self.refuses(4, ["none", "inside the hull", "hamiltonian-path"],
                     "triangulate", "hull.xyz", "--kind", "hamiltonian-cycle", "-o", "t.obj")
        self.write("pinwheel.xyz", "1 0\n3 1\n0 3\n1 1\n2 1\n1 2\n")
        self.refuses(4, ["none", "no triangulation", "hamiltonian-path"],
                     "triangulate", "pinwheel.xyz", "--kind", "hamiltonian-cycle", "-o", "t.obj")
        self.succeeds("triangulate", "pinwheel.xyz", "--kind", "hamiltonian-path", "-o", "t.obj")

    def test_splitters_are_for_cycles_of_points(self):
        self.write("p.xyz", INNER)
        self.refuses(2, ["--splitter", "hamiltonian-cycle"], "triangulate", "p.xyz", "--kind",
                     "serpentine", "--splitter", "balanced", "-o", "t.obj")
        self.refuses(2, ["--splitter", "'fair'", "balanced"], "triangulate", "p.xyz", "--kind",
                     "hamiltonian-cycle", "--splitter", "fair", "-o", "t.obj")


class Polygons(CommandLine):
    TEE = ('{"type": "Polygon", "coordinates": [[[0, 0, 9], [3, 0, 9], [3, 1, 9], [2, 1, 9], [2, 5, 9], '
           '[1, 5, 9], [1, 1, 9], [0, 1, 9], [0, 0, 9]]]}')
    FRAME = ('{"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], '
             '[[3, 3], [6, 3], [6, 6], [3, 6], [3, 3]]]}')

    def check_order(self, path, cycle=False):
        faces = faces_of(self.folder / path)
        self.assertTrue(all(map(share_an_edge, faces, faces[1:])))
        if cycle:
            self.assertTrue(share_an_edge(faces[-1], faces[0]))
        return faces

    def test_paths_and_sequences_without_added_points(self):
        self.write("p.geojson", BAY)
        for kind, words in [("hamiltonian-path", "beside the one before"), ("sequential", "by turns")]:
            with self.subTest(kind):
                run = self.succeeds("triangulate", "p.geojson", "--kind", kind, "-o", "t.obj")
                self.assertIn(words, run.stdout)
                self.assertNotIn("added", run.stdout)
                self.assertEqual(len(self.check_order("t.obj")), 3)

    def test_none_is_an_answer(self):
        self.write("p.geojson", self.TEE)
        for kind in ["hamiltonian-path", "hamiltonian-cycle", "sequential"]:
            with self.subTest(kind):
                self.refuses(4, ["none"], "triangulate", "p.geojson", "--kind", kind, "-o", "t.obj")
                self.assertFalse((self.folder / "t.obj").exists())

    def test_points_are_added_if_allowed(self):
        self.write("p.geojson", self.TEE)
        for kind in ["hamiltonian-path", "hamiltonian-cycle"]:
            with self.subTest(kind):
                run = self.succeeds("triangulate", "p.geojson", "--kind", kind, "--steiner", "allow",
                                    "-o", "t.obj", "--picture", "t.svg")
                self.assertIn("1 point added for 2 convex parts, the fewest", run.stdout)
                self.assertIn("certified", run.stdout)
                self.assertEqual(len(self.check_order("t.obj", kind == "hamiltonian-cycle")), 8)
                heights = re.findall(r"^v \S+ \S+ (\S+)$", (self.folder / "t.obj").read_text(), re.M)
                self.assertEqual(heights, ["9"] * 9)

    def test_no_points_are_added_where_none_are_needed(self):
        self.write("p.geojson", BAY)
        run = self.succeeds("triangulate", "p.geojson", "--kind", "hamiltonian-path", "--steiner",
                            "allow", "-o", "t.obj")
        self.assertNotIn("added", run.stdout)

    def test_holes(self):
        self.write("p.geojson", self.FRAME)
        for kind in ["hamiltonian-path", "hamiltonian-cycle", "sequential"]:
            self.refuses(3, ["holes"], "triangulate", "p.geojson", "--kind", kind, "-o", "t.obj")
        run = self.succeeds("triangulate", "p.geojson", "--kind", "hamiltonian-cycle", "--steiner",
                            "allow", "-o", "t.obj")
        self.assertIn("convex parts", run.stdout)
        self.check_order("t.obj", cycle=True)

    def test_one_polygon_alone(self):
        two = ('{"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [0, 1], [0, 0]]], '
               '[[[5, 5], [6, 5], [5, 6], [5, 5]]]]}')
        self.write("p.geojson", two)
        self.refuses(2, ["one polygon", "2 polygons"],
                     "triangulate", "p.geojson", "--kind", "hamiltonian-path", "-o", "t.obj")
        self.write("q.geojson", BAY)
        self.refuses(2, ["--steiner"], "triangulate", "q.geojson", "--kind", "sequential",
                     "--steiner", "allow", "-o", "t.obj")


if __name__ == "__main__":
    main()
