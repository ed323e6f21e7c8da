"""Help, version, and command lines that make no sense: exit code 2."""

from harness import SQUARE, CommandLine, main

VERBS = ["quadrangulate", "triangulate", "check", "quality", "draw", "generate", "layers", "polygonize", "compare"]


class Usage(CommandLine):
    def test_version(self):
        self.assertRegex(self.succeeds("--version").stdout, r"^quadloom \d+\.\d+\.\d+\n$")

    def test_help_names_every_verb(self):
        text = self.succeeds("--help").stdout
        for verb in VERBS:
            self.assertIn(verb, text)

    def test_every_verb_has_help_with_an_example(self):
        for verb in VERBS:
            with self.subTest(verb):
                text = self.succeeds(verb, "--help").stdout
                self.assertIn(f"  quadloom {verb} ", text)

    def test_threads(self):
        self.assertIn("--threads", self.succeeds("--help").stdout)
        made = ["generate", "uniform", "-n", "9", "-o", "-"]
        points = self.succeeds(*made).stdout
        self.assertEqual(self.succeeds("--threads", "1", *made).stdout, points)
        self.assertEqual(self.succeeds(*made, "--threads", "3").stdout, points)
        for word in ["0", "-1", "two"]:
            self.refuses(2, ["--threads", word], *made, f"--threads={word}")

    def test_no_verb(self):
        self.refuses(2, ["subcommand"])

    def test_unknown_verb(self):
        self.refuses(2, ["no command 'pentagonate'"], "pentagonate", "x.csv")
        self.refuses(2, ["no command 'pentagonate'"], "--threads", "2", "pentagonate", "x.csv")

    def test_unknown_option(self):
        self.refuses(2, ["--fast"], "quadrangulate", "x.csv", "-o", "x.obj", "--fast")

    def test_missing_output(self):
        self.refuses(2, ["--output"], "quadrangulate", "x.csv")

    def test_bad_words(self):
        self.write("p.xyz", SQUARE)
        for flag, word in [("--method", "magic"), ("--odd-boundary", "inside"), ("--k", "3"),
                           ("--k", "four"), ("--seed", "x")]:
            with self.subTest(flag=flag, word=word):
                self.refuses(2, [flag, word], "quadrangulate", "p.xyz", "-o", "m.obj", flag, word)
        self.refuses(2, ["--colour", "red"], "draw", "m.obj", "-o", "m.png", "--colour", "red")

    def test_bad_choice_names_the_words(self):
        self.refuses(2, ["delaunay", "insertion", "spiral", "subdivide"], "quadrangulate", "p.xyz",
                     "-o", "m.obj", "--method", "magic")

    def test_options_that_exclude_each_other(self):
        self.write("p.xyz", SQUARE)
        self.refuses(2, ["--k"], "quadrangulate", "p.xyz", "-o", "m.obj", "--k", "5", "--method",
                     "insertion")
        self.refuses(2, ["--odd-boundary"], "quadrangulate", "p.xyz", "-o", "m.obj", "--k", "5",
                     "--odd-boundary", "triangle")

    def test_unknown_formats(self):
        self.write("p.xyz", SQUARE)
        self.refuses(2, [".stl"], "quadrangulate", "p.xyz", "-o", "m.stl")
        self.refuses(2, ["m.jpg"], "quadrangulate", "p.xyz", "-o", "m.obj", "--picture", "m.jpg")
        self.refuses(2, ["p.abc"], "generate", "uniform", "-n", "9", "-o", "p.abc")

    def test_generate(self):
        self.refuses(2, ["rotated-grid", "'squares'"], "generate", "squares", "-o", "p.xyz")
        self.refuses(2, ["at least 3"], "generate", "uniform", "-n", "2", "-o", "p.xyz")
        self.refuses(2, ["-n"], "generate", "uniform", "-n", "many", "-o", "p.xyz")
        self.refuses(2, ["-n"], "generate", "uniform", "-n", "-5", "-o", "p.xyz")


if __name__ == "__main__":
    main()
