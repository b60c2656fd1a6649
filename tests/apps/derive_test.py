#!/usr/bin/python3
"""limes derive on the command line. Usage: derive_test.py LIMES CHECK"""
from fractions import Fraction
import json
import os
import subprocess
import sys
import tempfile
import unittest

LIMES, CHECK = sys.argv[1:3]


def run(*arguments):
    done = subprocess.run([LIMES, *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def derive(*arguments):
    status, output, errors = run("derive", "--json", *arguments)
    assert status == 0, errors
    return json.loads(output)


class Derive(unittest.TestCase):
    def test_spline_by_both_methods(self):
        for method in ("samples", "integrals"):
            result = derive("--weight", "bspline(degree=3)", "--method", method)
            self.assertEqual(result["mask"], ["1/8", "1/2", "3/4", "1/2", "1/8"])
            self.assertEqual((result["first_index"], result["even_sum"], result["odd_sum"], result["rank"]), (-2, "1", "1", 5))

    def test_documented_keys(self):
        result = derive("--weight", "cinpact(c=3, sigma=727/100)", "--round", "float32", "--cost", "2")
        for key in ("mask", "first_index", "error", "even_sum", "odd_sum", "condition"):
            self.assertIn(key, result)
        self.assertAlmostEqual(result["rounded"]["error"], 0.001974, places=6)
        self.assertEqual([row["claims"] for row in result["costs"]],
                         [["only zero limits", "projective C0", "not projective C1"], ["C1", "not C2"], ["C1", "not C2"]])

    def test_exponents_are_enclosed(self):
        result = derive("--weight", "interpolating-cinpact(c=5, sigma=4.79)", "--constraint", "interpolation", "--cost", "4")
        rows = result["costs"]
        self.assertNotIn("exponent", rows[0])
        for row in rows[1:]:
            lower, upper = Fraction(row["exponent"]), Fraction(row["exponent_upper"])
            self.assertLess(upper - lower, Fraction(1, 10))
        self.assertEqual(rows[4]["claims"], ["C2", "not C3"])
        self.assertTrue(2 < Fraction(rows[4]["exponent"]) < Fraction(rows[4]["exponent_upper"]) < 3)
        self.assertEqual({k: v for k, v in rows[1].items() if k != "sum_rules"}, {k: v for k, v in rows[2].items() if k != "sum_rules"}, "symmetric")

    def test_nearly_positive_masks_have_exponents_by_norms(self):
        rows = derive("--weight", "cinpact(c=5.158, sigma=28.48, centre=5.158)", "--shifts", "0..10", "--cost", "1")["costs"]
        self.assertTrue(Fraction(98, 100) < Fraction(rows[1]["exponent"]) <= Fraction(rows[1]["exponent_upper"]) <= 1)

    def test_the_scheme_file_keeps_its_weight_function(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "best.toml")
            first = derive("--weight", "cinpact(c=4, sigma=1)", "--optimise", "sigma=[1,40]", "--samples", "1001", "--constraint", "symmetry", "-o", file)
            self.assertEqual(first["weight"], "cinpact(c=4, sigma=867/100)")
            again = derive("--weight", file)
            self.assertEqual((again["mask"], again["error"]), (first["mask"], first["error"]))
            bump = os.path.join(folder, "bump.toml")
            with open(bump, "w") as stream:
                stream.write('name = "bump"\nkind = "weight"\n[weight]\npieces = [{on = "[-2,2]", value = "(1+cos(pi*u/2))^3"}]\nmethod = "integrals"\nsamples = 2001\n')
            first = derive("--weight", bump, "-o", file)
            self.assertEqual(derive("--weight", file)["mask"], first["mask"])
            with open(file) as stream:
                text = stream.read()
            for wrong, message in (('samples = 1', "an integer from 2"), ('shifts = "1-2"', "expected FIRST..LAST"), ('colour = "red"', "unknown key 'colour' in [weight]")):
                with open(file, "w") as stream:
                    stream.write(text.replace("[weight]\n", "[weight]\n" + wrong + "\n").replace("samples = 2001\n", "" if wrong.startswith("samples") else "samples = 2001\n"))
                for arguments in (("derive", "--weight", file), ("show", file)):
                    status, output, errors = run(*arguments)
                    self.assertEqual((status, output, errors.count("\n")), (2, "", 1), errors)
                    self.assertIn(message, errors)
                    self.assertIn("best.toml:", errors)

    def test_higher_precision_agrees(self):
        weight = ("--weight", "cinpact(c=4, sigma=8.67)", "--samples", "2001")
        self.assertAlmostEqual(derive(*weight)["error"], derive(*weight, "--precision", "128")["error"], places=13)

    def test_written_scheme_is_verified(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "smooth.toml")
            derive("--weight", "interpolating-cinpact(c=5, sigma=4.79)", "--constraint", "interpolation", "--constraint", "sum-rules=4", "-o", file)
            status, output, errors = run("verify", file, "--json", "--certificates", folder)
            self.assertEqual(status, 0, errors)
            results = json.loads(output)["results"]
            self.assertEqual([(r["claim"], r["verdict"]) for r in results], [("C2", "certified"), ("not C3", "certified")])
            file = os.path.join(folder, "rough.toml")
            derive("--weight", "cinpact(c=2.5, sigma=6.28)", "--decimals", "9", "-o", file)
            status, output, errors = run("verify", file, "--json", "--certificates", folder)
            self.assertEqual(status, 0, errors)
            self.assertEqual([r["claim"] for r in json.loads(output)["results"]], ["only zero limits", "projective C0", "not projective C1"])
            certificates = [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".json")]
            self.assertEqual(subprocess.run([CHECK, "--quiet", *certificates]).returncode, 0)

    def test_optimise_finds_the_published_parameters(self):
        for c, sigma, minima in (("2.5", "157/25", 1), ("4", "867/100", 3)):
            result = derive("--weight", f"cinpact(c={c}, sigma=1)", "--optimise", "sigma=[1,40]", "--samples", "1001")
            self.assertEqual((result["optimum"]["value"], len(result["optimum"]["local_minima"])), (sigma, minima))

    def test_weight_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "hat.toml")
            with open(file, "w") as stream:
                stream.write('name = "hat"\nkind = "weight"\n[weight]\n'
                             'pieces = [{on = "[-1,0]", value = "1+u"}, {on = "[0,1]", value = "1-u"}]\n')
            self.assertEqual(derive("--weight", file, "--method", "integrals")["mask"], ["1/2", "1", "1/2"])

    def expect_error(self, part, *arguments):
        status, output, errors = run("derive", *arguments)
        self.assertEqual((status, output, errors.count("\n")), (2, "", 1), errors)
        self.assertIn(part, errors)

    def test_input_errors(self):
        self.expect_error("unknown weight function 'gauss'", "--weight", "gauss(sigma=1)")
        self.expect_error("sum of the weights", "--weight", "cinpact(c=1/2, sigma=3)")
        self.expect_error("no dilate", "--weight", "cinpact(c=4, sigma=9)", "--domain", "[-1,1]")
        self.expect_error("rank-deficient", "--weight", "bspline(degree=3)", "--shifts", "-9..9")
        self.expect_error("infeasible", "--weight", "cinpact(c=1, sigma=3)", "--constraint", "sum-rules=4")
        self.expect_error("shift 0", "--weight", "cinpact(c=2.5, sigma=3)", "--constraint", "interpolation")
        self.expect_error("not enough", "--weight", "cinpact(c=4, sigma=9)", "--samples", "5")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "bad.toml")
            with open(file, "w") as stream:
                stream.write('name = "bad"\nkind = "weight"\n[weight]\npieces = [{on = "[-1,1]", value = "log(u-2)"}]\n')
            self.expect_error("not finite", "--weight", file)
            with open(file, "w") as stream:
                stream.write('name = "bad"\nkind = "weight"\n[weight]\npieces = [{on = "[-1,1]", value = "tan(u)"}]\n')
            self.expect_error("bad.toml:4: pieces: column 1: unknown function 'tan'", "--weight", file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
