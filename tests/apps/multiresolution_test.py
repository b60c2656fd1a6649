"""limes multiresolution, decompose and reconstruct as a user meets them: files in and out, errors, JSON.

Run by CTest as: python3 multiresolution_test.py LIMES LIMES_CHECK EXAMPLES
"""

import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import unittest

from limes_case import LimesCase
import zlib

LIMES_CHECK, EXAMPLES = sys.argv[2], pathlib.Path(sys.argv[3])


def png(width, height, channels, sample):
    """An 8 bit PNG image."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(sample(x, y, c) for x in range(width) for c in range(channels)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Multiresolution(LimesCase):
    def result(self, *arguments):
        run = self.limes(*arguments, "--json")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return json.loads(run.stdout)

    def write(self, name, content):
        if isinstance(content, bytes):
            (self.dir / name).write_bytes(content)
        else:
            (self.dir / name).write_text(content)
        return name

    def filters(self, scheme="chaikin", *arguments):
        self.result("multiresolution", scheme, "-o", "f.json", *arguments)
        return "f.json"

    def numbers(self, name):
        return [[float(x) for x in line.split(",")] for line in (self.dir / name).read_text().splitlines()]

    def curve(self, n=64, name="curve.csv"):
        return self.write(name, "".join(
            f"{math.cos(2 * math.pi * i / n) + 0.05 * math.sin(16 * math.pi * i / n)!r},{math.sin(2 * math.pi * i / n)!r}\n" for i in range(n)))

    # ---- filters

    def test_chaikin_is_certified_with_the_published_filters(self):
        result = self.result("multiresolution", "chaikin")
        self.assertEqual(result["q"], ["1/4", "3/4", "-3/4", "-1/4"])
        self.assertEqual(result["a"], ["-1/4", "3/4", "3/4", "-1/4"])
        self.assertEqual((result["shift"], result["extension"], result["verdict"]), (0, 0, "certified"))
        low, high = map(float, result["orthogonality_error"])
        self.assertLessEqual(low, math.sqrt(9 / 32))
        self.assertAlmostEqual(high, 0.53033, places=5)
        checked = subprocess.run([LIMES_CHECK, result["certificate"]], cwd=self.dir, capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertIn("theorem B1", checked.stdout)

    def test_extension_threshold_shift_and_precision(self):
        self.assertEqual(self.result("multiresolution", "chaikin", "--extension", 2)["extension"], 2)
        result = self.result("multiresolution", "chaikin", "--threshold", "1/10")
        self.assertLessEqual(float(result["orthogonality_error"][1]), 0.1)
        self.assertGreater(float(result["steps"][-2]["orthogonality_error"][0]), 0.1)
        self.assertEqual(self.result("multiresolution", "chaikin", "--shift", -2)["shift"], -2)
        rounded = self.result("multiresolution", "b-spline-3", "--precision", "double")
        self.assertEqual((rounded["verdict"], rounded["certificate"]), ("undecided", None))
        exact = self.result("multiresolution", "b-spline-3", "--precision", 40)
        for x, y in zip(rounded["q_decimal"], exact["q_decimal"]):
            self.assertAlmostEqual(float(x), float(y), places=13)
        run = self.limes("multiresolution", "chaikin", "--threshold", "1/1000000", "--extension", 4)
        self.assertEqual(run.returncode, 3)
        self.assertIn("not reached", run.stdout)

    def test_plot(self):
        self.result("multiresolution", "chaikin", "--extension", 8, "--plot", "e.svg", "--beside", "b-spline-3")
        self.assertIn("b-spline-3", (self.dir / "e.svg").read_text())
        self.result("multiresolution", "chaikin", "--extension", 2, "--plot", "e.csv", "--beside", "b-spline-3")
        lines = (self.dir / "e.csv").read_text().splitlines()
        self.assertEqual(lines[0], "scheme,length,error")
        self.assertEqual([line.rsplit(",", 1)[0] for line in lines[1:]], ["chaikin,4", "chaikin,6", "b-spline-3,6", "b-spline-3,8"])
        self.assertAlmostEqual(float(lines[1].split(",")[2]), 0.53033, places=5)

    def test_wrong_schemes_and_options(self):
        self.assert_bad_input(self.limes("multiresolution", "cr2"), "uniform binary")
        self.assert_bad_input(self.limes("multiresolution", "ternary-four-point"), "uniform binary")
        self.assert_bad_input(self.limes("multiresolution", "four-point"), "--param w=VALUE")
        self.assert_bad_input(self.limes("multiresolution", "chaikin", "--extension", 3), "even")
        self.assert_bad_input(self.limes("multiresolution", "chaikin", "--shift", 1), "shift 1")
        self.assert_bad_input(self.limes("multiresolution", "chaikin", "--precision", "many"), "--precision many")
        self.assert_bad_input(self.limes("multiresolution", "chaikin", "--threshold", "much"), "--threshold much")
        self.assert_bad_input(self.limes("multiresolution", "chaikin", "--plot", "x.pdf"), "x.pdf")
        self.write("box.toml", 'name = "box"\nkind = "uniform"\n[uniform]\nmask = ["1/2", "1/2", "1/2", "1/2"]\n')
        self.assert_bad_input(self.limes("multiresolution", "./box.toml"), "common zero")

    # ---- data

    def test_curves_come_back(self):
        for scheme, extra in (("chaikin", ["--extension", 2]), ("b-spline-3", []), ("four-point", ["--param", "w=1/16", "--extension", 8])):
            filters = self.filters(scheme, *extra)
            curve = self.curve()
            for ends in (["--closed"], [], ["--ends", "whole"], ["--closed", "--homogeneous"]):
                report = self.result("decompose", curve, "--filters", filters, "--levels", 3, "-o", "p", "--coarse", "c.csv", *ends)
                self.assertEqual((report["levels"], report["columns"]), (3, 64))
                self.assertEqual(len(self.numbers("c.csv")), 8)
                report = self.result("reconstruct", "p", "--filters", filters, "-o", "out.csv", "--compare", curve)
                self.assertLess(report["maximum_difference"], 1e-12)
                self.result("reconstruct", "p", "--filters", filters, "--levels", 0, "-o", "c0.csv")
                self.assertEqual(self.numbers("c0.csv"), self.numbers("c.csv"))

    def test_macroscopic_editing_moves_details_along(self):
        filters = self.filters("chaikin", "--extension", 2)
        curve = self.curve()
        self.result("decompose", curve, "--filters", filters, "--levels", 3, "--closed", "-o", "p", "--coarse", "c.csv")
        self.write("moved.csv", "".join(f"{x + 5!r},{y - 2!r}\n" for x, y in self.numbers("c.csv")))
        self.result("reconstruct", "p", "--filters", filters, "--coarse", "moved.csv", "-o", "out.csv")
        for (x, y), (u, v) in zip(self.numbers(curve), self.numbers("out.csv")):
            self.assertAlmostEqual(x + 5, u, places=10)
            self.assertAlmostEqual(y - 2, v, places=10)

    def test_homogeneous_weights_make_translation_exact_without_sum_rules(self):
        self.write("m.toml", 'name = "m"\nkind = "uniform"\n[uniform]\nmask = ["0.109218", "0.520687", "0.747163", "0.520687", "0.109218"]\n')
        filters = self.filters("./m.toml", "--extension", 4)
        self.curve()
        for homogeneous in ([], ["--homogeneous"]):
            self.result("decompose", "curve.csv", "--filters", filters, "--levels", 3, "--closed", "-o", "p", "--coarse", "c.csv", *homogeneous)
            self.write("moved.csv", "".join(f"{x + 5!r},{y!r}\n" for x, y in self.numbers("c.csv")))
            self.result("reconstruct", "p", "--filters", filters, "--coarse", "c.csv", "-o", "same.csv")
            self.result("reconstruct", "p", "--filters", filters, "--coarse", "moved.csv", "-o", "out.csv", "--drop", 3)
            self.result("reconstruct", "p", "--filters", filters, "--coarse", "c.csv", "-o", "out0.csv", "--drop", 3)
            shifts = [u[0] - x[0] for x, u in zip(self.numbers("out0.csv"), self.numbers("out.csv"))]
            spread = max(abs(shift - 5) for shift in shifts)
            (self.assertLess if homogeneous else self.assertGreater)(spread, 1e-9 if homogeneous else 1e-4)

    def test_refining_without_details_is_subdivision(self):
        filters = self.filters("chaikin", "--extension", 6)
        self.write("square.csv", "0,0\n1,0\n1,1\n0,1\n")
        self.result("reconstruct", "square.csv", "--filters", filters, "--closed", "--levels", 1, "-o", "out.csv")
        points = self.numbers("out.csv")
        self.assertEqual(len(points), 8)
        self.assertEqual(sorted(map(tuple, points)), sorted([(.25, 0), (.75, 0), (1, .25), (1, .75), (.75, 1), (.25, 1), (0, .75), (0, .25)]))

    def test_heights(self):
        filters = self.filters("four-point", "--param", "w=1/16", "--extension", 2)
        generator = random.Random(1)
        self.write("h.csv", "".join(",".join(repr(generator.random()) for _ in range(96)) + "\n" for _ in range(32)))
        self.result("decompose", "h.csv", "--heights", "--filters", filters, "--levels", 3, "-o", "p", "--coarse", "c.csv")
        self.assertEqual((len(self.numbers("c.csv")), len(self.numbers("c.csv")[0])), (4, 12))
        report = self.result("reconstruct", "p", "--filters", filters, "-o", "out.csv", "--compare", "h.csv")
        self.assertLess(report["maximum_difference"], 1e-12)

    def test_images_lossless_and_lossy(self):
        filters = str(EXAMPLES / "cdf-9-7.json")
        for channels in (1, 3):
            self.write("i.png", png(64, 48, channels, lambda x, y, c: (x * 3 + y * (c + 1) + (x * y) % 7) % 256))
            self.result("decompose", "i.png", "--filters", filters, "--levels", 3, "--ends", "whole", "-o", "p", "--coarse", "c.png")
            report = self.result("reconstruct", "p", "--filters", filters, "-o", "out.png", "--compare", "i.png")
            self.assertEqual((report["psnr"], report["maximum_difference"]), (None, 0))
            before = 0
            for keep in (0.05, 0.2, 0.5):
                report = self.result("reconstruct", "p", "--filters", filters, "-o", "out.png", "--compare", "i.png", "--keep", keep)
                self.assertGreater(report["psnr"], before)
                self.assertEqual("luminosity_psnr" in report, channels == 3)
                before = report["psnr"]
        self.assertLess(self.result("reconstruct", "p", "--filters", filters, "-o", "out.png", "--drop", 1)["details"]["kept"],
                        self.result("reconstruct", "p", "--filters", filters, "-o", "out.png", "--threshold", 0)["details"]["kept"])

    def test_results_do_not_depend_on_threads(self):
        filters = str(EXAMPLES / "cdf-9-7.json")
        self.write("i.png", png(256, 128, 1, lambda x, y, c: (x * x + y * 5) % 251))
        for threads in (1, 4):
            self.result("decompose", "i.png", "--filters", filters, "--levels", 4, "--threads", threads, "-o", f"p{threads}")
        self.assertEqual((self.dir / "p1").read_bytes(), (self.dir / "p4").read_bytes())

    def test_wrong_data(self):
        filters = self.filters()
        curve = self.curve()
        decompose = lambda data, *more: self.limes("decompose", data, "--filters", filters, "-o", "p", *more)
        self.assert_bad_input(decompose(curve, "--levels", 7), curve, "64 points", "128")
        self.assert_bad_input(decompose(self.write("odd.csv", "0,0\n1,1\n2,2\n")), "odd.csv", "3 points")
        self.assert_bad_input(decompose(self.write("empty.csv", "# nothing\n")), "empty.csv", "no numbers")
        self.assert_bad_input(decompose(self.write("nan.csv", "0,0\n1,nan\n")), "nan.csv:2", "not a finite number")
        self.assert_bad_input(decompose(self.write("text.png", "no image")), "text.png", "no PNG")
        self.assert_bad_input(decompose("absent.png"), "absent.png")
        self.assert_bad_input(decompose(self.write("odd.png", png(6, 5, 1, lambda x, y, c: 0))), "odd.png", "5 rows")
        self.assert_bad_input(self.limes("decompose", curve, "--filters", curve, "-o", "p"), curve, "no JSON")
        self.assert_bad_input(self.limes("decompose", curve, "--filters", "absent.json", "-o", "p"), "absent.json")
        self.assert_bad_input(decompose(curve, "--coarse", "c.png"), "points are no image")
        self.assertEqual(decompose(curve, "--levels", 2).returncode, 0)
        reconstruct = lambda *more: self.limes("reconstruct", "p", "--filters", filters, *more)
        self.assert_bad_input(reconstruct("-o", "x.png"), "points are no image")
        self.assert_bad_input(reconstruct("-o", "x.txt"), "x.txt")
        self.assert_bad_input(reconstruct("-o", "x.csv", "--levels", 3), "--levels 3", "has 2")
        self.assert_bad_input(reconstruct("-o", "x.csv", "--drop", 1, "--keep", 0.5), "exclude each other")
        self.assert_bad_input(reconstruct("-o", "x.csv", "--coarse", curve), curve, "1 x 16")
        self.assert_bad_input(reconstruct("-o", "x.csv", "--compare", self.write("two.csv", "1,2\n3,4\n")), "two.csv")
        self.result("multiresolution", "b-spline-3", "-o", "other.json")
        self.assert_bad_input(self.limes("reconstruct", "p", "--filters", "other.json", "-o", "x.csv"), "other filters")
        (self.dir / "p").write_bytes((self.dir / "p").read_bytes()[:-3])
        self.assert_bad_input(reconstruct("-o", "x.csv"), "damaged")

    def test_pywavelets_has_the_same_coefficients(self):
        try:
            import numpy
            import pywt
        except ImportError:
            self.skipTest("python3-pywt is not installed")
        filters = str(EXAMPLES / "cdf-9-7.json")
        self.write("i.png", png(64, 32, 1, lambda x, y, c: (x * x * 3 + y * y * 5 + x * y) % 256))
        self.result("decompose", "i.png", "--filters", filters, "--levels", 1, "--closed", "-o", "p")
        data = (self.dir / "p").read_bytes()
        ours = numpy.frombuffer(data[data.index(b"\n") + 1:], dtype="<f8").reshape(32, 64)
        image = numpy.fromfunction(lambda y, x: (x * x * 3 + y * y * 5 + x * y) % 256, (32, 64))
        coarse, details = pywt.dwt2(image, "bior4.4", "periodization")
        # Their low-pass filter has the norm of an orthogonal one: a factor sqrt(2) in each direction.
        same = lambda a, b: min(numpy.abs(numpy.roll(a, (i, k), (0, 1)) - b).max() for i in (-2, -1, 0, 1, 2) for k in (-2, -1, 0, 1, 2))
        self.assertLess(same(coarse / 2, ours[:16, :32]), 1e-9)
        diagonal = min(same(2 * details[2], ours[16:, 32:]), same(-2 * details[2], ours[16:, 32:]))
        self.assertLess(diagonal, 1e-9)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=1)
