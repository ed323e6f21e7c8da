"""quadloom generate, layers and compare."""

import json

from harness import SQUARE, CommandLine, main, read_xyz

NESTED = "0 0\n6 0\n6 6\n0 6\n1 1\n5 1\n5 5\n1 5\n3 3\n"


class Generate(CommandLine):
    def test_counts_and_seeds(self):
        for name, seed in [("a.xyz", 1), ("b.xyz", 1), ("c.xyz", 2)]:
            self.succeeds("generate", "uniform", "-n", "100", "-o", name, "--seed", seed)
        a, b, c = ((self.folder / n).read_text() for n in ["a.xyz", "b.xyz", "c.xyz"])
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)
        self.assertEqual(len(read_xyz(self.folder / "a.xyz")), 100)

    def test_every_kind_in_the_help_works(self):
        text = self.succeeds("generate", "--help").stdout
        kinds = text[text.index("\nPoints:"):].strip().split("\n\n")[0].splitlines()[1:]
        self.assertGreater(len(kinds), 20)
        for line in kinds:
            kind = line.split()[0]
            with self.subTest(kind):
                self.succeeds("generate", kind, "-n", "30", "-o", "p.xyz")
                self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj")

    def test_a_count_that_the_kind_cannot_have_is_said(self):
        run = self.succeeds("generate", "grid", "-n", "101", "-o", "p.xyz")
        self.assertIn("100 points", run.stderr)

    def test_formats(self):
        for name in ["p.xyz", "p.csv", "p.geojson"]:
            self.succeeds("generate", "gaussian", "-n", "50", "-o", name)
            self.succeeds("quadrangulate", name, "-o", name + ".obj")
        meshes = [(self.folder / f"{n}.obj").read_bytes() for n in ["p.xyz", "p.csv", "p.geojson"]]
        self.assertEqual(len(set(meshes)), 1)  # the coordinates are the same bit for bit

    def test_pipe(self):
        points = self.succeeds("generate", "circle", "-n", "20", "-o", "-").stdout
        run = self.succeeds("quadrangulate", "-", "-o", "m.obj", stdin=points)
        self.assertIn("20 points, 9 quads", run.stdout)


class Layers(CommandLine):
    def test_nested_squares(self):
        self.write("p.xyz", NESTED)
        run = self.succeeds("layers", "p.xyz", "-o", "l.geojson", "--spiral", "s.geojson",
                            "--picture", "l.svg")
        self.assertIn("9 points, 3 convex layers, 4 on the hull", run.stdout)
        features = json.loads((self.folder / "l.geojson").read_text())["features"]
        self.assertEqual([f["properties"]["depth"] for f in features], [0, 1, 2])
        self.assertEqual([f["geometry"]["type"] for f in features[:2]], ["Polygon", "Polygon"])
        ring = features[0]["geometry"]["coordinates"][0]
        self.assertEqual(len(ring), 5)
        self.assertEqual(ring[0], ring[-1])
        spiral = json.loads((self.folder / "s.geojson").read_text())["features"]
        path = [tuple(p) for p in spiral[0]["geometry"]["coordinates"]]
        self.assertEqual(len(path), 9)
        self.assertEqual(set(path), set(read_xyz(self.folder / "p.xyz")))
        self.assertEqual(path[0], (0, 0))
        self.assertIn("<svg", (self.folder / "l.svg").read_text())

    def test_inner_segment(self):
        self.write("p.xyz", "0 0\n6 0\n6 6\n0 6\n2 3\n3 3\n4 3\n")
        self.succeeds("layers", "p.xyz", "-o", "l.geojson")
        features = json.loads((self.folder / "l.geojson").read_text())["features"]
        self.assertEqual(features[1]["geometry"]["type"], "LineString")
        self.assertEqual(len(features[1]["geometry"]["coordinates"]), 3)


class Compare(CommandLine):
    def test_table_report_and_sheet(self):
        self.succeeds("generate", "uniform", "-n", "200", "-o", "p.xyz")
        run = self.succeeds("compare", "p.xyz", "--report", "r.json", "--picture", "s.png")
        lines = run.stdout.splitlines()
        self.assertEqual(lines[0].split(), ["delaunay", "insertion", "spiral", "subdivide"])
        rows = {line[:18].strip(): line[18:].split() for line in lines[1:]}
        self.assertEqual(rows["certified"], ["yes"] * 4)
        self.assertEqual(rows["strictly convex"][3], "100%")
        meshes = json.loads((self.folder / "r.json").read_text())["meshes"]
        self.assertEqual([m["method"] for m in meshes], lines[0].split())
        shape = {m["method"]: m["quality"]["mean_shape"] for m in meshes}
        self.assertGreater(shape["delaunay"], shape["spiral"])
        for m in meshes:
            self.assertEqual(str(m["quality"]["quads"]), rows["quads"][meshes.index(m)])
        self.assertTrue((self.folder / "s.png").stat().st_size > 10000)

    def test_odd_boundary(self):
        self.write("p.xyz", "0 0\n4 0\n0 4\n1 1\n")
        run = self.succeeds("compare", "p.xyz", "--odd-boundary", "triangle")
        rows = {line[:18].strip(): line[18:].split() for line in run.stdout.splitlines()[1:]}
        self.assertEqual(rows["triangles"], ["1", "1", "1", "0"])
        self.assertEqual(rows["added points"][:3], ["0", "0", "0"])


if __name__ == "__main__":
    main()
