"""limes holder as a user meets it: text, JSON keys, digits, missing ends, a budget, Ctrl-C, and certificates that limes-check accepts.

Run by CTest as: python3 holder_test.py LIMES LIMES_CHECK CERTIFICATES
Certificates that valid runs produce go to CERTIFICATES, where script/test checks them once more.
"""

import json
import math
import signal
import subprocess
import sys
import time
import unittest
from fractions import Fraction

from limes_case import LimesCase

LIMES, LIMES_CHECK, CERTIFICATES = sys.argv[1:4]

UNSTABLE = """name = "unstable"
kind = "uniform"
[uniform]
first_index = 0
mask = ["1/4", "1/2", "1/2", "1/2", "1/4"]
"""
WITHOUT_SUM_RULES = """name = "without-sum-rules"
kind = "uniform"
[uniform]
mask = ["9/10", "9/5", "9/10"]
"""


class Holder(LimesCase):
    def assert_consistent(self, result):
        """lower <= upper, and the Sobolev exponent is no farther away than it may be."""
        lower, upper = (None if result[end] is None else Fraction(result[end]) for end in ("lower", "upper"))
        sobolev = {end: None if result["sobolev"][end] is None else Fraction(result["sobolev"][end]) for end in ("lower", "upper")}
        for small, great in ((lower, upper), (sobolev["lower"], sobolev["upper"]), (lower, sobolev["upper"])):
            if small is not None and great is not None:
                self.assertLessEqual(small, great)
        if upper is not None and sobolev["lower"] is not None:
            self.assertLessEqual(sobolev["lower"] - Fraction(1, 2), upper)
        if lower is not None:
            check = self.run_program(result["certificate"], program=LIMES_CHECK)
            self.assertEqual(check.returncode, 0, check.stdout + check.stderr)

    def report(self, *arguments, status=0):
        run = self.run_program("holder", *arguments, "--json", "--certificates", CERTIFICATES)
        self.assertEqual(run.returncode, status, run.stderr)
        result = json.loads(run.stdout)
        self.assert_consistent(result)
        return result

    def assert_encloses(self, result, value, digits=6):
        self.assertLessEqual(float(Fraction(result["lower"])), value + 1e-14)
        self.assertGreaterEqual(float(Fraction(result["upper"])), value - 1e-14)
        self.assertLessEqual(Fraction(result["upper"]) - Fraction(result["lower"]), Fraction(1, 10**digits))

    def test_json_keys_and_the_four_point_scheme(self):
        # Dyn, Gregory & Levin 1987: exponent 2, which is not attained.
        result = self.report("four-point", "--param", "w=1/16")
        keys = {"lower", "upper", "lower_decimal", "upper_decimal", "exact", "exact_exponent", "order", "radius", "stability", "sobolev", "reason",
                "certificate"}
        self.assertEqual(keys - set(result), set())
        self.assertEqual((result["lower"], result["upper"], result["exact"], result["exact_exponent"]), ("2", "2", True, "2"))
        self.assertEqual((result["order"], result["stability"], result["radius"]["word"]), (4, "interpolatory", [0]))

    def test_text(self):
        run = self.run_program("holder", "four-point", "--param", "w=1/16")
        self.assertEqual(run.returncode, 0, run.stderr)
        for part in ("Hoelder exponent exactly 2\n", "exactly 3 - log_2(r)", "Sobolev exponent in [2.4407654, 2.4407655]", "four-point-w-1_16-holder.json"):
            self.assertIn(part, run.stdout)
        self.assertEqual(self.run_program("holder", "four-point", "--param", "w=1/16", "--quiet").stdout.split(), ["2", "2"])

    def test_published_values(self):
        self.assert_encloses(self.report("deslauriers-dubuc-6"), 6 - math.log2(9))
        self.assertEqual(self.report("b-spline-3")["exact_exponent"], "3")
        self.assert_encloses(self.report("ternary-four-point", "--param", "mu=1/11"), 2 + math.log(11 / 9, 3))
        self.assertEqual(self.report("cr1", "--param", "w=1/16")["exact_exponent"], "2")  # for equal intervals

    def test_digits(self):
        last = None
        for digits in (1, 6, 14):
            result = self.report("six-point", "--param", "w=1/96", "--digits", digits)
            self.assertLessEqual(Fraction(result["upper"]) - Fraction(result["lower"]), Fraction(1, 10**digits))
            if last:
                self.assertLessEqual(Fraction(result["lower"]), Fraction(last["upper"]))
                self.assertGreaterEqual(Fraction(result["upper"]), Fraction(last["lower"]))
            last = result

    def test_missing_ends(self):
        (self.dir / "unstable.toml").write_text(UNSTABLE)
        result = self.report("unstable.toml", status=3)
        self.assertIsNone(result["upper"])
        self.assertEqual(result["stability"], None)
        self.assertGreater(Fraction(result["lower"]), 0)
        (self.dir / "without.toml").write_text(WITHOUT_SUM_RULES)
        result = self.report("without.toml", status=3)
        self.assertEqual((result["lower"], result["upper"], result["certificate"]), (None, None, ""))
        self.assertIn("do not add up", result["reason"])
        # Not even continuous: w beyond 1/2.
        result = self.report("four-point", "--param", "w=0", status=0)
        self.assertEqual(result["exact_exponent"], "1")

    def test_bad_input(self):
        for arguments, part in ((["four-point"], "--param w=VALUE"), (["four-point", "--param", "w=[0,1/16]"], "one value"),
                                (["four-point", "--param", "v=1"], "v"), (["four-point", "--param", "w=x"], "w=x"), (["no-such-scheme"], "no-such-scheme"),
                                (["catmull-clark-no.toml"], "catmull-clark-no.toml")):
            with self.subTest(arguments):
                run = self.run_program("holder", *arguments)
                self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
                self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
                self.assertIn(part, run.stderr)
        for digits in ("0", "31"):
            self.assertEqual(self.run_program("holder", "chaikin", "--digits", digits).returncode, 2)

    def test_budget_and_interrupt_keep_bounds(self):
        # A complex leading eigenvalue: no exact polytope, and ten digits take very long.
        slow = ["ten-point", "--param", "w=0.0018", "--digits", "10"]
        result = self.report(*slow, "--budget", "2", status=3)
        self.assertGreater(Fraction(result["upper"]), 4)
        process = subprocess.Popen([LIMES, "holder", *slow, "--json", "--certificates", CERTIFICATES], cwd=self.dir, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, errors)
        self.assert_consistent(json.loads(output))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
