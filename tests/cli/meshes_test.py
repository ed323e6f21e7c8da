"""quadloom quadrangulate on meshes and polygons: kinds of input, methods, what stays, what is carried."""

import json

import independent_check
from harness import CommandLine, main

SQUARE_MESH = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n"
# A triangle with a triangle on each side: the middle one can be paired with one of them only.
STAR = ("v 0 0 0\nv 4 0 0\nv 2 3 0\nv 2 -3 0\nv 5 3 0\nv -1 3 0\n"
        "f 1 2 3\nf 2 1 4\nf 3 2 5\nf 1 3 6\n")
ODD = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
COAST = """a small coast
4 5
1 0 0 1
2 4 0 5
3 4 4 13
4 0 4 9
5 2 2 7
1 3 1 2 5
2 3 2 3 5
3 3 3 4 5
4 3 4 1 5
"""
TWO_FIELDS = json.dumps({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"crop": 3}, "geometry": {"type": "Polygon", "coordinates": [
        [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]]}},
    {"type": "Feature", "properties": {"crop": 8}, "geometry": {"type": "Polygon", "coordinates": [
        [[4, 0], [8, 0], [8, 4], [4, 4], [4, 0]]]}}]})


def grid(n, regions=False):
    """n x n squares, each of two triangles, as PLY; the left half is region 1, the right one region 2."""
    vertices = [(x, y) for y in range(n + 1) for x in range(n + 1)]
    faces = []
    for y in range(n):
        for x in range(n):
            a = y * (n + 1) + x
            label = 1 if 2 * x < n else 2
            faces += [(a, a + 1, a + n + 2, label), (a, a + n + 2, a + n + 1, label)]
    head = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}", "property double x",
            "property double y", "property double salt", f"element face {len(faces)}",
            "property list uchar uint vertex_indices"] + (["property double region"] if regions else [])
    body = [f"{x} {y} {10 + x + 3 * y}" for x, y in vertices]
    body += [f"3 {a} {b} {c}" + (f" {label}" if regions else "") for a, b, c, label in faces]
    return "\n".join([*head, "end_header", *body, ""])


def read_ply(path):
    """Rows of the vertices and of the faces by name, of a text PLY as quadloom writes it."""
    lines = iter(path.read_text().splitlines())
    counts, names, element = {}, {}, None
    for line in lines:
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element], names[element] = int(words[2]), []
        elif words[0] == "property":
            names[element].append(words[-1])
        elif words[0] == "end_header":
            break
    vertices = [dict(zip(names["vertex"], map(float, next(lines).split())))
                for _ in range(counts["vertex"])]
    faces = []
    for _ in range(counts["face"]):
        words = next(lines).split()
        corners = int(words[0])
        row = dict(zip(names["face"][1:], map(float, words[corners + 1:])))
        row["corners"] = tuple(map(int, words[1:corners + 1]))
        faces.append(row)
    return vertices, faces


def edges_of(faces):
    return {frozenset(e) for f in faces for e in zip(f, f[1:] + f[:1])}


class Meshes(CommandLine):
    def convert(self, source, *options, output="m.obj"):
        return self.succeeds("quadrangulate", source, "-o", output, *options)

    def judge(self, source, **limits):
        return independent_check.check_mesh(self.folder / "m.obj", self.folder / source, **limits)


class Kinds(Meshes):
    def test_two_triangles_are_one_quad(self):
        self.write("s.obj", SQUARE_MESH)
        run = self.convert("s.obj")
        self.assertIn("4 points and 2 triangles: 1 quad, no triangle, no point added", run.stdout)
        self.assertIn("every triangle paired", run.stdout)
        self.assertIn("certified: every vertex stays and the faces tile the region", run.stdout)
        self.assertEqual(self.judge("s.obj"), 0)

    def test_every_kind_of_mesh_file(self):
        self.write("p.geojson", TWO_FIELDS)
        for name in ["t.obj", "t.off", "t.ply", "t.vtu", "t.msh", "t.geojson"]:
            with self.subTest(name):
                self.succeeds("triangulate", "p.geojson", "-o", name)
                forced = ["--input", "mesh"] if name.endswith("geojson") else []
                run = self.convert(name, "--regions", "none", *forced)
                self.assertIn("and 10 triangles: ", run.stdout)
                if not forced:  # a GeoJSON as a source is one of polygons
                    self.succeeds("check", "m.obj", "--source", name)

    def test_quads_of_the_source_stay(self):
        self.write("s.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 3 0 0\nv 3 2 0\n"
                            "f 1 2 3 4\nf 2 5 6\nf 2 6 3\n")
        run = self.convert("s.obj", output="m.ply")
        self.assertIn("6 points and 3 faces: 2 quads, no triangle, no point added", run.stdout)
        _, faces = read_ply(self.folder / "m.ply")
        self.assertEqual(sorted((f["source0"], f["source1"]) for f in faces), [(0, -1), (1, 2)])
        run = self.convert("s.obj", "--method", "subdivide")
        self.assertIn("10 quads", run.stdout)  # four of the quad and three of each triangle
        self.judge("s.obj", split=6)

    def test_facets_and_numbered_elements(self):
        facets = [[(0, 0), (2, 0), (2, 2)], [(0, 0), (2, 2), (0, 2)]]
        self.write("t.stl", "solid t\n" + "".join(
            "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} 0\n" for x, y in facet)
            + "endloop\nendfacet\n" for facet in facets) + "endsolid t\n")
        self.write("e.node", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n")
        self.write("e.ele", "2 3 1\n1 1 2 3 5\n2 1 3 4 5\n")
        for name in ["t.stl", "e.ele"]:
            with self.subTest(name):
                self.assertIn("4 points and 2 triangles: 1 quad", self.convert(name).stdout)
                self.succeeds("check", "m.obj", "--source", name)
        self.write("e.ele", "2 3 1\n1 1 2 3 5\n2 1 3 4 6\n")  # two regions
        run = self.convert("e.ele", "--odd-boundary", "triangle")
        self.assertIn("0 quads, 2 triangles", run.stdout)

    def test_standard_input(self):
        run = self.succeeds("quadrangulate", "-", "--format", "obj", "-o", "-", "--output-format",
                            "obj", stdin=SQUARE_MESH)
        self.assertIn("certified", run.stderr)
        self.assertEqual(run.stdout.count("f "), 1)

    def test_polygons_and_points(self):
        self.write("p.geojson", TWO_FIELDS)
        run = self.convert("p.geojson")
        self.assertIn("certified: every corner and point is a vertex and the faces tile the polygons",
                      run.stdout)
        self.succeeds("check", "m.obj", "--source", "p.geojson", "--steiner-at-most", "0")
        self.write("q.json", '{"type": "MultiPoint", "coordinates": [[0,0],[2,0],[2,2],[0,2],[1,1]]}')
        self.assertIn("5 points, ", self.convert("q.json").stdout)
        self.write("b.poly", "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        self.assertIn("4 points and 2 triangles: 1 quad", self.convert("b.poly").stdout)
        self.write("n.node", "5 2 1 0\n1 0 0 7\n2 2 0 7\n3 2 2 7\n4 0 2 7\n5 1 1 7\n")
        self.assertIn("5 points, ", self.convert("n.node").stdout)
        self.refuses(3, ["Polygon"], "quadrangulate", "p.geojson", "-o", "x.obj", "--input", "points")

    def test_depths_are_carried(self):
        self.write("coast.14", COAST)
        self.convert("coast.14", output="m.ply")
        vertices, faces = read_ply(self.folder / "m.ply")
        self.assertEqual([v["z"] for v in vertices], [1, 5, 13, 9, 7])
        self.assertEqual(len(faces), 2)
        # An odd border: the added point has the depth of its place, 1 + x + 2 y.
        self.write("odd.14", COAST.replace("4 5\n", "3 5\n", 1).replace("4 3 4 1 5\n", ""))
        run = self.convert("odd.14", output="m.ply")
        self.assertIn("1 point added on an edge", run.stdout)
        self.assertRegex(run.stdout, r"1 point added on the edge from vertex \d \(.*\) to \d \(.*\) "
                                     r"\(part with an odd border\)")
        vertices, _ = read_ply(self.folder / "m.ply")
        v = vertices[5]
        self.assertEqual((v["added"], len(vertices)), (1, 6))
        self.assertAlmostEqual(v["z"], 1 + v["x"] + 2 * v["y"], places=12)

    def test_generated_polygons(self):
        for kind in ["star", "two-opt", "comb", "spiral", "rectilinear"]:
            self.succeeds("generate", kind + "-polygon", "-n", "60", "--holes", "3", "-o", "p.geojson")
            self.succeeds("triangulate", "p.geojson", "-o", "t.obj")
            for odd in ["on-edge", "outside", "triangle"]:
                with self.subTest(kind=kind, odd=odd):
                    self.convert("t.obj", "--odd-boundary", odd)
                    limit = {"on-edge": "split", "outside": "outside", "triangle": "triangles"}[odd]
                    self.judge("t.obj", **{limit: 1})
                    self.convert("p.geojson", "--odd-boundary", odd)
                    self.judge("t.obj", **{limit: 1})


class Words(Meshes):
    def test_methods_of_the_other_kind(self):
        self.write("s.obj", SQUARE_MESH)
        self.write("p.xyz", "0 0\n1 0\n0 1\n1 1\n")
        self.refuses(2, ["--method", "'delaunay'", "pair", "percolate", "fans", "q-percolate"],
                     "quadrangulate", "s.obj", "-o", "m.obj", "--method", "delaunay")
        self.refuses(2, ["--method", "'pair'", "delaunay", "spiral"], "quadrangulate", "p.xyz", "-o",
                     "m.obj", "--method", "pair")

    def test_options_of_the_other_kind_or_method(self):
        self.write("s.obj", SQUARE_MESH)
        self.write("p.xyz", "0 0\n1 0\n0 1\n1 1\n")
        self.write("p.geojson", TWO_FIELDS)
        for source, option, value in [("s.obj", "--k", "5"), ("s.obj", "--seed", "7"),
                                      ("p.xyz", "--leftover", "walk"), ("p.xyz", "--keep", "none"),
                                      ("p.xyz", "--space", "plane"), ("p.geojson", "--space", "plane")]:
            with self.subTest(source=source, option=option):
                self.refuses(2, [option, " is for "], "quadrangulate", source, "-o", "m.obj", option,
                             value)
        self.refuses(2, ["--leftover", "pair"], "quadrangulate", "s.obj", "-o", "m.obj", "--method",
                     "subdivide", "--leftover", "walk")

    def test_bad_words(self):
        self.write("s.obj", SQUARE_MESH)
        for option, word in [("--leftover", "keep"), ("--pairs", "some"), ("--matching", "best"),
                             ("--min-quality", "nan"), ("--min-quality", "1.5"), ("--space", "4d"),
                             ("--keep-angle", "steep"), ("--faulty", "keep"), ("--input", "image")]:
            with self.subTest(option=option):
                self.refuses(2, [option, word], "quadrangulate", "s.obj", "-o", "m.obj", option, word)
        self.refuses(2, ["--regions", "'soil'"], "quadrangulate", "s.obj", "-o", "m.obj", "--regions",
                     "soil")
        self.refuses(2, ["--weight", "'salt'", "shape, convexity"], "quadrangulate", "s.obj", "-o",
                     "m.obj", "--weight", "salt")

    def test_polygons_that_cross_are_named_by_place(self):
        self.write("p.geojson", '{"type": "Polygon", "coordinates": '
                                '[[[0, 0], [4, 4], [4, 0], [0, 4], [0, 0]]]}')
        text = self.refuses(3, ["crosses", "ring 0"], "quadrangulate", "p.geojson", "-o", "m.obj")
        for edge in ["from (0, 0) to (4, 4)", "from (4, 0) to (0, 4)"]:
            self.assertIn(edge, text)
        self.write("p.geojson", '{"type": "Polygon", "coordinates": '
                                '[[[0, 0], [4, 0], [4, 4], [0, 0]], [[3, 1], [3, 2], [3, 1]]]}')
        self.refuses(3, ["ring 1 of polygon 0", "three"], "quadrangulate", "p.geojson", "-o", "m.obj")

    def test_meshes_that_are_none(self):
        for name, text in {
            "three faces at an edge": SQUARE_MESH + "v 5 5 5\nf 1 3 5\n",
            "index": SQUARE_MESH + "f 1 2 9\n",
            "no faces": "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
        }.items():
            with self.subTest(name):
                self.write("s.obj", text)
                self.refuses(3, [], "quadrangulate", "s.obj", "-o", "m.obj")

    def test_faces_that_overlap(self):
        self.write("s.obj", "v 0 0\nv 4 0\nv 0 4\nv 1 1\nv 5 1\nv 1 5\nf 1 2 3\nf 4 5 6\n")
        self.refuses(3, ["overlap", "vertex 3 (1, 1)"], "quadrangulate", "s.obj", "-o", "m.obj")

    def test_outputs_differ(self):
        self.write("s.obj", ODD)
        self.refuses(2, ["two outputs", "m.obj"], "quadrangulate", "s.obj", "-o", "m.obj",
                     "--report", "./m.obj")
        self.refuses(2, ["standard output"], "quadrangulate", "s.obj", "-o", "-",
                     "--output-format", "obj", "--report", "-")
        self.refuses(2, ["standard output", "said"], "quadrangulate", "s.obj", "-o", "-")

    def test_faces_turned_over(self):
        self.write("s.obj", SQUARE_MESH.replace("f 1 3 4", "f 4 3 1"))
        self.assertIn("1 face turned over", self.convert("s.obj").stdout)
        self.refuses(3, ["1"], "quadrangulate", "s.obj", "-o", "x.obj", "--faulty", "refuse")

    def test_repeated_vertices(self):
        self.write("s.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 4 5 6\n")
        run = self.convert("s.obj", "--merge-vertices")
        self.assertIn("4 points and 2 triangles: 1 quad", run.stdout)
        self.assertIn("2 repeated vertex places merged", run.stdout)


class Leftover(Meshes):
    def test_no_perfect_matching_is_explained(self):
        self.write("s.obj", STAR)
        text = self.refuses(4, ["no perfect matching", "2 triangles stay unmatched whatever is done",
                                "taking the 1 triangle 0 away leaves 3 parts with an odd number"],
                            "quadrangulate", "s.obj", "-o", "m.obj", "--leftover", "error")
        self.assertNotIn("certified", text)

    def test_the_witness_is_drawn(self):
        self.write("s.obj", STAR)
        run = self.run_app("quadrangulate", "s.obj", "-o", "m.obj", "--leftover", "error", "--picture",
                           "w.svg")
        self.assertEqual(run.returncode, 4)
        self.assertEqual(self.files(), ["s.obj", "w.svg"])
        self.convert("s.obj", "--picture", "m.svg")
        barrier = "rgb(80%,29%,8%)"  # found nowhere in a picture by shape
        self.assertIn(barrier, (self.folder / "w.svg").read_text().replace(" ", ""))
        self.assertNotIn(barrier, (self.folder / "m.svg").read_text().replace(" ", ""))

    def test_parts_without_a_barrier(self):
        self.write("s.obj", ODD)
        self.refuses(4, ["1 triangle stays unmatched", "there is 1 part with an odd number"],
                     "quadrangulate", "s.obj", "-o", "m.obj", "--leftover", "error")

    def test_triangles_may_stay(self):
        self.write("s.obj", STAR)
        run = self.convert("s.obj", "--leftover", "triangle")
        self.assertIn("1 quad, 2 triangles, no point added", run.stdout)
        self.assertIn("taking the 1 triangle 0 away leaves 3 parts", run.stdout)
        self.assertEqual(self.judge("s.obj", triangles=2), 0)

    def test_all_quads(self):
        self.write("s.obj", STAR)
        for leftover in ["walk", "steiner"]:
            with self.subTest(leftover):
                run = self.convert("s.obj", "--leftover", leftover)
                self.assertIn("no triangle", run.stdout)
                self.judge("s.obj")

    def test_odd_borders(self):
        self.write("s.obj", ODD)
        for odd, limit, words in [("on-edge", "split", "1 point added on an edge"),
                                  ("outside", "outside", "1 point added outside"),
                                  ("triangle", "triangles", "1 triangle stays: the vertices ")]:
            with self.subTest(odd):
                self.assertIn(words, self.convert("s.obj", "--odd-boundary", odd).stdout)
                self.assertEqual(self.judge("s.obj", **{limit: 1}), 0 if odd == "triangle" else 1)

    def test_quality_below_which_nothing_is_merged(self):
        self.write("s.obj", SQUARE_MESH.replace("v 2 2 0", "v 9 1 0"))
        run = self.convert("s.obj", "--leftover", "triangle", "--min-quality", "0.9")
        self.assertIn("0 quads, 2 triangles", run.stdout)


class Stays(Meshes):
    def faces(self):
        return [f["corners"] for f in read_ply(self.folder / "m.ply")[1]]

    def test_regions_never_mix(self):
        self.write("s.ply", grid(3, regions=True))
        self.convert("s.ply", output="m.ply")
        vertices, faces = read_ply(self.folder / "m.ply")
        for f in faces:
            xs = [vertices[v]["x"] for v in f["corners"]]
            self.assertEqual(f["region"], 1 if max(xs) <= 2 else 2)
            self.assertTrue(max(xs) <= 2 or min(xs) >= 2)

    def test_parts_of_polygons_never_mix_and_carry_their_numbers(self):
        self.write("p.geojson", TWO_FIELDS)
        self.convert("p.geojson", output="m.ply")
        vertices, faces = read_ply(self.folder / "m.ply")
        for f in faces:
            right = min(vertices[v]["x"] for v in f["corners"]) >= 4
            self.assertEqual((f["crop"], f["part"]), (8, 1) if right else (3, 0))

    def write_square_with_a_line(self):
        self.write("s.obj", SQUARE_MESH)
        self.write("s.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 2 0 0\n"
                            "3 2 2 0\n4 0 2 0\n$EndNodes\n$Elements\n3\n1 1 0 1 3\n2 2 0 1 2 3\n"
                            "3 2 0 1 3 4\n$EndElements\n")

    def test_lines_stay(self):
        self.write_square_with_a_line()
        run = self.convert("s.msh", "--odd-boundary", "triangle")
        self.assertIn("1 inner edge kept", run.stdout)
        self.assertIn("0 quads, 2 triangles", run.stdout)
        self.assertEqual(self.judge("s.obj", triangles=2), 0)
        self.assertIn("1 quad, no triangle", self.convert("s.msh", "--keep", "none").stdout)
        self.write("l.obj", SQUARE_MESH + "l 1 3\nl 2 4\n")  # the other diagonal is no edge
        run = self.convert("l.obj", "--odd-boundary", "triangle")
        self.assertIn("1 inner edge kept", run.stdout)
        self.assertIn("1 line of the file along no edges of the mesh", run.stdout)

    def test_lines_are_written_again_in_pieces(self):
        self.write_square_with_a_line()
        self.convert("s.msh", "--method", "subdivide", "--output-format", "msh22", output="m.msh")
        lines = [l.split() for l in (self.folder / "m.msh").read_text().splitlines()]
        elements = lines[lines.index(["$Elements"]) + 2:lines.index(["$EndElements"])]
        ends = [tuple(map(int, w[-2:])) for w in elements if w[1] == "1"]
        nodes = lines[lines.index(["$Nodes"]) + 2:lines.index(["$EndNodes"])]
        at = {int(w[0]): tuple(map(float, w[1:3])) for w in nodes}
        self.assertEqual([[at[v] for v in line] for line in ends],
                         [[(0, 0), (1, 1)], [(1, 1), (2, 2)]])

    def test_lines_of_another_file(self):
        self.write("s.ply", grid(4))
        line = '{"type": "LineString", "coordinates": %s}'
        self.write("l.geojson", line % "[[0, 0], [3, 3], [3, 4]]")
        run = self.convert("s.ply", "--keep", "l.geojson", "--odd-boundary", "triangle",
                           "--leftover", "steiner", output="m.ply")
        self.assertIn("4 inner edges kept", run.stdout)
        kept = {frozenset(e) for e in [(0, 6), (6, 12), (12, 18), (18, 23)]}
        self.assertLessEqual(kept, edges_of(self.faces()))
        for places, fragments in {
            "[[0, 0], [2, 1]]": ["from (0, 0) to (2, 1)", "does not follow edges"],
            "[[0, 0], [1, 0], [1, 0.5]]": ["from (1, 0) to (1, 0.5)", "ends at no vertex"],
            "[[9, 0], [0, 0]]": ["from (9, 0) to (0, 0)", "begins at no vertex"],
        }.items():
            with self.subTest(places):
                self.write("l.geojson", line % places)
                self.refuses(3, ["l.geojson", *fragments], "quadrangulate", "s.ply", "-o", "x.obj",
                             "--keep", "l.geojson")


class Carried(Meshes):
    def test_vertex_and_face_data(self):
        self.write("s.ply", grid(3, regions=True))
        for method in [["--method", "subdivide"], ["--leftover", "steiner"]]:
            with self.subTest(method):
                self.convert("s.ply", *method, output="m.ply")
                vertices, faces = read_ply(self.folder / "m.ply")
                for v in vertices:  # linear data stay linear at added points
                    self.assertAlmostEqual(v["salt"], 10 + v["x"] + 3 * v["y"], places=9)
                sources = [f["source0"] for f in faces] + [f["source1"] for f in faces]
                self.assertEqual({s for s in sources if s >= 0}, set(range(18)))
                self.assertTrue(all(0 <= f["shape"] <= 1 for f in faces))

    def test_face_data_are_the_mean_where_sources_differ(self):
        lines = grid(1, regions=True).replace("region", "soil").splitlines()
        values = [4, 7]
        lines[-2:] = [f"{l[:-1]}{value}" for l, value in zip(lines[-2:], values)]
        self.write("s.ply", "\n".join([*lines, ""]))
        self.convert("s.ply", output="m.ply")
        _, faces = read_ply(self.folder / "m.ply")
        self.assertEqual([f["soil"] for f in faces], [sum(values) / 2])
        self.assertEqual([{f["source0"], f["source1"]} for f in faces], [{0, 1}])

    def test_weights_of_any_size(self):
        numbers = ["-1e308", "1e308", "0", "1.7e308"]
        text = grid(1)
        head, body = text.split("end_header\n")
        lines = body.splitlines()
        body = "\n".join([f"{l} {n}" for l, n in zip(lines, numbers)] + lines[4:]) + "\n"
        head = head.replace("element face", "property double w\nelement face")
        self.write("s.ply", head + "end_header\n" + body)
        self.convert("s.ply", "--weight", "w")

    def test_weights_of_vertices(self):
        # A square of four triangles around its centre: one pair of opposite spokes goes. The spoke to
        # the corner with the greatest number does.
        for heavy in range(4):
            numbers = [1.0] * 5
            numbers[heavy] = 9.0
            rows = ["0 0", "2 0", "2 2", "0 2", "1 1"]
            self.write("s.ply", "\n".join(
                ["ply", "format ascii 1.0", "element vertex 5", "property double x", "property double y",
                 "property double w", "element face 4", "property list uchar uint vertex_indices",
                 "end_header", *[f"{r} {n}" for r, n in zip(rows, numbers)],
                 "3 0 1 4", "3 1 2 4", "3 2 3 4", "3 3 0 4", ""]))
            self.convert("s.ply", "--weight", "w", "--pairs", "any", output="m.ply")
            corners = [f["corners"] for f in read_ply(self.folder / "m.ply")[1]]
            with self.subTest(heavy=heavy):
                self.assertNotIn(frozenset((heavy, 4)), edges_of(corners))


class Surfaces(Meshes):
    OCTAHEDRON = ("v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 5\nf 2 3 5\nf 3 4 5\n"
                  "f 4 1 5\nf 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n")
    CUBE = ("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
            "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n"
            "f 4 1 5\nf 4 5 8\n")

    def test_closed_surfaces(self):
        self.write("s.obj", self.OCTAHEDRON)
        run = self.convert("s.obj")
        self.assertIn("6 points and 8 triangles: 4 quads, no triangle, no point added", run.stdout)
        self.assertIn("certified", run.stdout)
        self.succeeds("check", "m.obj", "--source", "s.obj")
        self.convert("s.obj", "--method", "subdivide")
        self.succeeds("check", "m.obj", "--source", "s.obj")

    def test_a_hole_in_a_surface_is_found(self):
        self.write("s.obj", self.OCTAHEDRON)
        self.convert("s.obj")
        lines = (self.folder / "m.obj").read_text().splitlines()
        last = max(i for i, l in enumerate(lines) if l.startswith("f "))
        self.write("m.obj", "\n".join(lines[:last] + lines[last + 1:]) + "\n")
        run = self.run_app("check", "m.obj", "--source", "s.obj")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("NOT CERTIFIED", run.stderr)

    def test_odd_places_are_named_in_space(self):
        self.write("s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
        self.assertRegex(self.convert("s.obj").stdout,
                         r"the edge from vertex \d \(\d, \d, \d\) to \d \(\d, \d, \d\)")

    def test_sharp_edges_stay(self):
        self.write("s.obj", self.CUBE)
        run = self.convert("s.obj", "--keep-angle", "30")
        self.assertIn("12 inner edges kept", run.stdout)
        self.assertIn("6 quads", run.stdout)
        q = json.loads(self.succeeds("quality", "m.obj", "--json").stdout)
        self.assertEqual((q["quads"], q["strictly_convex"]), (6, 6))
        self.assertAlmostEqual(q["min_angle_degrees"], 90)
        self.assertAlmostEqual(q["max_angle_degrees"], 90)

    def test_no_sharp_edges_in_the_plane(self):
        self.write("s.obj", ODD)
        self.assertIn("the mesh is planar", self.convert("s.obj", "--keep-angle", "30").stdout)

    def test_space(self):
        # A steep roof over two squares: in the plane its quads are squares, in space they are not.
        self.write("s.obj", "v 0 0 0\nv 1 0 2\nv 1 1 2\nv 0 1 0\nf 1 2 3 4\n")
        for space, longest in [("plane", 1), ("surface", 5 ** 0.5), ("auto", 1)]:
            with self.subTest(space):
                q = json.loads(self.succeeds("quality", "s.obj", "--json", "--space", space).stdout)
                self.assertAlmostEqual(q["max_edge"], longest)


class Check(Meshes):
    def finds(self, *args):
        run = self.run_app("check", *args)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("NOT CERTIFIED", run.stderr)

    def test_source(self):
        self.write("s.obj", STAR)
        self.convert("s.obj")
        self.assertIn("every vertex stays",
                      self.succeeds("check", "m.obj", "--source", "s.obj").stdout)
        self.write("t.obj", STAR.replace("v 5 3", "v 5 4"))
        self.finds("m.obj", "--source", "t.obj")
        self.write("u.obj", STAR.replace("f 1 3 6\n", ""))
        self.finds("m.obj", "--source", "u.obj")
        run = self.run_app("check", "s.obj")  # its triangles are too many
        self.assertIn("0 faces, 1 triangle,", run.stderr)

    def test_polygons(self):
        self.write("p.geojson", TWO_FIELDS)
        self.convert("p.geojson")
        run = self.succeeds("check", "m.obj", "--source", "p.geojson", "--report", "r.json")
        self.assertIn("tile the polygons", run.stdout)
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["input"]["points"], 12)
        self.write("q.geojson", TWO_FIELDS.replace("[1, 2], ", ""))
        self.finds("m.obj", "--source", "q.geojson")

    def test_outer_points(self):
        self.write("s.obj", ODD)
        self.convert("s.obj", "--odd-boundary", "outside")
        self.finds("m.obj", "--source", "s.obj")
        self.succeeds("check", "m.obj", "--source", "s.obj", "--outer-steiner")

    def test_points_as_a_source(self):
        self.write("p.xyz", "0 0\n4 0\n4 4\n0 4\n1 1\n")
        self.convert("p.xyz")
        self.succeeds("check", "m.obj", "--source", "p.xyz")
        self.refuses(2, ["--points", "--source"], "check", "m.obj", "--source", "p.xyz", "--points",
                     "p.xyz")


class Others(Meshes):
    def test_report(self):
        self.write("s.obj", ODD)
        self.convert("s.obj", "--report", "r.json", "--picture", "m.png")
        mesh = json.loads((self.folder / "r.json").read_text())["mesh"]
        self.assertEqual((mesh["kind"], mesh["method"], mesh["leftover"], mesh["odd_boundary"]),
                         ("planar mesh", "pair", "walk", "on-edge"))
        statistics = mesh["statistics"]
        self.assertEqual((statistics["triangles"], statistics["boundary_edges"],
                          statistics["odd_parts"]), (3, 3, 1))
        self.assertEqual((mesh["source"]["components"], mesh["source"]["boundary_cycles"]), (1, 1))
        self.assertEqual(mesh["added_points"], 1)
        self.assertEqual(mesh["added_points_listed"][0]["where"], "on an edge")
        self.assertEqual(set(mesh["seconds"]), {"read", "connect", "convert", "certify", "write"})
        self.assertTrue(mesh["certificate"]["ok"])
        self.assertIn(mesh["worst_angle_degrees"], (mesh["quality"]["min_angle_degrees"],
                                                    mesh["quality"]["max_angle_degrees"]))

    def test_report_of_polygons(self):
        self.write("p.geojson", TWO_FIELDS)
        self.convert("p.geojson", "--report", "r.json")
        source = json.loads((self.folder / "r.json").read_text())["mesh"]["source"]
        self.assertEqual(source["polygons"], 2)
        self.assertNotIn("components", source)

    def test_triangulate(self):
        self.write("p.xyz", "0 0 1\n4 0 2\n4 4 3\n0 4 4\n1 1 5\n")
        run = self.succeeds("triangulate", "p.xyz", "-o", "t.off")
        self.assertIn("5 points, 4 triangles", run.stdout)
        self.assertIn("certified", run.stdout)
        self.succeeds("check", "t.off", "--points", "p.xyz", "--k", "3")
        self.write("p.geojson", TWO_FIELDS)
        run = self.succeeds("triangulate", "p.geojson", "-o", "t.ply", "--picture", "t.svg")
        self.assertIn("10 points, 10 triangles", run.stdout)
        _, faces = read_ply(self.folder / "t.ply")
        self.assertEqual(sorted({(f["part"], f["crop"]) for f in faces}), [(0, 3), (1, 8)])
        self.refuses(2, ["t.ply", "mesh already"], "triangulate", "t.ply", "-o", "u.ply")

    def test_generate_polygons(self):
        self.succeeds("generate", "comb-polygon", "-n", "30", "--holes", "2", "-o", "p.geojson")
        first = (self.folder / "p.geojson").read_bytes()
        rings = json.loads(first)["features"][0]["geometry"]["coordinates"]
        self.assertEqual(len(rings), 3)
        self.assertTrue(all(ring[0] == ring[-1] for ring in rings))
        self.succeeds("generate", "comb-polygon", "-n", "30", "--holes", "2", "-o", "p.geojson")
        self.assertEqual((self.folder / "p.geojson").read_bytes(), first)
        self.refuses(2, ["p.xyz", ".geojson"], "generate", "comb-polygon", "-n", "30", "-o", "p.xyz")
        self.refuses(2, ["--holes"], "generate", "uniform", "-n", "30", "--holes", "2", "-o", "p.xyz")
        self.refuses(2, ["'squares'", "comb-polygon", "uniform"], "generate", "squares", "-o", "q.xyz")


if __name__ == "__main__":
    main()
