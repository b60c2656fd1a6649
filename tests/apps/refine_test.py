"""limes refine as a user meets it: files in and out, errors, JSON.

Run by CTest as: python3 refine_test.py LIMES EXAMPLES
"""

import json
import pathlib
import sys
import unittest

from limes_case import LimesCase

EXAMPLES = pathlib.Path(sys.argv[2])
LINE = "0,0\n1,2\n2,4\n3,6\n4,8\n5,10\n6,12\n7,14\n"


class Refine(LimesCase):
    def refine(self, *arguments):
        return self.limes("refine", *arguments)

    def write(self, name, text):
        (self.dir / name).write_text(text)
        return name

    def points(self, name):
        return [[float(x) for x in line.split(",")] for line in (self.dir / name).read_text().splitlines()]

    def refined(self, scheme, data, *arguments):
        run = self.refine(scheme, data, "-o", "out.csv", *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return self.points("out.csv")

    def test_uniform_scheme_keeps_the_points(self):
        self.write("line.csv", LINE)
        points = self.refined("four-point", "line.csv", "--param", "w=1/16", "--levels", 3)
        self.assertEqual(len(points), 57)
        self.assertEqual(points[::8], self.points("line.csv"))
        for x, y in points:
            self.assertAlmostEqual(y, 2 * x, places=12)

    def test_nonuniform_schemes_keep_lines_over_matching_knots(self):
        knots = [0, 1, 1.25, 4, 6, 6.5, 9, 10, 12, 12.5, 14]
        self.write("knots.txt", "# own knots\n" + "".join(f"{t}\n" for t in knots))
        self.write("line.csv", "".join(f"{t},{3 - 2 * t}\n" for t in knots))
        for scheme, parameter in (("cr1", "w=1/16"), ("cr2", "w=1/96"), ("a2-5-3", "w=3/256"), ("ten-point-nonuniform",
                                                                                                "w=1/1000")):
            points = self.refined(scheme, "line.csv", "--param", parameter, "--levels", 4, "--knots", "knots.txt")
            self.assertEqual(len(points), 161)
            for i, (x, y) in enumerate(points):
                a, b = knots[i // 16], knots[min(i // 16 + 1, 10)]
                self.assertAlmostEqual(x, a + (b - a) * (i % 16) / 16, places=10)
                self.assertAlmostEqual(y, 3 - 2 * x, places=10)

    def test_spacings_differ_and_centripetal_is_the_default(self):
        results = {}
        for knots in ("uniform", "chordal", "centripetal"):
            results[knots] = self.refined("cr2", EXAMPLES / "beetle.csv", "--closed", "--param", "w=1/96", "--knots",
                                          knots)
        self.assertEqual(results["centripetal"], self.refined("cr2", EXAMPLES / "beetle.csv", "--closed", "--param",
                                                              "w=1/96"))
        self.assertNotEqual(results["uniform"], results["chordal"])
        self.assertNotEqual(results["centripetal"], results["chordal"])
        # Over equal intervals a non-uniform scheme is its uniform one.
        uniform = self.refined("six-point", EXAMPLES / "beetle.csv", "--closed", "--param", "w=1/96")
        self.assertEqual(len(uniform), len(results["uniform"]))
        for p, q in zip(uniform, results["uniform"]):
            self.assertAlmostEqual(p[0], q[0], places=12)
            self.assertAlmostEqual(p[1], q[1], places=12)

    def test_one_level_twice_is_two_levels(self):
        self.write("square.csv", (EXAMPLES / "square.csv").read_text())
        twice = self.refined("chaikin", "square.csv", "--closed", "--levels", 2)
        self.refine("chaikin", "square.csv", "--closed", "--levels", 1, "-o", "once.csv")
        self.assertEqual(self.refined("chaikin", "once.csv", "--closed", "--levels", 1), twice)
        self.assertEqual(self.refined("chaikin", "square.csv", "--closed", "--levels", 0), self.points("square.csv"))

    def test_ends(self):
        self.write("line.csv", LINE)
        shrunk = self.refined("four-point", "line.csv", "--param", "w=1/16", "--levels", 4, "--ends", "shrink")
        extended = self.refined("four-point", "line.csv", "--param", "w=1/16", "--levels", 4, "--ends", "extend")
        self.assertLess(len(shrunk), len(extended))
        self.assertEqual(extended[0], [0, 0])
        self.assertEqual(extended[-1], [7, 14])
        self.assertLess(self.refined("b-spline-3", "line.csv", "--levels", 6)[-1][0], 6.1)

    def test_pictures(self):
        outputs = ["out.svg", "out.pgf", "out.png", "out.csv"]
        arguments = ["cr2", EXAMPLES / "beetle.csv", "--closed", "--param", "w=1/96", "--comb", "0.2"]
        for name in outputs:
            arguments += ["-o", name]
        run = self.refine(*arguments, "--json")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(json.loads(run.stdout), {"outputs": [{"file": name, "kind": name[4:]} for name in outputs]})
        first = {name: (self.dir / name).read_bytes() for name in outputs}
        self.assertTrue(first["out.svg"].startswith(b"<svg"))
        self.assertIn(b"cr2, w = 1/96, centripetal knots", first["out.svg"])
        self.assertIn(b"\\begin{tikzpicture}", first["out.pgf"])
        self.assertTrue(first["out.png"].startswith(b"\x89PNG"))
        self.refine(*arguments, "--threads", "1")
        self.assertEqual({name: (self.dir / name).read_bytes() for name in outputs}, first, "same input, same bytes")
        without = [*arguments[:5], "-o", "plain.svg"]
        self.assertEqual(self.refine(*without).stdout, "plain.svg: 960 points\n")
        self.assertLess((self.dir / "plain.svg").stat().st_size, len(first["out.svg"]))
        self.assertEqual(self.refine(*without, "--quiet").stdout, "")

    def test_points_in_space(self):
        points = self.refined("four-point", EXAMPLES / "helix.csv", "--param", "w=1/16")
        self.assertTrue(all(len(p) == 3 for p in points))
        self.assertEqual(self.refine("four-point", EXAMPLES / "helix.csv", "--param", "w=1/16", "--comb", "1", "-o",
                                     "a.svg").returncode, 0)

    def test_bad_points(self):
        def bad(text, *parts, arguments=("four-point", "bad.csv", "--param", "w=1/16")):
            self.write("bad.csv", text)
            self.assert_bad_input(self.refine(*arguments, "-o", "out.csv"), *parts)
            self.assertFalse((self.dir / "out.csv").exists())
        bad("0,0\n1,one\n", "bad.csv:2", "'one' is not a number")
        bad("0,0\n1,NaN\n", "bad.csv:2", "'NaN' is not a finite number")
        bad("0,0\n1,inf\n", "bad.csv:2", "'inf' is not a finite number")
        bad("0,0\n1,1e999\n", "bad.csv:2", "range of double precision")
        bad("0,0\n1,1\n2,2,2\n", "bad.csv:3: 3 columns, but line 1 has 2")
        bad("", "bad.csv: the file has no numbers")
        bad("0,0\n1,1\n2,2\n", "bad.csv: 3 points are too few", "at least 4")
        bad("0,0\n1,1\n2,2\n3,2\n5,2\n", "bad.csv: 5 points are too few", "at least 6",
            arguments=("cr2", "bad.csv", "--param", "w=1/96"))
        repeated = "# six points\n0,0\n1,1\n1,1\n3,2\n5,2\n6,1\n"
        for spacing in ("chordal", "centripetal"):
            bad(repeated, "bad.csv:4: the same point as on line 3", spacing,
                arguments=("cr1", "bad.csv", "--param", "w=1/16", "--knots", spacing))
        bad("0,0\n1,1\n2,0\n1,-1\n0,0\n", "bad.csv:1: the same point as on line 5", "names its first point once",
            arguments=("cr1", "bad.csv", "--param", "w=1/16", "--closed"))
        self.write("bad.csv", repeated)
        self.assertEqual(self.refine("cr1", "bad.csv", "--param", "w=1/16", "--knots", "uniform", "-o",
                                     "out.csv").returncode, 0)
        self.assert_bad_input(self.refine("four-point", "missing.csv", "--param", "w=1/16", "-o", "out.csv"),
                              "missing.csv", "cannot read")

    def test_bad_knots(self):
        self.write("line.csv", LINE)

        def bad(text, *parts):
            self.write("knots.csv", text)
            self.assert_bad_input(self.refine("cr1", "line.csv", "--param", "w=1/16", "--knots", "knots.csv", "-o",
                                              "out.csv"), *parts)
        bad("0\n1\n2\n2\n3\n4\n5\n6\n", "knots.csv:4: knots must increase strictly")
        bad("0\n1\n2\n1.5\n3\n4\n5\n6\n", "knots.csv:4: knots must increase strictly")
        bad("0\n1\n2\n", "knots.csv: 3 knots", "needs 8")
        bad("0\n1\nnan\n", "knots.csv:3", "'nan' is not a finite number")
        self.assert_bad_input(self.refine("cr1", "line.csv", "--param", "w=1/16", "--knots", "chordial", "-o",
                                          "out.csv"), "chordial")
        self.assert_bad_input(self.refine("four-point", "line.csv", "--param", "w=1/16", "--knots", "chordal", "-o",
                                          "out.csv"), "uniform scheme")

    def test_bad_options(self):
        self.write("line.csv", LINE)
        self.write("numbers.csv", "1\n2\n4\n3\n5\n")
        good = ["four-point", "line.csv", "--param", "w=1/16"]
        self.assert_bad_input(self.refine(*good), "--output")
        self.assert_bad_input(self.refine(*good, "-o", "out.pdf"), "out.pdf", ".csv, .svg, .pgf or .png")
        self.assert_bad_input(self.refine(*good, "-o", "nowhere/out.csv"), "nowhere/out.csv")
        self.assert_bad_input(self.refine(*good, "-o", "out.csv", "--levels", "25"), "25 levels are too many",
                              "at most 19 levels")
        self.assert_bad_input(self.refine(*good, "-o", "out.csv", "--levels", "-1"))
        self.assert_bad_input(self.refine("four-point", "line.csv", "-o", "out.csv"), "--param w=")
        self.assert_bad_input(self.refine("four-point", "line.csv", "--param", "w=[0,1/8]", "-o", "out.csv"),
                              "--param w=")
        self.assert_bad_input(self.refine("four-point", "numbers.csv", "--param", "w=1/16", "-o", "out.svg"),
                              "two coordinates")
        self.assert_bad_input(self.refine(*good, "-o", "out.svg", "--comb", "nan"))
        self.assert_bad_input(self.refine("no-such-scheme", "line.csv", "-o", "out.csv"), "no-such-scheme")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
