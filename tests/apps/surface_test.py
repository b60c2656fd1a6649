"""limes refine of meshes, as a user meets it: bad meshes are named in one line.

Run by CTest as: python3 surface_test.py LIMES
"""

import subprocess
import sys
import unittest

from limes_case import LimesCase

LIMES = sys.argv[1]

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


class Surfaces(LimesCase):
    def refine(self, text, *arguments):
        (self.dir / "mesh.obj").write_text(text)
        return self.limes("refine", "unified", "mesh.obj", "--param", "theta=pi/3", "--param", "type=trigonometric", "--levels", "2",
                          "-o", "out.obj", *arguments)

    def assert_bad_input(self, run, *parts):
        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, "one clear line: " + run.stderr)
        for part in ("mesh.obj",) + parts:
            self.assertIn(part, run.stderr)
        self.assertFalse((self.dir / "out.obj").exists())

    def test_a_good_mesh(self):
        run = self.refine(SQUARE + "f 1 2 3 4\n")
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = (self.dir / "out.obj").read_text().splitlines()
        self.assertEqual(sum(line.startswith("v ") for line in lines), 25)
        self.assertEqual(sum(line.startswith("f ") for line in lines), 16)

    def test_what_cannot_be_read(self):
        self.assert_bad_input(self.refine(SQUARE), "no face")
        self.assert_bad_input(self.refine(""), "no face")
        self.assert_bad_input(self.refine(SQUARE + "f 1 2 3 5\n"), "mesh.obj:5", "vertex 5 is not defined")
        self.assert_bad_input(self.refine(SQUARE + "f 1 2 3 0\n"), "mesh.obj:5", "'0' is no vertex")
        self.assert_bad_input(self.refine(SQUARE + "f 1 2\n"), "mesh.obj:5", "three vertices")
        self.assert_bad_input(self.refine("v 0 0\n" + SQUARE + "f 1 2 3 4\n"), "mesh.obj:1", "three coordinates")
        self.assert_bad_input(self.refine("v 0 nan 0\n" + SQUARE + "f 1 2 3 4\n"), "mesh.obj:1", "'nan' is no coordinate")

    def test_faces_that_are_no_surface(self):
        self.assert_bad_input(self.refine(SQUARE + "f 1 2 3 3\n"), "face 1 has vertex 3 twice")
        self.assert_bad_input(self.refine(SQUARE + "v 2 2 2\nf 1 2 3 4\n"), "vertex 5 belongs to no face")
        three = "v 1 0 1\nv 0 0 1\nv 1 0 -1\nv 0 0 -1\n"
        self.assert_bad_input(self.refine(SQUARE + three + "f 1 2 3 4\nf 2 1 6 5\nf 1 2 7 8\n"), "edge of vertices 1 and 2 has more than two faces")
        self.assert_bad_input(self.refine(SQUARE + three + "f 1 2 3 4\nf 1 2 5 6\nf 4 3 7 8\n"), "faces 1 and 2 have opposite orientations at the edge of vertices 1 and 2")
        two = "v 2 1 0\nv 2 2 0\nv 1 2 0\n"
        self.assert_bad_input(self.refine(SQUARE + two + "f 1 2 3 4\nf 3 5 6 7\n"), "faces at vertex 3 do not form one fan")
        self.assert_bad_input(self.refine(SQUARE + "f 1 2 3 4\nl 1 3\n"), "vertices 1 and 3 is no edge")

    # Faces that are no quadrilaterals are split first; the names are those of the file.
    def test_triangles_that_are_no_surface(self):
        points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
        self.assert_bad_input(self.refine(points + "f 1 2 3\nf 2 1 4\nf 1 2 5\n"), "edge of vertices 1 and 2 has more than two faces")
        self.assert_bad_input(self.refine(points + "f 1 2 3\nf 1 2 4\nf 2 1 5\n"), "faces 1 and 2 have opposite orientations at the edge of vertices 1 and 2")
        self.assert_bad_input(self.refine(points + "f 1 2 3\nf 2 1 5\n"), "vertex 4 belongs to no face")
        self.assert_bad_input(self.refine(points + "f 1 2 3\nf 2 1 4\nf 4 5 4\n"), "face 3 has vertex 4 twice")
        self.assert_bad_input(self.refine(points + "f 1 2 3\nf 3 4 5\n"), "faces at vertex 3 do not form one fan")

    def test_extraordinary_vertices_need_one_angle(self):
        cube = "".join(f"v {k & 1} {k >> 1 & 1} {k >> 2 & 1}\n" for k in range(8))
        cube += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
        self.assertEqual(self.refine(cube).returncode, 0)
        (self.dir / "out.obj").unlink()
        run = subprocess.run([LIMES, "refine", "unified", "mesh.obj", "--param", "theta1=1", "--param", "theta2=1/2", "--levels", "1", "-o", "out.obj"],
                             cwd=self.dir, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False)
        self.assert_bad_input(run, "same angle")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
