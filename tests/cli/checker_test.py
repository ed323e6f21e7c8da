"""The independent checker itself: right meshes pass, each kind of fault is found."""

import pathlib
import tempfile
import unittest

from independent_check import Wrong, check

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


if __name__ == "__main__":
    unittest.main(verbosity=2)
