"""quadloom strip and unstrip."""

from harness import CommandLine, main

TWO = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
CLOCKWISE = TWO.replace("f 1 2 3", "f 3 2 1").replace("f 1 3 4", "f 4 3 1")
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def triangles(path):
    """Each from its smallest corner, sorted: what must not change."""
    faces = []
    for line in path.read_text().splitlines():
        if line.startswith("f "):
            face = [int(word) for word in line.split()[1:]]
            start = face.index(min(face))
            faces.append(tuple(face[start:] + face[:start]))
    return sorted(faces)


def vertices(path):
    return [line for line in path.read_text().splitlines() if line.startswith("v ")]


class Strip(CommandLine):
    def goes_round(self, name, *args):
        run = self.succeeds("strip", name, "-o", "m.strip", *args)
        self.assertIn("certified", run.stdout)
        self.succeeds("unstrip", "m.strip", "-o", "back.obj")
        self.assertEqual(triangles(self.folder / "back.obj"), triangles(self.folder / name))
        self.assertEqual(vertices(self.folder / "back.obj"), vertices(self.folder / name))
        return run.stdout

    def test_round_trips(self):
        self.succeeds("generate", "uniform", "-n", "300", "-o", "p.xyz")
        self.succeeds("triangulate", "p.xyz", "-o", "delaunay.obj")
        for name, text in {"two.obj": TWO, "clockwise.obj": CLOCKWISE, "tetrahedron.obj": TETRAHEDRON}.items():
            self.write(name, text)
        for name in ["two.obj", "clockwise.obj", "tetrahedron.obj", "delaunay.obj"]:
            for encoding in ["swap", "repeat", "restart"]:
                with self.subTest(f"{name} {encoding}"):
                    said = self.goes_round(name, "--encoding", encoding)
                    self.assertIn("indices a triangle: repeat", said)
        for effort in ["fast", "standard", "thorough"]:
            self.goes_round("delaunay.obj", "--effort", effort, "--seed", "7")

    def test_two_triangles_are_four_indices(self):
        self.write("two.obj", TWO)
        self.assertIn("2 triangles: 1 strip, 4 indices", self.goes_round("two.obj"))
        self.assertIn("restart 2.0000", self.goes_round("two.obj"))

    def test_same_bytes_again(self):
        self.succeeds("generate", "uniform", "-n", "2000", "-o", "p.xyz")
        self.succeeds("triangulate", "p.xyz", "-o", "m.off")
        self.succeeds("strip", "m.off", "-o", "a.strip")
        self.succeeds("strip", "m.off", "-o", "b.strip")
        self.succeeds("strip", "m.off", "-o", "c.strip", "--seed", "2")
        read = lambda name: (self.folder / name).read_bytes()
        self.assertEqual(read("a.strip"), read("b.strip"))
        self.assertNotEqual(read("a.strip"), read("c.strip"))

    def test_fewer_indices_than_triangles_take(self):
        self.succeeds("generate", "uniform", "-n", "5000", "-o", "p.xyz")
        self.succeeds("triangulate", "p.xyz", "-o", "m.off")
        said = self.succeeds("strip", "m.off", "-o", "m.strip").stdout
        figure = float(said.split("restart ")[1].split(",")[0])
        self.assertLess(figure, 1.35)

    def test_quads_are_cut(self):
        self.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        run = self.succeeds("strip", "quad.obj", "-o", "m.strip")
        self.assertIn("1 quad cut into two triangles", run.stdout)
        self.assertIn("2 triangles: 1 strip", run.stdout)

    def test_standard_output_and_input(self):
        self.write("two.obj", TWO)
        strips = self.succeeds("strip", "two.obj", "-o", "-").stdout
        self.assertTrue(strips.startswith("strips 1\nencoding restart\n"), strips)
        self.succeeds("unstrip", "-", "-o", "back.obj", stdin=strips)
        self.assertEqual(len(triangles(self.folder / "back.obj")), 2)

    def test_picture(self):
        self.write("two.obj", TWO)
        self.succeeds("strip", "two.obj", "-o", "m.strip", "--picture", "m.svg")
        picture = (self.folder / "m.svg").read_text()
        # Edges are dark, the strip has a colour of its own.
        strokes = {part.split(")")[0] for part in picture.split("stroke:rgb(")[1:]}
        self.assertEqual(len(strokes), 3, strokes)  # and the white around the points

    def test_refusals(self):
        self.write("two.obj", TWO)
        self.write("five.obj", "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 3 0\nv 0 1 0\nf 1 2 3 4 5\n")
        self.write("twice.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2\n")
        self.write("bad.strip", "strips 1\nencoding repeat\npoints 1 2\n0 0\nindices 1\n1\n")
        self.refuses(3, ["face 0 has 5 corners"], "strip", "five.obj", "-o", "m.strip")
        self.refuses(3, [], "strip", "twice.obj", "-o", "m.strip")
        self.refuses(3, ["gone.obj"], "strip", "gone.obj", "-o", "m.strip")
        self.refuses(3, ["folder"], "strip", "two.obj", "-o", "nowhere/m.strip")
        self.refuses(2, ["'fan' is none of"], "strip", "two.obj", "-o", "m.strip", "--encoding", "fan")
        self.refuses(2, ["two outputs"], "strip", "two.obj", "-o", "m.svg", "--picture", "m.svg")
        self.refuses(3, ["bad.strip, line 6"], "unstrip", "bad.strip", "-o", "m.obj")
        self.refuses(3, ["two.obj, line 1"], "unstrip", "two.obj", "-o", "m.obj")


if __name__ == "__main__":
    main()
