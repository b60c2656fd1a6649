"""The command line as a user meets it: output, JSON keys, exit status, files.

Run by CTest as: python3 command_line_test.py LIMES LIMES_CHECK CERTIFICATES
Certificates that valid runs produce go to CERTIFICATES, where script/test checks them once more.
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from fractions import Fraction

from limes_case import OWN_SCHEME

LIMES, LIMES_CHECK, CERTIFICATES = sys.argv[1:4]


class Run:
    """One run of a program in a fresh directory."""

    def __init__(self, *arguments, program=LIMES, cwd=None, env=None):
        environment = dict(os.environ, **(env or {}))
        done = subprocess.run([program, *map(str, arguments)], cwd=cwd, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=120, check=False)
        self.status, self.out, self.err = done.returncode, done.stdout, done.stderr


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="limes-test-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def limes(self, *arguments, **keywords):
        return Run(*arguments, cwd=self.dir, **keywords)

    def write(self, name, text):
        path = self.dir / name
        path.write_text(text)
        return path

    def assert_bad_input(self, run, *parts):
        self.assertEqual(run.status, 2, run.err)
        self.assertEqual(run.err.count("\n"), 1, "one clear line: " + run.err)
        for part in parts:
            self.assertIn(part, run.err)

    def test_help_and_version(self):
        for arguments in (["--help"], ["verify", "--help"], ["--version"]):
            run = self.limes(*arguments)
            self.assertEqual((run.status, run.err), (0, ""))
            self.assertTrue(run.out)

    def test_list(self):
        schemes = json.loads(self.limes("list", "--json").out)["schemes"]
        names = [scheme["name"] for scheme in schemes]
        self.assertIn("four-point", names)
        self.assertLess(names.index("deslauriers-dubuc-8"), names.index("deslauriers-dubuc-10"))
        for scheme in schemes:
            self.assertEqual({"name", "kind", "claims", "source"} - set(scheme), set())
        for name in names:
            self.assertIn(name, self.limes("list").out)

    def test_smooth_schemes_of_the_catalogue_have_both_sides(self):
        """C^k and not C^{k+1} for values in common, k being the most that is claimed: reports say "exactly C^k"."""
        def common(a, b):
            return all(max(Fraction(a[n][0]), Fraction(b[n][0])) <= min(Fraction(a[n][1]), Fraction(b[n][1])) for n in a)
        lacking, examined = [], 0
        for scheme in json.loads(self.limes("list", "--json").out)["schemes"]:
            smooth, rough = [], []
            for claim in scheme["claims"]:
                match = re.fullmatch(r"(not )?C(\d+)", claim["claim"])
                if match and claim["expected"] == "certified":
                    (rough if match[1] else smooth).append((int(match[2]), claim["region"]))
            if scheme["kind"] not in ("uniform", "nonuniform") or not smooth:
                continue
            examined += 1
            most = max(k for k, _ in smooth)
            if not any(common(a, b) for k, a in smooth if k == most for m, b in rough if m == most + 1):
                lacking.append(scheme["name"])
        self.assertEqual(lacking, [])
        self.assertGreater(examined, 30)

    def test_show(self):
        run = self.limes("show", "four-point")
        self.assertEqual(run.status, 0)
        self.assertIn("a_-3 .. a_3 = -w, 0, w + 1/2, 1, w + 1/2, 0, -w", run.out)
        self.assertIn("interpolatory", run.out)
        shown = json.loads(self.limes("show", "dual-four-point", "--json").out)
        self.assertEqual(shown["sum_rule_order"], 5)
        self.assertEqual(shown["reproduction_degree"], 3)
        self.assertIn(r"\begin{align*}", self.limes("show", "six-point", "--latex").out)

    def test_norm(self):
        # Hand computation: b = (-1 + 3 z + 3 z^2 - z^3)/4.
        run = self.limes("norm", "four-point", "--order", "2", "--level", "1", "--param", "w=1/16", "--json")
        result = json.loads(run.out)
        self.assertEqual((result["norm"], result["order"], result["level"]), ("1", 2, 1))
        self.assertIn("below 1", self.limes("norm", "four-point", "--order", "1", "--level", "2", "--param", "w=1/16").out)
        self.assert_bad_input(self.limes("norm", "four-point", "--order", "1", "--level", "1"), "--param w=VALUE")
        self.assert_bad_input(self.limes("norm", "four-point", "--order", "5", "--level", "1", "--param", "w=1/16"), "sum rules")
        self.assert_bad_input(self.limes("norm", "four-point", "--order", "1", "--level", "40", "--param", "w=1/16"), "MB")

    def test_verify_a_catalogue_scheme(self):
        run = self.limes("verify", "six-point", "--json", "--certificates", CERTIFICATES)
        self.assertEqual((run.status, run.err), (0, ""))
        report = json.loads(run.out)
        keys = {"scheme", "claim", "smoothness", "region", "verdict", "expected", "theorem", "reason", "level", "leaves",
                "seconds", "certificate"}
        for result in report["results"]:
            self.assertEqual(keys - set(result), set())
            self.assertEqual(result["verdict"], result["expected"])
            check = Run(result["certificate"], program=LIMES_CHECK, cwd=self.dir)
            self.assertEqual(check.status, 0, check.out + check.err)
        verdicts = [result["verdict"] for result in report["results"]]
        self.assertEqual(report["summary"], {v: verdicts.count(v) for v in ("certified", "refuted", "undecided")})

    def test_own_scheme_file(self):
        path = self.write("mine.toml", OWN_SCHEME)
        run = self.limes("verify", path)
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("certified", run.out)
        self.assertEqual([p.name for p in (self.dir / "certificates").iterdir()], ["mine.1.C1.json"])
        # A claim that is false: exit status 1, and the reason.
        run = self.limes("verify", path, "--claim", "C2", "--param", "w=1/16")
        self.assertEqual(run.status, 1)
        self.assertIn("spectral radius >= 1", run.out)
        run = self.limes("verify", path, "--claim", "not C2", "--json")
        self.assertEqual(run.status, 0)
        self.assertEqual(json.loads(run.out)["results"][0]["region"], {"w": ["0", "1/4"]})

    def test_parameters(self):
        run = self.limes("verify", "four-point", "--param", "w=(0,1/8]", "--json")
        results = json.loads(run.out)["results"]
        self.assertEqual(run.status, 0)
        self.assertEqual({r["intervals"]["w"] for r in results}, {"(0, 1/8]"})
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "w=1/2"), "outside of the parameter's range")
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "v=1/2"), "no parameter 'v'")
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "w"), "NAME=VALUE")
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "w=1/16", "--param", "w=1/8"), "given twice")
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "w=sqrt(2)"), "--param")
        self.assert_bad_input(self.limes("verify", "four-point", "--param", "w=1/0"), "division by zero")

    def test_bad_usage(self):
        self.assert_bad_input(self.limes())
        self.assert_bad_input(self.limes("verfy"))
        self.assert_bad_input(self.limes("verify", "four-pint"), "did you mean 'four-point'?")
        self.assert_bad_input(self.limes("verify", "no/such.toml"), "no/such.toml")
        self.assert_bad_input(self.limes("verify", "four-point", "--claim", "C1.5"), "expected")
        self.assert_bad_input(self.limes("verify", "four-point", "--budget", "1e300"))
        self.assert_bad_input(self.limes("verify", "four-point", "--budget", "-1"))
        self.assert_bad_input(self.limes("verify", "four-point", "--threads", "0"))
        self.assert_bad_input(self.limes("norm", "four-point", "--order", "1", "--level", "0", "--param", "w=1/16"))
        self.assert_bad_input(self.limes("verify", "four-point", "four-point"), "two schemes are named")
        self.assert_bad_input(self.limes("verify", "four-point", "--certificates", "/dev/null/x"), "/dev/null/x")
        self.assert_bad_input(self.limes("list", env={"LIMES_CATALOGUE": "/no/such"}), "/no/such")

    def test_bad_scheme_files_name_line_and_reason(self):
        for text, parts in (
                (OWN_SCHEME.replace("1/2+w", "1/2+v", 1), ("bad.toml:6:", "unknown name 'v'")),
                (OWN_SCHEME.replace("1/2+w", "1/(w-w)", 1), ("bad.toml:6:", "zero")),
                (OWN_SCHEME.replace('"1/8"', '"1/2"'), ("bad.toml:9:", "exceeds")),
                (OWN_SCHEME.replace("[uniform]", "[uniform"), ("bad.toml:5:",)),
                (OWN_SCHEME + "colour = 1\n", ("bad.toml:10:", "unknown key 'colour'")),
                (OWN_SCHEME.replace("-w", "(1+w)^1000000"), ("bad.toml:6:",))):
            path = self.write("bad.toml", text)
            self.assert_bad_input(self.limes("verify", path), *parts)
            self.assertFalse((self.dir / "certificates").exists(), "no damage")

    def test_output_does_not_depend_on_threads(self):
        def without_seconds(threads):
            run = self.limes("verify", "four-point", "ternary-four-point", "chaikin", "--json", "--threads", threads)
            report = json.loads(run.out)
            for result in report["results"]:
                del result["seconds"]
            return report, {p.name: p.read_bytes() for p in (self.dir / "certificates").iterdir()}
        self.assertEqual(without_seconds(1), without_seconds(2))

    def test_budget_keeps_what_is_finished(self):
        run = self.limes("verify", "--budget", "0.3", "--json", "--threads", "1")
        report = json.loads(run.out)
        if report["summary"]["undecided"]:
            self.assertEqual(run.status, 3)
            self.assertTrue(any("budget" in r["reason"] for r in report["results"] if r["verdict"] == "undecided"))
        else:
            self.assertEqual(run.status, 0)
        for result in report["results"]:
            self.assertEqual(result["certificate"] is None, result["verdict"] == "undecided")

    def test_interrupt_keeps_what_is_finished(self):
        # So near to w* nothing that is tried succeeds, so there is work left when the signal comes.
        path = self.write("slow.toml", OWN_SCHEME + "".join(
            f'[[claims]]\nclaim = "C1"\nregion = {{ w = ["{k}/10000", "1927292/10000000"] }}\n' for k in range(1, 40)))
        process = subprocess.Popen([LIMES, "verify", path, "--json", "--threads", "1"], cwd=self.dir,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while not (self.dir / "certificates" / "mine.1.C1.json").exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
        report = json.loads(out)
        self.assertEqual(process.returncode, 3)
        self.assertEqual(report["results"][0]["verdict"], "certified")
        self.assertGreater(report["summary"]["undecided"], 0)

    def test_quiet_says_nothing_when_all_is_well(self):
        run = self.limes("verify", "chaikin", "--quiet")
        self.assertEqual((run.status, run.out, run.err), (0, "", ""))

    def test_check(self):
        self.limes("verify", "chaikin")
        good = self.dir / "certificates" / "chaikin.1.C1.json"
        bad = self.write("bad.json", good.read_text().replace('"C1"', '"C2"'))
        for program, verb in ((LIMES, ["check"]), (LIMES_CHECK, [])):
            run = Run(*verb, good, program=program)
            self.assertEqual(run.status, 0)
            self.assertIn(": valid: ", run.out)
            run = Run(*verb, good, bad, program=program)
            self.assertEqual(run.status, 1)
            self.assertIn(f"{bad}: invalid: ", run.out)
            run = Run(*verb, "--json", good, bad, program=program)
            results = json.loads(run.out)["results"]
            self.assertEqual([r["valid"] for r in results], [True, False])
            self.assertTrue(results[1]["step"] and results[1]["reason"])
            run = Run(*verb, self.dir / "missing.json", program=program)
            self.assert_bad_input(run, "missing.json")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
