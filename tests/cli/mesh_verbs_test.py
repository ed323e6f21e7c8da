"""quadloom check, quality and draw on mesh files, good and bad."""

import json
import struct

from harness import SQUARE, CommandLine, main

GOOD = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 0 0\nv 1 2 0\nf 1 5 6 4\nf 5 2 3 6\n"
DART = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 2 0\nv 3 2 0\nf 1 2 6 5\nf 2 3 6\nf 3 4 5 6\nf 4 1 5\n"


class Check(CommandLine):
    def finds(self, fragments, *args):
        run = self.run_app("check", *args)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertIn("NOT CERTIFIED", run.stderr)
        for fragment in fragments:
            self.assertIn(fragment, run.stderr)

    def test_good(self):
        self.write("m.obj", GOOD)
        self.write("p.xyz", "0 0\n2 0\n2 2\n0 2\n")
        run = self.succeeds("check", "m.obj")
        self.assertIn("certified", run.stdout)
        self.succeeds("check", "m.obj", "--strictly-convex")
        self.succeeds("check", "m.obj", "--points", "p.xyz", "--steiner-at-most", "2")

    def test_each_option_can_fail(self):
        self.write("m.obj", GOOD)
        self.write("p.xyz", "0 0\n2 0\n2 2\n0 2\n")
        self.write("more.xyz", "0 0\n2 0\n2 2\n0 2\n1 1\n")
        self.finds([], "m.obj", "--points", "p.xyz", "--steiner-at-most", "1")
        self.finds([], "m.obj", "--points", "p.xyz", "--steiner-inside")
        self.finds([], "m.obj", "--points", "more.xyz")
        self.finds([], "m.obj", "--k", "5")
        self.write("d.obj", DART)
        self.finds(["triangle"], "d.obj")
        self.succeeds("check", "d.obj", "--triangles-allowed", "2")
        self.write("flat.obj", GOOD.replace("f 1 5 6 4\nf 5 2 3 6\n", "v 0.5 1 0\nf 1 5 6 7\nf 7 6 4 1\nf 5 2 3 6\n"))
        self.finds([], "flat.obj", "--strictly-convex")

    def test_broken_geometry(self):
        for name, text in {
            "clockwise": GOOD.replace("f 1 5 6 4", "f 4 6 5 1"),
            "hole": GOOD.replace("f 5 2 3 6\n", "v 3 0 0\nf 2 7 3 6\n"),
            "twice": GOOD + "f 1 5 6 4\n",
            "crossing": GOOD.replace("f 1 5 6 4", "f 1 6 5 4"),
        }.items():
            with self.subTest(name):
                self.write("m.obj", text)
                self.finds([], "m.obj")

    def test_report(self):
        self.write("m.obj", GOOD)
        self.succeeds("check", "m.obj", "--report", "r.json")
        self.assertTrue(json.loads((self.folder / "r.json").read_text())["certificate"]["ok"])
        self.run_app("check", "m.obj", "--k", "5", "--report", "r.json")
        certificate = json.loads((self.folder / "r.json").read_text())["certificate"]
        self.assertFalse(certificate["ok"])
        self.assertTrue(certificate["fault"])


class Quality(CommandLine):
    def test_two_rectangles(self):
        self.write("m.obj", GOOD)
        q = json.loads(self.succeeds("quality", "m.obj", "--json").stdout)
        self.assertEqual((q["quads"], q["triangles"], q["strictly_convex"]), (2, 0, 2))
        self.assertAlmostEqual(q["min_angle_degrees"], 90)
        self.assertAlmostEqual(q["max_angle_degrees"], 90)
        self.assertAlmostEqual(q["mean_shape"], 1)
        self.assertAlmostEqual(q["max_aspect"], 2)
        self.assertEqual(sum(q["angle_histogram_10_degrees"]), 8)
        text = self.succeeds("quality", "m.obj").stdout
        self.assertIn("2 quads, 0 triangles", text)
        self.assertIn("90.000 to 90.000", text)

    def test_surfaces_are_measured_in_space(self):
        # A unit square that stands upright, then a mesh with heights as data.
        self.write("wall.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n")
        q = json.loads(self.succeeds("quality", "wall.obj", "--json").stdout)
        self.assertEqual(q["strictly_convex"], 1)
        self.assertAlmostEqual(q["mean_shape"], 1)
        self.write("heights.obj", "v 0 0 0\nv 1 0 5\nv 1 1 7\nv 0 1 9\nf 1 2 3 4\n")
        q = json.loads(self.succeeds("quality", "heights.obj", "--json").stdout)
        self.assertAlmostEqual(q["max_aspect"], 1)

    def test_standard_input(self):
        run = self.succeeds("quality", "-", "--mesh-format", "obj", "--json", stdin=GOOD)
        self.assertEqual(json.loads(run.stdout)["quads"], 2)


class Draw(CommandLine):
    def test_formats(self):
        self.write("m.obj", GOOD)
        for name, head in [("m.png", b"\x89PNG"), ("m.pdf", b"%PDF-"), ("m.svg", b"<?xml")]:
            with self.subTest(name):
                self.succeeds("draw", "m.obj", "-o", name, "--title", "Two & two <rectangles>")
                self.assertTrue((self.folder / name).read_bytes().startswith(head))

    def test_colours_differ_and_width_is_kept(self):
        self.write("m.obj", DART)
        pictures = set()
        for colour in ["quality", "convexity", "none"]:
            self.succeeds("draw", "m.obj", "-o", "m.png", "--colour", colour, "--width", "400")
            data = (self.folder / "m.png").read_bytes()
            pictures.add(data)
            self.assertEqual(struct.unpack(">I", data[16:20])[0], 400)
        self.assertEqual(len(pictures), 3)

    def test_added_points_are_known_from_the_file(self):
        self.write("p.xyz", "0 0\n4 0\n0 4\n1 1\n")
        self.succeeds("quadrangulate", "p.xyz", "-o", "m.vtu")
        self.succeeds("draw", "m.vtu", "-o", "m.svg")
        marked = (self.folder / "m.svg").read_text()
        self.write("q.xyz", SQUARE)
        self.succeeds("quadrangulate", "q.xyz", "-o", "m.vtu")
        self.succeeds("draw", "m.vtu", "-o", "m.svg")
        plain = (self.folder / "m.svg").read_text()
        ring = "rgb(86%,0%,38%)"
        self.assertTrue(ring in marked.replace(" ", ""))
        self.assertFalse(ring in plain.replace(" ", ""))


if __name__ == "__main__":
    main()
