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


if __name__ == "__main__":
    main()
