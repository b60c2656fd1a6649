"""limes search, limes dominance and the definitions in limes show. Run by CTest as: python3 search_test.py LIMES LIMES_CHECK"""

import json
import subprocess
import sys
import unittest

from limes_case import LimesCase

LIMES, LIMES_CHECK = sys.argv[1:3]

# One unknown weight: the 8-point analogue of a3-5-3-3.
SEARCHED = """name = "searched"
kind = "nonuniform"
[parameters]
a = ["0", "1"]
[nonuniform]
points = 8
[nonuniform.let]
outer = "(at(f(5,-1),1/2) + at(f(5,1),1/2))/2"
[nonuniform.rule]
new = "(1-a)*at(f(7,0),1/2) + a*outer"
"""


class Search(LimesCase):
    def setUp(self):
        super().setUp()
        (self.dir / "searched.toml").write_text(SEARCHED)

    def search(self, *arguments):
        return self.run_program("search", "searched.toml", "--claim", "C3", "--starts", "2", "--json", *arguments)

    def test_finds_proves_and_writes_a_scheme(self):
        done = self.search("-o", "found.toml", "--certificates", "certificates")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        self.assertEqual([trial["verdict"] for trial in result["starts"]], ["certified", "certified"])
        checked = self.run_program(result["best"]["certificate"], program=LIMES_CHECK)
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertEqual(self.run_program("verify", "found.toml").returncode, 0)

    def test_a_journal_is_continued_without_repeated_work(self):
        whole = json.loads(self.search("--journal", "j").stdout)
        lines = (self.dir / "j").read_text().splitlines(keepends=True)
        self.assertEqual(len(lines), 3)
        # As if the program had been killed in the second start, in the middle of a line.
        kept = json.loads(lines[1])
        kept["reason"] = "kept"
        (self.dir / "j").write_text(lines[0] + json.dumps(kept) + "\n" + lines[2][:20])
        again = json.loads(self.search("--journal", "j").stdout)
        by_start = {trial["start"]: trial for trial in again["starts"]}
        self.assertEqual(by_start[kept["start"]]["reason"], "kept")
        self.assertEqual([t["parameters"] for t in again["starts"]], [t["parameters"] for t in whole["starts"]])

    def test_the_journal_of_another_search_is_refused(self):
        self.search("--journal", "j")
        done = self.run_program("search", "searched.toml", "--claim", "C2", "--journal", "j")
        self.assertEqual(done.returncode, 2)
        self.assertIn("j:1: the journal of another search", done.stderr)
        (self.dir / "j").write_text("hello\n")
        self.assertEqual(self.search("--journal", "j").returncode, 2)

    def test_nothing_found_is_status_3(self):
        done = self.run_program("search", "searched.toml", "--claim", "C4", "--starts", "1")
        self.assertEqual(done.returncode, 3)
        self.assertIn("screened", done.stdout)

    def test_bad_input(self):
        for arguments, reason in [(("four-point", "--claim", "C1"), "needs a non-uniform one"),
                                  (("repeated-cr1", "--claim", "C2"), "no parameters"),
                                  (("searched.toml", "--claim", "not C2"), "looks for smooth schemes"),
                                  (("searched.toml", "--claim", "C6"), "does not reproduce polynomials of degree 6")]:
            done = self.run_program("search", *arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(reason, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)

    def test_budget(self):
        done = self.search("--budget", "0.001")
        self.assertEqual(done.returncode, 3)


class Dominance(LimesCase):
    def test_text_and_json(self):
        done = subprocess.run([LIMES, "dominance", "repeated-a1-3-1"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("never: gamma = 0", done.stdout)
        done = subprocess.run([LIMES, "dominance", "cr1", "--claim", "C1", "--param", "w=1/16", "--json"], capture_output=True,
                              text=True, timeout=60, check=False)
        factors = json.loads(done.stdout)["results"][0]["factors"]
        self.assertEqual([test["test"] for test in factors[0]["tests"]], ["rouche", "circle", "boundary", "separation"])
        self.assertTrue(all(any(test["proved"] for test in factor["tests"]) for factor in factors))

    def test_a_false_claim_has_a_counterexample(self):
        done = subprocess.run([LIMES, "dominance", "a2-5-3", "--claim", "C3", "--param", "w=0.0141"], capture_output=True,
                              text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn("false at gamma = ", done.stdout)

    def test_bad_input(self):
        for arguments in [("four-point",), ("cr1", "--param", "w=1/16"), ("cr1", "--claim", "not C1")]:
            done = subprocess.run([LIMES, "dominance", *arguments], capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 2, done.stderr)


class Show(LimesCase):
    def test_definitions(self):
        done = subprocess.run([LIMES, "show", "cr2"], capture_output=True, text=True, timeout=60, check=True)
        self.assertIn("cr1 = hermite(1, f(2,0), f(2,1))", done.stdout)
        done = subprocess.run([LIMES, "show", "cr2", "--json"], capture_output=True, text=True, timeout=60, check=True)
        shown = json.loads(done.stdout)
        self.assertEqual(shown["points"], 6)
        self.assertEqual([definition["name"] for definition in shown["let"]], ["cr1", "cr2", "omega"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
