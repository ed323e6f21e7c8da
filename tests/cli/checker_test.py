"""The independent checker itself: right meshes pass, each kind of fault is found."""

import pathlib
import tempfile
import unittest

from independent_check import Wrong, check, check_mesh

POINTS = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (1, 2)]
HEAD = "".join(f"v {x} {y} 0\n" for x, y in POINTS)


class Checker(unittest.TestCase):
    def judge(self, faces, head=HEAD, points=POINTS, **limits):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "m.obj"
            path.write_text(head + faces)
            return check(path, points, **limits)

    def test_right(self):
        self.assertEqual(self.judge("f 1 5 6 4\nf 5 2 3 6\n"), 0)
        self.assertEqual(self.judge("f 1 5 6 4\nf 5 2 3 6\n", points=POINTS[:4]), 2)

    def test_wrong(self):
        for name, faces in {
            "no faces": "",
            "missing half": "f 1 5 6 4\n",
            "clockwise": "f 4 6 5 1\nf 5 2 3 6\n",
            "crossing": "f 1 6 5 4\nf 5 2 3 6\n",
            "twice": "f 1 5 6 4\nf 5 2 3 6\nf 5 2 3 6\n",
            "two triangles": "f 1 5 6 4\nf 5 2 6\nf 2 3 6\n",
            "five corners": "f 1 5 2 3 6\nf 1 6 4\n",
            "out of range": "f 1 5 6 7\nf 5 2 3 6\n",
            "missing point": "f 1 2 3 4\n",
        }.items():
            with self.subTest(name), self.assertRaises(Wrong):
                self.judge(faces)

    def test_t_junction_and_folds(self):
        with self.assertRaises(Wrong):  # the middle of the lower edge belongs to one face only
            self.judge("f 1 2 6 4\nf 5 2 3 6\n")
        with self.assertRaises(Wrong):  # 1 5 2 5: folds back
            self.judge("f 1 2 5 4\nf 2 3 6 5\nf 4 5 6\n", triangles=1)

    def judge_mesh(self, source, mesh, **limits):
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / name for name in ("m.obj", "s.obj")]
            for path, text in zip(paths, (mesh, source)):
                path.write_text(text)
            return check_mesh(*paths, **limits)

    def test_meshes(self):
        source = HEAD + "f 1 5 6\nf 1 6 4\nf 5 2 3\nf 5 3 6\n"
        self.assertEqual(self.judge_mesh(source, HEAD + "f 1 5 6 4\nf 5 2 3 6\n"), 0)
        middle, out = "v 2 1 0\n", "v 3 1 0\n"
        faces = "f 1 5 6 4\nf 5 2 7\nf 5 7 3 6\n"
        self.assertEqual(self.judge_mesh(source, HEAD + middle + faces, triangles=1, split=1), 1)
        self.assertEqual(self.judge_mesh(source, HEAD + out + faces, triangles=1, outside=1), 1)
        for name, (mesh, limits) in {
            "not allowed to split": (HEAD + middle + faces, {"triangles": 1}),
            "on, not outside": (HEAD + middle + faces, {"triangles": 1, "outside": 1}),
            "moved inwards": (HEAD + "v 1.5 1 0\n" + faces, {"triangles": 1, "split": 1}),
            "a triangle": (HEAD + middle + faces, {"split": 1}),
            "half": (HEAD + "f 1 5 6 4\n", {}),
            "moved": (HEAD.replace("v 1 2", "v 1 2.5") + "f 1 5 6 4\nf 5 2 3 6\n", {}),
        }.items():
            with self.subTest(name), self.assertRaises(Wrong):
                self.judge_mesh(source, mesh, **limits)


if __name__ == "__main__":
    unittest.main(verbosity=2)
