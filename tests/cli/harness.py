"""What the tests of the command line share: runs the program in a folder of its own."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

APP = os.path.abspath(os.environ.get("QUADLOOM_APP", "quadloom"))

SQUARE = "0 0\n2 0\n2 2\n0 2\n0.5 1\n1.25 0.75\n"
TRIANGLE = "0 0\n4 0\n0 4\n1 1\n"  # an odd hull

CHAIN = [  # a command of each kind, from points.xyz and the files of those before; the last word is the file that it writes
    ["quadrangulate", "points.xyz", "-o", "quads.obj"],
    ["quadrangulate", "points.xyz", "--method", "spiral", "-o", "spiral.obj"],
    ["quadrangulate", "points.xyz", "--convex", "-o", "convex.vtu"],
    ["triangulate", "points.xyz", "-o", "triangles.off"],
    ["quadrangulate", "triangles.off", "-o", "of-triangles.ply"],
    ["strip", "triangles.off", "-o", "triangles.strip"],
    ["polygonize", "points.xyz", "-o", "polygon.geojson"],
]


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def files(self):
        return sorted(p.name for p in self.folder.rglob("*"))

    def run_app(self, *args, stdin=""):
        return subprocess.run([APP, *map(str, args)], cwd=self.folder, input=stdin,
                              capture_output=True, text=True)

    def succeeds(self, *args, stdin=""):
        run = self.run_app(*args, stdin=stdin)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refuses(self, code, fragments, *args, stdin=""):
        """Fails with that code and one sentence that holds the fragments; leaves no file behind."""
        before = self.files()
        run = self.run_app(*args, stdin=stdin)
        self.assertEqual(run.returncode, code, f"{args}: {run.stdout} {run.stderr}")
        self.assertEqual(run.stdout, "")
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        self.assertTrue(run.stderr.startswith("quadloom: "), run.stderr)
        for fragment in fragments:
            self.assertIn(fragment, run.stderr)
        self.assertEqual(self.files(), before)
        return run.stderr


def read_xyz(path):
    with open(path) as f:
        return [tuple(map(float, line.split()[:2])) for line in f if line.strip()]


def main():
    if not os.access(APP, os.X_OK):
        sys.exit(f"set QUADLOOM_APP to the program; '{APP}' is none")
    unittest.main(verbosity=2)
