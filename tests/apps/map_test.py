"""limes map as a user meets it: table, JSON keys, pictures, exit status, and a journal that outlives kill -9.

Run by CTest as: python3 map_test.py LIMES LIMES_CHECK CERTIFICATES
Certificates that valid runs produce go to CERTIFICATES, where script/test checks them once more.
"""

import json
import signal
import subprocess
import sys
import time
import unittest
from fractions import Fraction

from limes_case import LimesCase

LIMES, LIMES_CHECK, CERTIFICATES = sys.argv[1:4]

TWO_PARAMETERS = """name = "two-parameters"
kind = "uniform"
[parameters]
v = ["0", "1/16"]
w = ["1/20", "1/8"]
[uniform]
mask = ["v", "0", "-w", "0", "1/2+w-v", "1", "1/2+w-v", "0", "-w", "0", "v"]
"""


class Map(LimesCase):
    def map(self, *arguments):
        return self.run_program("map", *arguments)

    def test_only_smoothness_of_the_scheme_itself(self):
        for claim in ("projective C0", "not projective C1", "only zero limits", "not C1"):
            self.assert_bad_input(self.map("four-point", "--claim", claim), "--claim", "C<m>")
            self.assertFalse((self.dir / "certificates").exists())

    def test_json_and_certificates(self):
        run = self.map("four-point", "--claim", "C1", "--tolerance", "1/500", "--json", "--certificates", CERTIFICATES)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        report = json.loads(run.stdout)
        self.assertEqual({"cells", "certified", "refuted", "undecided", "unknown_measure", "certificates", "complete"} - set(report), set())
        self.assertTrue(report["complete"])
        self.assertLessEqual(Fraction(report["unknown_measure"]), Fraction(1, 500))
        (low, high), = report["certified"]
        self.assertEqual(low, "0")
        self.assertLess(Fraction(high), Fraction(192730, 1000000))
        self.assertEqual(report["refuted"][0], ["0", "0"])
        for cell in report["cells"]:
            self.assertIn(cell["verdict"], ("certified", "refuted", "undecided"))
            self.assertEqual(set(cell["region"]), {"w"})
        # One certificate for every maximal interval, of what the map says about it.
        self.assertEqual(len(report["certificates"]), len(report["certified"]) + len(report["refuted"]))
        for entry in report["certificates"]:
            check = self.run_program(entry["certificate"], program=LIMES_CHECK)
            self.assertEqual(check.returncode, 0, check.stdout + check.stderr)
            self.assertIn("is C1" if entry["verdict"] == "certified" else "is not C1", check.stdout)
            self.assertIn(entry["intervals"]["w"], check.stdout)

    def test_table_and_pictures(self):
        run = self.map("ternary-four-point", "--claim", "C2", "-o", "map.svg", "-o", "map.pgf", "-o", "map.png")
        self.assertEqual(run.returncode, 0, run.stderr)
        for part in ("mu in [-1/3, 1/15]", "mu in (1/15, 1/9)", "mu in [1/9, 1/3]", "unknown measure 0"):
            self.assertIn(part, run.stdout)
        self.assertIn("certified", (self.dir / "map.svg").read_text())
        self.assertIn("tikzpicture", (self.dir / "map.pgf").read_text())
        self.assertTrue((self.dir / "map.png").read_bytes().startswith(b"\x89PNG"))
        first = (self.dir / "map.svg").read_bytes()
        self.map("ternary-four-point", "--claim", "C2", "-o", "map.svg", "--threads", "1")
        self.assertEqual(first, (self.dir / "map.svg").read_bytes())

    def test_two_parameters(self):
        (self.dir / "two.toml").write_text(TWO_PARAMETERS)
        run = self.map("two.toml", "--claim", "C1", "--tolerance", "1/1000", "--json", "-o", "two.svg")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads(run.stdout)
        self.assertTrue(report["certified"])
        for (v_low, v_high), (w_low, w_high) in report["certified"]:
            self.assertLess(Fraction(v_low), Fraction(v_high))
            self.assertLess(Fraction(w_low), Fraction(w_high))
        # One of the two fixed.
        run = self.map("two.toml", "--claim", "C1", "--param", "v=0", "--json")
        self.assertEqual(json.loads(run.stdout)["certified"], [["1/20", "1/8"]])

    def test_the_journal_outlives_a_kill(self):
        arguments = ["four-point", "--claim", "C1", "--tolerance", "1/2000", "--threads", "1", "--json"]
        whole = json.loads(self.map(*arguments, "--journal", "whole.journal").stdout)
        records = (self.dir / "whole.journal").read_text().splitlines()
        process = subprocess.Popen([LIMES, "map", *arguments, "--journal", "killed.journal"], cwd=self.dir,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        journal = self.dir / "killed.journal"
        deadline = time.monotonic() + 100
        while time.monotonic() < deadline and process.poll() is None:
            if journal.exists() and len(journal.read_text().splitlines()) > len(records) // 3:
                break
            time.sleep(0.002)
        process.send_signal(signal.SIGKILL)
        process.wait()
        kept = [line for line in journal.read_text().splitlines(keepends=True) if line.endswith("\n")]
        resumed = json.loads(self.map(*arguments, "--journal", "killed.journal").stdout)
        self.assertEqual(resumed, whole)
        lines = journal.read_text().splitlines(keepends=True)
        self.assertEqual(lines[:len(kept)], kept, "nothing is lost")
        self.assertEqual(sorted(lines), sorted((self.dir / "whole.journal").read_text().splitlines(keepends=True)),
                         "nothing is done twice")

    def test_budget_keeps_what_is_found(self):
        arguments = ["four-point", "--claim", "C1", "--tolerance", "1/1000000", "--json", "--journal", "journal"]
        run = self.map(*arguments, "--budget", "0.05")
        self.assertEqual(run.returncode, 3, run.stderr)
        report = json.loads(run.stdout)
        self.assertFalse(report["complete"])
        measure = sum(Fraction(c["region"]["w"][1]) - Fraction(c["region"]["w"][0]) for c in report["cells"])
        self.assertEqual(measure, Fraction(1, 4))

    def test_bad_usage(self):
        self.assert_bad_input(self.map("four-point", "--claim", "not C1"), "--claim")
        self.assert_bad_input(self.map("four-point", "--claim", "C1", "--tolerance", "0"), "--tolerance")
        self.assert_bad_input(self.map("four-point", "--claim", "C1", "--tolerance", "x"), "--tolerance")
        self.assert_bad_input(self.map("four-point", "--claim", "C1", "--param", "w=1/16"), "one or two parameters")
        self.assert_bad_input(self.map("chaikin", "--claim", "C1"), "one or two parameters")
        self.assert_bad_input(self.map("four-point", "--claim", "C1", "-o", "map.pdf"), ".svg")
        (self.dir / "journal").write_text("something else\n")
        self.assert_bad_input(self.map("four-point", "--claim", "C1", "--journal", "journal"), "journal:1")
        self.assertEqual((self.dir / "journal").read_text(), "something else\n", "no damage")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
