"""limes jsr as a user meets it: files good and bad, JSON keys, digits, a budget, Ctrl-C, and certificates that limes-check accepts.

Run by CTest as: python3 jsr_test.py LIMES LIMES_CHECK CERTIFICATES
Certificates that valid runs produce go to CERTIFICATES, where script/test checks them once more.
"""

import json
import math
import random
import signal
import subprocess
import sys
import time
import unittest
from fractions import Fraction

from limes_case import LimesCase

LIMES, LIMES_CHECK, CERTIFICATES = sys.argv[1:4]

GOLDEN = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]


def wide_family(size=14):
    """Matrices whose radius is not found in seconds."""
    source = random.Random(5)
    return [[[source.randint(-3, 3) for _ in range(size)] for _ in range(size)] for _ in range(3)]


class Jsr(LimesCase):
    def write(self, name, content):
        (self.dir / name).write_text(content if isinstance(content, str) else json.dumps(content))
        return name

    def report(self, content, *arguments, status=0, name="m.json"):
        run = self.run_program("jsr", self.write(name, content), "--json", "--certificates", CERTIFICATES, *arguments)
        self.assertEqual(run.returncode, status, run.stderr)
        result = json.loads(run.stdout)
        self.assertLessEqual(Fraction(result["lower"]), Fraction(result["upper"]))
        check = self.run_program(result["certificate"], program=LIMES_CHECK)
        self.assertEqual(check.returncode, 0, check.stdout + check.stderr)
        return result

    def assert_encloses(self, result, value, digits=6):
        self.assertLessEqual(float(Fraction(result["lower"])), value * (1 + 1e-14))
        self.assertGreaterEqual(float(Fraction(result["upper"])), value * (1 - 1e-14))
        self.assertLessEqual(float(Fraction(result["upper"]) - Fraction(result["lower"])), value * 10.0**-digits)

    def assert_bad_input(self, content, *parts, name="bad.json"):
        run = self.run_program("jsr", self.write(name, content))
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, "one clear line: " + run.stderr)
        for part in (name, *parts):
            self.assertIn(part, run.stderr)

    def test_json_keys(self):
        result = self.report(GOLDEN, name="golden.json")
        self.assertEqual({"lower", "upper", "lower_decimal", "upper_decimal", "word", "exact", "blocks", "certificate"} - set(result), set())
        self.assertEqual(result["word"], [0, 1])
        self.assertEqual(result["exact"]["polynomial"], ["-1", "-1", "1"])
        self.assert_encloses(result, (1 + math.sqrt(5)) / 2)
        self.assertLessEqual(Fraction(result["lower_decimal"]), Fraction(result["lower"]))
        self.assertGreaterEqual(Fraction(result["upper_decimal"]), Fraction(result["upper"]))

    def test_text_and_csv(self):
        self.write("golden.csv", "# a pair\n1, 1\n0, 1\n\n1, 0\n1.0, 2/2\n")
        run = self.run_program("jsr", "golden.csv")
        self.assertEqual(run.returncode, 0, run.stderr)
        for part in ("joint spectral radius in [1.6180339, 1.6180340]", "x^2 - x - 1", "word 0 1", "golden-jsr.json"):
            self.assertIn(part, run.stdout)
        self.assertEqual(run.stdout, self.run_program("jsr", self.write("golden.json", GOLDEN)).stdout)
        self.assertEqual(len(self.run_program("jsr", "golden.csv", "--quiet").stdout.split()), 2)

    def test_digits(self):
        last = None
        for digits in (1, 4, 12):
            result = self.report([[["1", "2"], ["-1", "1"]], [["0", "1"], ["1", "1"]]], "--digits", digits, name=f"digits-{digits}.json")
            self.assertLessEqual(Fraction(result["upper"]) - Fraction(result["lower"]), Fraction(result["lower"]) / 10**digits)
            if last:
                self.assertLessEqual(Fraction(result["lower"]), Fraction(last["upper"]))
                self.assertGreaterEqual(Fraction(result["upper"]), Fraction(last["lower"]))
            last = result
        for digits in ("0", "31", "x"):
            self.assertEqual(self.run_program("jsr", self.write("m.json", GOLDEN), "--digits", digits).returncode, 2)

    def test_gripenberg_1996_example(self):
        # [0.6596789, 0.6596924] there.
        result = self.report([[["3/5", "0"], ["1/5", "3/5"]], [["3/5", "-3/5"], ["0", "-1/5"]]], name="gripenberg.json")
        self.assertGreater(Fraction(result["lower"]), Fraction("0.6596789"))
        self.assertLess(Fraction(result["upper"]), Fraction("0.6596924"))

    def test_one_rotation_and_reducible_and_zero(self):
        self.assert_encloses(self.report([[["3/5", "-4/5"], ["4/5", "3/5"]]], name="rotation.json"), 1)
        blocks = self.report([[[1, 5], [0, 2]], [[3, 7], [0, 1]]], name="blocks.json")
        self.assert_encloses(blocks, 3)
        self.assertEqual(blocks["blocks"], [1, 1])
        self.assertEqual(self.report([[[0, 1], [0, 0]], [[0, 0], [0, 0]]], name="nilpotent.json")["upper"], "0")

    def test_bad_files(self):
        for content, part in (("", "holds no matrix"), (" \n\n", "holds no matrix"), ("[]", "no list of matrices"), ("{}", "no list of matrices"),
                              ("[[[1]]", "no JSON"), ("[1, 2]", "matrix 1"), ("[[]]", "matrix 1"), ("[[[]]]", "row 1"),
                              ("[[[1, 2]]]", "not square"), ("[[[1], [2]]]", "not square"), ("[[[1, 2], [3]]]", "not square"),
                              ("[[[1]], [[1, 0], [0, 1]]]", "matrix 2 has 2 rows"), ("[[[0.5]]]", "decimals are strings"), ("[[[NaN]]]", "no JSON"),
                              ('[[["NaN"]]]', "row 1"), ('[[["1/0"]]]', "row 1"), ('[[["x"]]]', "row 1"), ("[[[true]]]", "row 1"),
                              ("[[[null]]]", "row 1"), ("[" * 5000, "nested")):
            with self.subTest(content[:40]):
                self.assert_bad_input(content, part)
        for content, part in (("1,2\n3\n", "not square"), ("1,nan\n2,3\n", ":1"), ("1,2\n3,,4\n", ":2"), ("# only this\n", "holds no matrix"),
                              ("1\n\n1,2\n3,4\n", "matrix 2 has 2 rows"), ("1;2\n", ":1"), ("\0\n", ":1")):
            with self.subTest(content):
                self.assert_bad_input(content, part, name="bad.csv")

    def test_large_files(self):
        self.assert_bad_input([[[0] * 65 for _ in range(65)]], "64 rows")
        self.assert_bad_input([[[1]]] * 65, "64 matrices")
        self.assert_bad_input("[" + " " * (17 << 20) + "]", "16 MiB")
        self.assert_bad_input(json.dumps([[["1" * 200000]]]), "row 1")
        missing = self.run_program("jsr", "missing.json")
        self.assertEqual(missing.returncode, 2)
        self.assertIn("missing.json", missing.stderr)
        self.assertEqual(self.run_program("jsr", self.dir).returncode, 2)

    def test_budget_keeps_bounds(self):
        result = self.report(wide_family(), "--budget", "2", status=3, name="wide.json")
        self.assertGreater(Fraction(result["lower"]), 0)

    def test_interrupt_keeps_bounds(self):
        command = [LIMES, "jsr", self.write("wide.json", wide_family()), "--json", "--certificates", CERTIFICATES]
        process = subprocess.Popen(command, cwd=self.dir, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, errors)
        result = json.loads(output)
        self.assertLessEqual(Fraction(result["lower"]), Fraction(result["upper"]))
        self.assertEqual(self.run_program(result["certificate"], program=LIMES_CHECK).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
