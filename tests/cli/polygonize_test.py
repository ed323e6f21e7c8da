"""quadloom polygonize."""

import json

from harness import SQUARE, CommandLine, main, read_xyz

GRID = "".join(f"{x} {y}\n" for x in range(5) for y in range(4))


def twice_area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))


def reflex_chains(ring):
    turns = []
    for i, b in enumerate(ring):
        a, c = ring[i - 1], ring[(i + 1) % len(ring)]
        turn = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        if turn != 0:
            turns.append(turn < 0)
    return sum(here and not before for before, here in zip(turns[-1:] + turns, turns))


class Polygonize(CommandLine):
    def ring(self, name):
        features = json.loads((self.folder / name).read_text())["features"]
        self.assertEqual([f["geometry"]["type"] for f in features], ["Polygon"])
        ring = [tuple(p) for p in features[0]["geometry"]["coordinates"][0]]
        self.assertEqual(ring[0], ring[-1])
        return ring[:-1]

    def test_every_point_is_a_corner(self):
        for text in [SQUARE, GRID, "0 0\n4 0\n2 1\n", "0 0\n2 0\n0 1\n1 1\n0 2\n"]:
            with self.subTest(text):
                self.write("p.xyz", text)
                run = self.succeeds("polygonize", "p.xyz", "-o", "s.geojson")
                self.assertIn("certified", run.stdout)
                ring = self.ring("s.geojson")
                points = read_xyz(self.folder / "p.xyz")
                self.assertEqual(sorted(ring), sorted(points))
                self.assertGreater(twice_area(ring), 0)
                self.assertLessEqual(reflex_chains(ring), 1)
                self.succeeds("triangulate", "s.geojson", "--input", "polygons", "-o", "t.obj")

    def test_triangles_and_picture(self):
        self.succeeds("generate", "uniform", "-n", "60", "--seed", "3", "-o", "p.xyz")
        run = self.succeeds("polygonize", "p.xyz", "-o", "s.geojson", "--triangles", "t.obj",
                            "--picture", "s.svg")
        self.assertRegex(run.stdout, r"^60 points, \d+ reflex corners, 0 flat corners, ")
        self.assertIn("each beside the one before", run.stdout)
        faces = [set(line.split()[1:]) for line in (self.folder / "t.obj").read_text().splitlines()
                 if line.startswith("f ")]
        self.assertEqual(len(faces), 58)
        self.assertTrue(all(len(f & g) == 2 for f, g in zip(faces, faces[1:])))
        self.assertIn("<svg", (self.folder / "s.svg").read_text())

    def test_heights_go_to_the_triangles(self):
        self.write("p.csv", "x,y,z\n0,0,5\n4,0,6\n1,3,7\n1,1,8\n")
        self.succeeds("polygonize", "p.csv", "-o", "s.geojson", "--triangles", "t.obj")
        heights = [line.split()[3] for line in (self.folder / "t.obj").read_text().splitlines()
                   if line.startswith("v ")]
        self.assertEqual(heights, ["5", "6", "7", "8"])

    def test_repeated_points_count_once(self):
        self.write("p.xyz", SQUARE + SQUARE)
        self.assertIn("6 points", self.succeeds("polygonize", "p.xyz", "-o", "s.geojson").stdout)

    def test_standard_output(self):
        run = self.succeeds("polygonize", "-", "-o", "-", stdin=SQUARE)
        self.assertEqual(len(json.loads(run.stdout)["features"]), 1)
        self.assertIn("certified", run.stderr)

    def test_what_is_refused(self):
        self.write("p.xyz", SQUARE)
        self.write("line.xyz", "0 0\n1 1\n2 2\n")
        self.write("two.xyz", "0 0\n1 1\n0 0\n")
        self.refuses(3, ["line"], "polygonize", "line.xyz", "-o", "s.geojson")
        self.refuses(3, ["three"], "polygonize", "two.xyz", "-o", "s.geojson")
        self.refuses(3, ["gone.xyz"], "polygonize", "gone.xyz", "-o", "s.geojson")
        self.refuses(2, ["--output"], "polygonize", "p.xyz")
        self.refuses(2, ["s.geojson"], "polygonize", "p.xyz", "-o", "s.geojson", "--triangles",
                     "s.geojson")
        self.refuses(2, ["t.xyz"], "polygonize", "p.xyz", "-o", "s.geojson", "--triangles", "t.xyz")
        self.refuses(2, ["s.jpg"], "polygonize", "p.xyz", "-o", "s.geojson", "--picture", "s.jpg")
        self.refuses(3, ["no/s.geojson"], "polygonize", "p.xyz", "-o", "no/s.geojson")


if __name__ == "__main__":
    main()
