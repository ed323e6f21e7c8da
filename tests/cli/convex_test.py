"""quadloom quadrangulate --convex: strictly convex quads of points, meshes and polygons, judged
independently; what cannot be mended is said; wrong use."""

import json
import random
import re

import independent_check
from harness import SQUARE, TRIANGLE, CommandLine, main, read_xyz

# A coast with a bay: a reflex corner, and a quad of its two triangles that is not convex.
ARROW = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"
# The same as region 1, and region 2, which with it makes a square; z is 1 + x + 2 y.
REGIONS = """ply
format ascii 1.0
element vertex 5
property double x
property double y
property double z
element face 4
property list uchar uint vertex_indices
property double region
end_header
0 0 1
4 0 5
1 1 4
0 4 9
4 4 13
3 0 1 2 1
3 0 2 3 1
3 1 4 2 2
3 2 4 3 2
"""
LAKE = json.dumps({"type": "Polygon", "coordinates": [
    [[0, 0], [3, 1], [4, -1], [6, 2], [9, 0], [8, 3], [11, 4], [8, 5], [10, 8], [7, 6], [6, 9], [5, 6],
     [2, 8], [3, 5], [0, 6], [2, 3], [0, 0]], [[5, 3], [5, 4], [6, 4], [6, 3], [5, 3]]]})


class Convex(CommandLine):
    def convert(self, source, *options, output="m.obj"):
        return self.succeeds("quadrangulate", source, "--convex", "-o", output, *options)

    def require_convex(self, mesh="m.obj"):
        vertices, faces = independent_check.read_obj(self.folder / mesh)
        at = [tuple(map(independent_check.Fraction, v)) for v in vertices]
        for f in faces:
            for a, b, c in zip(f, f[1:] + f[:1], f[2:] + f[:2]):
                self.assertGreater(independent_check.turn(at[a], at[b], at[c]), 0, f)

    def judge(self, points, triangles=0):
        added = independent_check.check(self.folder / "m.obj", read_xyz(self.folder / points),
                                        triangles=triangles)
        self.require_convex()
        return added

    def judge_mesh(self, source, **limits):
        added = independent_check.check_mesh(self.folder / "m.obj", self.folder / source, **limits)
        self.require_convex()
        return added


class Points(Convex):
    def test_hulls_odd_and_even(self):
        for seed in range(8):
            rng = random.Random(seed)
            points = {(rng.randrange(9), rng.randrange(9)) for _ in range(30)} | {(0, 0), (1, 0), (0, 1)}
            self.write("p.xyz", "".join(f"{x} {y}\n" for x, y in sorted(points)))
            hull = independent_check.hull_edges(range(len(points)), sorted(points))
            for method in ["delaunay", "spiral", "pentagons"]:
                for odd in ["outside", "triangle"]:
                    with self.subTest(seed=seed, method=method, odd=odd):
                        run = self.convert("p.xyz", "--method", method, "--odd-boundary", odd)
                        added = self.judge("p.xyz", triangles=len(hull) % 2)
                        bound = 3 * (len(points) // 2)
                        if method == "pentagons":
                            bound = 7 * ((2 * len(points) - 2 - len(hull) + 5) // 6)
                        self.assertLessEqual(added, bound + 1)
                        self.assertIn("100% strictly convex", run.stdout)
                        if odd == "triangle":
                            self.assertIn("1 triangle," if len(hull) % 2 else "no triangle", run.stdout)

    def test_a_triangle_with_a_point(self):
        self.write("p.xyz", TRIANGLE)
        run = self.convert("p.xyz")
        self.assertIn("outside", run.stdout)
        self.judge("p.xyz")
        run = self.convert("p.xyz", "--odd-boundary", "triangle")
        self.assertNotIn("outside", run.stdout)
        self.judge("p.xyz", triangles=1)

    def test_the_default_adds_less_than_the_paper(self):
        self.succeeds("generate", "uniform", "-n", 400, "--seed", 3, "-o", "p.xyz")
        self.convert("p.xyz", "--report", "d.json")
        few = self.judge("p.xyz")
        self.convert("p.xyz", "--method", "spiral", "--report", "s.json")
        many = self.judge("p.xyz")
        self.assertLess(10 * few, many)
        default, paper = (json.loads((self.folder / f).read_text())["mesh"] for f in ["d.json", "s.json"])
        self.assertTrue(default["convex"] and paper["convex"])
        self.assertEqual((default["added_points"], paper["added_points"]), (few, many))
        self.assertEqual(default["not_convex"], {"quads": 0, "listed": [], "corners": []})
        self.assertGreater(default["convex_statistics"]["mending"]["bad"], 0)
        by_points = paper["convex_statistics"]["patches_by_points"]
        self.assertLessEqual(abs(sum(i * n for i, n in enumerate(by_points)) - many), 1)

    def test_exactly(self):
        answers = []
        for seed in range(12):
            rng = random.Random(seed)
            points = sorted({(rng.randrange(9), rng.randrange(9)) for _ in range(9)} | {(0, 0), (1, 0), (0, 1)})
            self.write("p.xyz", "".join(f"{x} {y}\n" for x, y in points))
            hull = independent_check.hull_edges(range(len(points)), points)
            run = self.run_app("quadrangulate", "p.xyz", "--convex", "--exact", "-o", "m.obj")
            answers.append(run.returncode)
            with self.subTest(seed=seed):
                if run.returncode == 0:
                    self.assertEqual(self.judge("p.xyz", triangles=len(hull) % 2), 0)
                    continue
                self.assertEqual(run.returncode, 4, run.stderr)
                self.assertRegex(run.stderr, r"^quadloom: no mesh without an added point .* \d+ of the \d+ quads? can be")
                self.convert("p.xyz", "--odd-boundary", "triangle")
                self.assertGreater(self.judge("p.xyz", triangles=len(hull) % 2), 0)
        self.assertEqual(set(answers), {0, 4})

    def test_heights_and_the_seed(self):
        rng = random.Random(2)
        rows = [(rng.randrange(25), rng.randrange(25)) for _ in range(200)]
        self.write("p.xyz", "".join(f"{x} {y} {1 + 2 * x - y}\n" for x, y in rows))
        for options in [["--method", "spiral"], ["--seed", 1], ["--seed", 7]]:
            run = self.convert("p.xyz", "--odd-boundary", "triangle", *options)
            self.assertRegex(run.stdout, "points? added inside")
            lines = (self.folder / "m.obj").read_text().splitlines()
            for line in lines:
                if line.startswith("v "):
                    x, y, z = map(float, line.split()[1:])
                    self.assertAlmostEqual(z, 1 + 2 * x - y, places=9)
        self.convert("p.xyz", "--seed", 7)
        first = (self.folder / "m.obj").read_text()
        self.convert("p.xyz", "--seed", 7)
        self.assertEqual((self.folder / "m.obj").read_text(), first)

    def test_subdivision_is_convex_as_it_is(self):
        self.write("p.xyz", SQUARE)
        self.convert("p.xyz", "--method", "subdivide")
        self.judge("p.xyz")

    def test_what_cannot_be_mended_is_written_and_said(self):
        self.succeeds("generate", "near-line", "-n", 60, "--seed", 5, "-o", "p.xyz")
        for quiet in [[], ["--quiet"]]:
            run = self.run_app("quadrangulate", "p.xyz", "--convex", "--method", "spiral", "-o", "m.obj",
                               "--report", "r.json", *quiet)
            self.assertEqual(run.returncode, 4, run.stderr)
            self.assertRegex(run.stderr, r"^quadloom: \d+ quads are not strictly convex, no doubles .*: "
                                         r"the vertices \d+ \(.*\), \d+ \(.*\), \d+ \(.*\), \d+ \(.*\), "
                                         r"(flat|reflex) at \d+")
            independent_check.check(self.folder / "m.obj", read_xyz(self.folder / "p.xyz"))
            mesh = json.loads((self.folder / "r.json").read_text())["mesh"]
            _, faces = independent_check.read_obj(self.folder / "m.obj")
            self.assertEqual(len(mesh["not_convex"]["listed"]), mesh["not_convex"]["quads"])
            corners = mesh["not_convex"]["corners"]
            self.assertEqual({c["quad"] for c in corners}, set(mesh["not_convex"]["listed"]))
            hull = set(sum(independent_check.hull_edges(range(60), read_xyz(self.folder / "p.xyz")), ()))
            for c in corners:
                self.assertIn(c["turn"], ["flat", "reflex"])
                self.assertEqual(c["boundary"], c["vertex"] in hull)
            quality = mesh["certificate"]
            self.assertEqual(quality["strictly_convex"] + mesh["not_convex"]["quads"], len(faces))


class Meshes(Convex):
    def test_a_mesh_keeps_its_boundary(self):
        self.write("s.obj", ARROW)
        for leftover in ["walk", "steiner"]:
            with self.subTest(leftover):
                run = self.convert("s.obj", "--leftover", leftover, "--picture", "m.svg")
                self.assertGreater(self.judge_mesh("s.obj"), 0)
                self.assertIn("1 quad was not strictly convex, ", run.stdout)
                self.assertIn("m.svg", self.files())
        self.succeeds("check", "m.obj", "--source", "s.obj", "--strictly-convex", "--steiner-inside")
        self.convert("s.obj", "--method", "subdivide", "--odd-boundary", "on-edge")
        self.require_convex()

    def test_polygons(self):
        self.write("p.geojson", LAKE)
        self.succeeds("triangulate", "p.geojson", "-o", "t.obj")
        self.convert("p.geojson", "--report", "r.json")
        added = self.judge_mesh("t.obj")
        mesh = json.loads((self.folder / "r.json").read_text())["mesh"]
        self.assertEqual((mesh["added_points"], mesh["mending"]["left"]), (added, 0))
        self.succeeds("check", "m.obj", "--source", "p.geojson", "--strictly-convex")

    def test_generated_polygons(self):
        for kind in ["star", "two-opt", "comb", "rectilinear"]:
            self.succeeds("generate", kind + "-polygon", "-n", "60", "--holes", "2", "-o", "p.geojson")
            self.succeeds("triangulate", "p.geojson", "-o", "t.obj")
            with self.subTest(kind):
                self.convert("p.geojson", "--seed", 4)
                self.judge_mesh("t.obj", split=1)

    def test_regions_and_depths_stay(self):
        self.write("s.ply", REGIONS)
        run = self.convert("s.ply", output="m.ply")
        self.assertIn("100% strictly convex", run.stdout)
        self.succeeds("check", "m.ply", "--source", "s.ply", "--strictly-convex", "--steiner-inside")
        head, body = (self.folder / "m.ply").read_text().split("end_header\n")
        vertices = int(re.search(r"element vertex (\d+)", head)[1])
        self.assertGreater(vertices, 5)
        lines = body.splitlines()
        for line in lines[:vertices]:
            x, y, z = map(float, line.split()[:3])
            self.assertAlmostEqual(z, 1 + x + 2 * y, places=12)
        region = re.findall(r"property (?:double|float) (\w+)", head.split("vertex_indices")[1]).index("region")
        in_second = [set(map(int, w[1:5])) for w in map(str.split, lines[vertices:])
                     if float(w[5 + region]) == 2]
        self.assertEqual(in_second, [{1, 4, 3, 2}])


class Use(Convex):
    def test_points(self):
        self.write("p.xyz", SQUARE)
        self.write("odd.xyz", TRIANGLE)
        for source, fragments, options in [
                ("p.xyz", ["--convex", "spiral"], ["--method", "insertion"]),
                ("p.xyz", ["--convex", "4 corners"], ["--k", "6"]),
                ("p.xyz", ["circles", "pentagons"], ["--method", "circles"]),
                ("odd.xyz", ["flat corner"], ["--odd-boundary", "on-edge"]),
                ("p.xyz", ["--leftover"], ["--leftover", "walk"]),
                ("p.xyz", ["--method", "--exact"], ["--exact", "--method", "spiral"]),
                ("odd.xyz", ["a triangle stays"], ["--exact", "--odd-boundary", "outside"])]:
            with self.subTest(options=options):
                self.refuses(2, fragments, "quadrangulate", source, "--convex", "-o", "m.obj", *options)

        self.refuses(2, ["--exact", "--convex"], "quadrangulate", "p.xyz", "--exact", "-o", "m.obj")
        self.write("many.xyz", "".join(f"{i} {i * i}\n" for i in range(21)))
        self.refuses(2, ["21 distinct points", "20"], "quadrangulate", "many.xyz", "--convex", "--exact", "-o",
                     "m.obj")

    def test_meshes(self):
        self.write("s.obj", ARROW)
        for options in [["--method", "quarter"], ["--leftover", "error"], ["--leftover", "triangle"]]:
            with self.subTest(options=options):
                self.refuses(2, ["strictly convex", "pairs"], "quadrangulate", "s.obj", "--convex", "-o",
                             "m.obj", *options)
        self.refuses(2, ["--seed", "--convex"], "quadrangulate", "s.obj", "-o", "m.obj", "--seed", "7")

    def test_surfaces(self):
        self.write("s.obj", ARROW.replace("v 1 1 0", "v 1 1 2"))
        for method in ["pair", "subdivide"]:
            with self.subTest(method):
                self.refuses(3, ["planar"], "quadrangulate", "s.obj", "--convex", "-o", "m.obj",
                             "--space", "surface", "--method", method)


if __name__ == "__main__":
    main()
