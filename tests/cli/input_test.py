"""Files that cannot be used: exit code 3, one sentence, the line where there is one."""

import os

from harness import SQUARE, CommandLine, main


class Input(CommandLine):
    def refuses_text(self, fragments, text, name="p.xyz", *more):
        self.write(name, text)
        self.refuses(3, fragments, "quadrangulate", name, "-o", "m.obj", *more)
        self.assertNotIn("m.obj", self.files())

    def test_no_such_file(self):
        self.refuses(3, ["none.csv"], "quadrangulate", "none.csv", "-o", "m.obj")
        self.refuses(3, ["none.obj"], "check", "none.obj")

    def test_empty_file(self):
        for name in ["p.xyz", "p.csv", "p.geojson"]:
            with self.subTest(name):
                self.refuses_text([name], "", name)
        self.refuses_text(["p.csv"], "x,y\n", "p.csv")

    def test_not_a_number(self):
        self.refuses_text(["line 2"], "0 0\nnan 1\n2 3\n")
        self.refuses_text(["line 3"], "0 0\n1 0\n2 inf\n")
        self.refuses_text(["line 3"], "x,y\n0,0\n1,NaN\n2,2\n", "p.csv")

    def test_bad_number(self):
        self.refuses_text(["line 3"], "0 0\n1 0\n2 two\n3 3\n")
        self.refuses_text(["line 4"], "x,y\n0,0\n1,0\n2,\n", "p.csv")
        self.refuses_text(["line 2"], "0 0\n1\n2 2\n")

    def test_missing_columns(self):
        self.refuses_text(["p.csv", "column"], "a,b\n0,0\n1,0\n0,1\n", "p.csv")
        self.refuses_text(["height"], "x,y\n0,0\n1,0\n0,1\n", "p.csv", "--columns", "x,y,height")

    def test_bad_geojson(self):
        self.refuses_text(["p.geojson"], '{"type": "FeatureCollection", ', "p.geojson")
        self.refuses_text(["p.geojson"], '{"type": "Topology"}', "p.geojson")

    def test_too_few_points(self):
        self.refuses_text(["three"], "0 0\n1 1\n")
        self.refuses_text(["three"], "0 0\n1 1\n0 0\n1 1\n")

    def test_all_on_one_line(self):
        self.refuses_text(["line"], "0 0\n1 1\n2 2\n3 3\n")

    def test_unwritable_output(self):
        self.write("p.xyz", SQUARE)
        self.refuses(3, ["nowhere"], "quadrangulate", "p.xyz", "-o", "nowhere/m.obj")
        self.refuses(3, ["nowhere"], "quadrangulate", "p.xyz", "-o", "m.obj", "--picture",
                     "nowhere/m.png")
        self.refuses(3, ["nowhere"], "quadrangulate", "p.xyz", "-o", "m.obj", "--report",
                     "nowhere/m.json")
        self.refuses(3, ["nowhere"], "generate", "grid", "-o", "nowhere/p.xyz")
        os.mkdir(self.folder / "taken.obj")
        self.refuses(3, ["taken.obj"], "quadrangulate", "p.xyz", "-o", "taken.obj")

    def test_a_failure_keeps_the_old_output(self):
        self.write("m.obj", "what was there before\n")
        self.write("p.xyz", "0 0\n1 1\n2 2\n")
        self.refuses(3, [], "quadrangulate", "p.xyz", "-o", "m.obj")
        self.assertEqual((self.folder / "m.obj").read_text(), "what was there before\n")

    def test_broken_meshes(self):
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        for verb in (["check", "m.obj"], ["quality", "m.obj"], ["draw", "m.obj", "-o", "m.png"]):
            with self.subTest(verb[0]):
                self.refuses(3, ["m.obj"], *verb)
        self.write("m.off", "OFF\n4 1 0\n0 0 0\n")
        self.refuses(3, ["m.off"], "check", "m.off")


if __name__ == "__main__":
    main()
