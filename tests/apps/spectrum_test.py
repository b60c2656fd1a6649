"""limes spectrum, and scheme files with rules around extraordinary points, as a user meets them.

Run by CTest as: python3 spectrum_test.py LIMES
"""

import cmath
import json
import math
import sys
import unittest
from fractions import Fraction

from limes_case import LimesCase

OWN_SCHEME = """name = "mine"
kind = "surface"
[surface]
curve = "b-spline-3"
[surface.rules]
"0,0" = "(1 - 2/n)*at(0,0) + 1/n*mean(1,0) + 1/n*mean(1,1)"
"""


class Spectrum(LimesCase):
    def results(self, *arguments):
        run = self.limes("spectrum", *arguments, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)["results"]

    def own_scheme(self, text):
        (self.dir / "mine.toml").write_text(text)
        return "./mine.toml"

    def test_every_key_of_the_contract(self):
        results = self.results("unified", "--valence", "3..5", "--level", "0..2", "--param", "theta=pi/3", "--param", "type=hyperbolic")
        self.assertEqual([(r["level"], r["valence"]) for r in results], [(k, n) for k in range(3) for n in range(3, 6)])
        for result in results:
            n = result["valence"]
            self.assertEqual(result["size"], 1 + 6 * n)
            self.assertEqual(sum(e["multiplicity"] for e in result["eigenvalues"]), 1 + 6 * n)
            mu = math.cosh(math.pi / 3 / 2 ** (result["level"] + 1))
            self.assertLessEqual(float(result["mu_decimal"][0]), mu + 1e-15)
            self.assertGreaterEqual(float(result["mu_decimal"][1]), mu - 1e-15)
            modulus = 2
            for e in result["eigenvalues"]:
                for key in ("re", "im", "modulus"):
                    low, high = map(Fraction, e[key])
                    self.assertLessEqual(low, high)
                    self.assertLessEqual(Fraction(e[key + "_decimal"][0]), low)
                    self.assertGreaterEqual(Fraction(e[key + "_decimal"][1]), high)
                self.assertGreaterEqual(modulus, Fraction(e["modulus"][0]))
                modulus = Fraction(e["modulus"][1])
                self.assertTrue(0 <= 2 * e["fourier"] <= n)
                self.assertFalse(e["cluster"])
            self.assertEqual(result["eigenvalues"][0]["exact"], "1")

    def test_catmull_clark_for_every_valence(self):
        for result in self.results("catmull-clark", "--valence", "3..50"):
            n = result["valence"]
            c = math.cos(2 * math.pi / n)
            second = result["eigenvalues"][1]
            self.assertAlmostEqual(float(Fraction(second["re"][0])), (5 + c + math.sqrt((c + 9) * (c + 1))) / 16, 14)
            self.assertEqual((second["fourier"], second["multiplicity"]), (1, 2))
            self.assertIsNone(result["level"])

    # The matrix of valence 5 without Fourier transform: eigenvectors of the largest eigenvalues by power iteration.
    def test_a_users_own_scheme_against_its_matrix(self):
        n = 5
        result = self.results(self.own_scheme(OWN_SCHEME), "--valence", n)[0]
        size = 1 + 2 * n
        matrix = [[0.0] * size for _ in range(size)]
        edge, face = (lambda s: 1 + s % n), (lambda s: 1 + n + s % n)
        matrix[0][0] = 1 - 2 / n
        for s in range(n):
            matrix[0][edge(s)] += 1 / n ** 2
            matrix[0][face(s)] += 1 / n ** 2
            for column, weight in ((0, 3 / 8), (edge(s), 3 / 8), (edge(s - 1), 1 / 16), (edge(s + 1), 1 / 16), (face(s), 1 / 16), (face(s - 1), 1 / 16)):
                matrix[edge(s)][column] += weight
            for column in (0, edge(s), edge(s + 1), face(s)):
                matrix[face(s)][column] += 1 / 4
        # det(A - lambda) by elimination
        def determinant(x):
            a = [[matrix[i][j] - (x if i == j else 0) for j in range(size)] for i in range(size)]
            product = 1
            for k in range(size):
                pivot = max(range(k, size), key=lambda i: abs(a[i][k]))
                a[k], a[pivot] = a[pivot], a[k]
                product *= a[k][k] if pivot == k else -a[k][k]
                if abs(a[k][k]) < 1e-300:
                    return 0
                for i in range(k + 1, size):
                    factor = a[i][k] / a[k][k]
                    for j in range(k, size):
                        a[i][j] -= factor * a[k][j]
            return product
        values = [(complex(Fraction(e["re"][0]), Fraction(e["im"][0])), e["multiplicity"]) for e in result["eigenvalues"]]
        self.assertEqual(sum(m for _, m in values), size)
        for x in (0.3, -0.7, 0.5j, 1.7):
            product = 1
            for value, multiplicity in values:
                product *= (complex(value) - x) ** multiplicity
            self.assertTrue(cmath.isclose(product, determinant(x), rel_tol=1e-9), (x, product, determinant(x)))

    def test_text(self):
        run = self.limes("spectrum", "doo-sabin", "--valence", "5")
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = run.stdout.splitlines()
        self.assertEqual(lines[0], "doo-sabin, valence 5: mu = 1, 5 eigenvalues on 1 ring")
        self.assertEqual(lines[3].split()[:3], ["1", "1", "1"])
        self.assertEqual(lines[4].split()[:5], ["1/2", "1/2", "2", "1,", "4"])

    def test_more_rings(self):
        two, three = (self.results("unified", "--valence", 5, "--rings", r)[0] for r in (2, 3))
        self.assertEqual((two["size"], three["size"]), (31, 61))
        self.assertEqual(two["eigenvalues"][1]["re"], three["eigenvalues"][1]["re"])

    def test_bad_arguments_are_one_line(self):
        self.assert_bad_input(self.limes("spectrum", "four-point", "--valence", "5"), "four-point is no surface scheme")
        for valence in ("2", "5..3", "x", "3..", "3..2000", "3.5"):
            self.assert_bad_input(self.limes("spectrum", "unified", "--valence", valence), "--valence " + valence)
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--level", "-1"), "level")
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--level", "1", "--param", "mu=1/2"), "--level")
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--param", "mu=0"), "pole")
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--param", "theta=4"), "range")
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--param", "w=1"), "--param w=1")
        self.assert_bad_input(self.limes("spectrum", "unified", "--valence", "5", "--rings", "1"), "rings")

    def test_bad_scheme_files_are_one_line(self):
        def rules(*lines):
            return self.own_scheme(OWN_SCHEME.split('"0,0"')[0] + "\n".join(lines) + "\n")

        for lines, part in (
                (['"0,1" = "at(0,0)"'], "mine.toml:6: [surface.rules]: 0,1 is no point of a sector"),
                (['"1,0" = "at(0,0)"'], "mine.toml:5: [surface.rules]: b-spline-3: the new point 0,0 needs a rule"),
                (['"0,0" = "at(0,0) + 1/5"'], 'mine.toml:6: rule "0,0": column 9: cannot add'),
                (['"0,0" = "ring(1,0)"'], 'mine.toml:6: rule "0,0": column 1: unknown \'ring\''),
                (['"0,0" = "w*at(0,0)"'], "unknown name 'w'"),
                (['"0,0" = "at(0,0)*at(1,0)"'], "points can be multiplied with numbers"),
                (['"0,0" = "1/2*at(1,0) + 1/2*at(0,0)"'], "consists of at(0,0) and means"),
                (['"0,0" = "at(0,0)/(n-n)"'], "division by zero"),
                (['"0,0" = 1'], "must be a string"),
                ([], "has no rule")):
            self.assert_bad_input(self.limes("spectrum", rules(*lines), "--valence", "5"), part)
        self.assert_bad_input(self.limes("spectrum", self.own_scheme(OWN_SCHEME.replace("b-spline-3", "four-point")), "--valence", "5"), "parameters")
        self.assert_bad_input(self.limes("spectrum", self.own_scheme(OWN_SCHEME.replace("b-spline-3", "cr1")), "--valence", "5"), "cr1")
        one_sided = rules('"0,0" = "1/2*at(0,0) + 1/2*mean(1,0)"', '"1,0" = "at(1,0,1)"')
        self.assert_bad_input(self.limes("spectrum", one_sided, "--valence", "5"), "not mirror symmetric")

    def test_only_schemes_with_virtual_points_can_be_refined(self):
        (self.dir / "mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        run = self.limes("refine", "catmull-clark", "mesh.obj", "--levels", "1", "-o", "out.obj")
        self.assert_bad_input(run, "only schemes with virtual points can be refined")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
