"""quadloom quadrangulate: counts, outputs, heights, standard streams; judged independently."""

import json
import random

import independent_check
from harness import SQUARE, TRIANGLE, CommandLine, main, read_xyz

METHODS = ["delaunay", "spiral", "insertion"]


class Quadrangulate(CommandLine):
    def judge(self, mesh, points, **limits):
        return independent_check.check(self.folder / mesh, read_xyz(self.folder / points), **limits)

    def test_even_hull_needs_no_point(self):
        self.write("p.xyz", SQUARE)
        for method in METHODS:
            with self.subTest(method):
                run = self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--method", method)
                self.assertEqual(self.judge("m.obj", "p.xyz"), 0)
                self.assertIn("6 points, 3 quads, no triangle, no point added", run.stdout)
                self.assertIn("certified", run.stdout)

    def test_odd_hull(self):
        self.write("p.xyz", TRIANGLE)
        for method in METHODS:
            for where, added, triangles in [("outside", 1, 0), ("on-edge", 1, 0), ("triangle", 0, 1)]:
                with self.subTest(method=method, where=where):
                    run = self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--method", method,
                                        "--odd-boundary", where)
                    self.assertEqual(self.judge("m.obj", "p.xyz", triangles=triangles), added)
                    self.assertIn("1 triangle" if triangles else "no triangle", run.stdout)

    def test_subdivide_is_strictly_convex(self):
        self.write("p.xyz", TRIANGLE)
        run = self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--method", "subdivide")
        self.assertIn("9 quads", run.stdout)
        self.assertIn("100% strictly convex", run.stdout)
        self.assertEqual(self.judge("m.obj", "p.xyz"), 9)  # 6 edges and 3 triangles
        self.succeeds("check", "m.obj", "--points", "p.xyz", "--strictly-convex")

    def test_more_corners(self):
        self.succeeds("generate", "uniform", "-n", "40", "-o", "p.xyz", "--seed", "3")
        for k in [5, 6, 7, 12]:
            with self.subTest(k):
                self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--k", k)
                self.assertLessEqual(self.judge("m.obj", "p.xyz", corners=k), k - 3)

    def test_more_points_than_the_bound_for_k_corners_are_no_success(self):
        for seed in range(80, 95):
            rng = random.Random(seed)
            self.write("p.xyz", "".join(f"{rng.randrange(1000)} {rng.randrange(1000)}\n"
                                        for _ in range(15)))
            with self.subTest(seed=seed):
                run = self.run_app("quadrangulate", "p.xyz", "-o", "m.obj", "--k", 12)
                added = self.judge("m.obj", "p.xyz", corners=12)
                self.assertEqual(run.returncode, 0 if added <= 9 else 4, run.stderr)
                self.assertEqual("the bound for 12-gons is 9" in run.stderr, added > 9)

    def test_generated_sets(self):
        for kind in ["uniform", "grid", "rotated-grid", "lines", "cross", "near-line", "cocircular",
                     "decades", "duplicates", "two-clusters", "bhrs-line", "bhrs-ring"]:
            self.succeeds("generate", kind, "-n", "60", "-o", "p.xyz", "--seed", "5")
            for method in METHODS:
                with self.subTest(kind=kind, method=method):
                    self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--method", method)
                    self.assertLessEqual(self.judge("m.obj", "p.xyz"), 1)

    def test_random_sets(self):
        for seed in range(20):
            rng = random.Random(seed)
            points = {(rng.randrange(8), rng.randrange(8)) for _ in range(25)} | {(0, 0), (1, 0), (0, 1)}
            self.write("p.xyz", "".join(f"{x} {y}\n" for x, y in sorted(points)))
            with self.subTest(seed=seed):
                self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--odd-boundary", "triangle")
                self.assertEqual(self.judge("m.obj", "p.xyz", triangles=1), 0)

    def test_repeated_points_are_merged_and_said(self):
        self.write("p.xyz", SQUARE + "0 0\n2 2\n")
        run = self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj")
        self.assertIn("2 points repeated, merged", run.stdout)
        self.assertEqual(self.judge("m.obj", "p.xyz"), 0)

    def test_every_format_passes_the_check(self):
        self.write("p.xyz", TRIANGLE)
        for name in ["m.obj", "m.off", "m.ply", "m.vtu", "m.msh", "m.geojson"]:
            with self.subTest(name):
                self.succeeds("quadrangulate", "p.xyz", "-o", name)
                self.succeeds("check", name, "--points", "p.xyz", "--steiner-at-most", "1")
        self.succeeds("quadrangulate", "p.xyz", "-o", "old.msh", "--output-format", "msh22")
        self.assertTrue((self.folder / "old.msh").read_text().startswith("$MeshFormat\n2.2 "))
        self.succeeds("check", "old.msh", "--points", "p.xyz", "--steiner-at-most", "1")

    def test_standard_input_and_output(self):
        self.write("p.xyz", SQUARE)
        run = self.succeeds("quadrangulate", "-", "-o", "-", "--output-format", "obj", stdin=SQUARE)
        self.assertIn("certified", run.stderr)
        self.write("m.obj", run.stdout)
        self.assertEqual(self.judge("m.obj", "p.xyz"), 0)
        self.assertEqual(self.files(), ["m.obj", "p.xyz"])

    def test_quiet(self):
        self.write("p.xyz", SQUARE)
        run = self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--quiet")
        self.assertEqual((run.stdout, run.stderr), ("", ""))

    def test_heights_are_carried(self):
        self.write("p.csv", "z,name,x,y\n1,a,0,0\n5,b,4,0\n9,c,0,4\n3,d,1,1\n")
        for where in ["outside", "on-edge"]:
            with self.subTest(where):
                self.succeeds("quadrangulate", "p.csv", "-o", "m.obj", "--odd-boundary", where)
                lines = (self.folder / "m.obj").read_text().splitlines()
                v = [tuple(map(float, l.split()[1:4])) for l in lines if l.startswith("v ")]
                self.assertEqual(v[:4], [(0, 0, 1), (4, 0, 5), (0, 4, 9), (1, 1, 3)])
                x, y, z = v[4]
                if where == "on-edge":  # the three corners are on z = 1 + x + 2 y
                    self.assertAlmostEqual(z, 1 + x + 2 * y, places=12)
                self.assertTrue(1 <= z <= 9)

    def test_report_and_picture(self):
        self.write("p.xyz", TRIANGLE)
        self.succeeds("quadrangulate", "p.xyz", "-o", "m.obj", "--report", "r.json", "--picture",
                      "m.png")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["input"], {"path": "p.xyz", "points": 4})
        mesh = report["mesh"]
        self.assertEqual((mesh["method"], mesh["hull_points"], mesh["added_points"]),
                         ("delaunay", 3, 1))
        self.assertTrue(mesh["certificate"]["ok"])
        self.assertEqual(mesh["quality"]["quads"], mesh["certificate"]["faces"])
        self.assertFalse(mesh["fell_back_to_spiral"])
        self.assertEqual((self.folder / "m.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_the_same_bytes_every_time(self):
        self.succeeds("generate", "clusters", "-n", "500", "-o", "p.xyz")
        for name in ["a.vtu", "b.vtu"]:
            self.succeeds("quadrangulate", "p.xyz", "-o", name, "--seed", "9")
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())


if __name__ == "__main__":
    main()
