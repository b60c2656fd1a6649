"""Nonstationary schemes on the command line: the examples stay on their curves, claims about angles, errors.

Run by CTest as: python3 nonstationary_test.py LIMES LIMES_CHECK EXAMPLES CERTIFICATES
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

from limes_case import LimesCase

LIMES, LIMES_CHECK, EXAMPLES, CERTIFICATES = sys.argv[1:5]
EXAMPLES = pathlib.Path(EXAMPLES)


def run(*arguments, program=LIMES, cwd=None):
    return subprocess.run([program, *map(str, arguments)], cwd=cwd, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=120, check=False)


def points(path):
    lines = path.read_text().splitlines()
    return [tuple(map(float, line.split(","))) for line in lines if line and not line.startswith("#")]


class Nonstationary(LimesCase):
    def refined(self, scheme, data, *arguments, levels=10):
        out = self.dir / "out.csv"
        done = run("refine", scheme, EXAMPLES / data, "--levels", levels, "-o", out, *arguments, cwd=EXAMPLES)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return points(out)

    def test_conics(self):
        for x, y in self.refined("unified-curve", "heptagon.csv", "--closed", "--param", "theta=2*pi/7"):
            self.assertLess(abs(math.hypot(x, y) - 1), 1e-13)
        for x, y in self.refined("unified-curve", "ellipse.csv", "--closed", "--param", "theta=pi/4"):
            self.assertLess(abs(math.hypot((x - y / 2) / 2, y) - 1), 1e-13)
        for x, y in self.refined("unified-curve", "arc.csv", "--param", "theta=pi/5", "--ends", "exact"):
            self.assertLess(abs(math.hypot(x, y) - 1), 1e-13)
        for x, y in self.refined("unified-curve", "hyperbola.csv", "--param", "type=hyperbolic", "--param", "theta=4/5", "--ends", "exact"):
            self.assertLess(abs(x * x - y * y - 1), 1e-12)
        for x, y in self.refined("unified-curve", "parabola.csv", "--param", "type=polynomial", "--ends", "exact"):
            self.assertLess(abs(x * x - y), 1e-12)

    def test_cycloid_and_spiral(self):
        curve = self.refined("unified-curve", "cycloid.csv", "--param", "theta=pi/3", "--ends", "exact", levels=6)
        for k, p in enumerate(curve):
            u = 4 * math.pi * k / (len(curve) - 1)
            self.assertLess(math.dist(p, (u - math.sin(u), 1 - math.cos(u))), 1e-12)
        for scheme, bound in (("./spiral.toml", 1e-12), ("unified-curve", 0.04)):
            curve = self.refined(scheme, "spiral.csv", "--param", "theta=pi/4", "--ends", "exact", levels=6)
            worst = max(math.dist(p, (u * math.cos(u), u * math.sin(u)))
                        for p, u in ((p, 4 * math.pi * k / (len(curve) - 1)) for k, p in enumerate(curve)))
            self.assertLess(worst, bound)
            self.assertGreater(worst, 0 if bound < 1e-3 else 0.02)

    def test_the_readme_commands_make_the_pictures_that_ship(self):
        commands = re.findall(r"`limes (refine [^`]*)`", (EXAMPLES / "README.md").read_text())
        self.assertGreaterEqual(len(commands), 7)
        for command in commands:
            *arguments, picture = command.split()
            out = self.dir / picture
            done = run(*arguments, out, cwd=EXAMPLES)
            self.assertEqual((done.returncode, done.stderr), (0, ""), command)
            self.assertEqual(out.read_text(), (EXAMPLES / picture).read_text(), picture)

    def test_verify(self):
        done = run("verify", "unified-curve", "exponential-b-spline-3", "exponential-b-spline-4", "six-point-nonstationary",
                   EXAMPLES / "spiral.toml", "--json", "--certificates", CERTIFICATES)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        self.assertEqual(result["summary"]["refuted"], 0)
        for entry in result["results"]:
            self.assertEqual(entry["verdict"], entry["expected"])
            self.assertIn(entry["type"], ("trigonometric", "hyperbolic"))
            if entry["verdict"] == "certified":
                self.assertEqual(entry["theorem"], "S1" if entry["claim"].startswith("C") else "S2")
                self.assertEqual(run(entry["certificate"], program=LIMES_CHECK).returncode, 0)
        self.assertIn("limes-certificate", (pathlib.Path(CERTIFICATES) / "unified-curve.1.C1.json").read_text())

    def test_angles(self):
        done = run("verify", "unified-curve", "--param", "theta=2*pi/7", "--json", cwd=self.dir)
        self.assertEqual(done.returncode, 0)
        results = json.loads(done.stdout)["results"]
        self.assertIn("C1", [entry["claim"] for entry in results])
        self.assertAlmostEqual(eval(results[0]["region"]["theta"][0]), 2 * math.pi / 7, places=15)
        done = run("verify", "unified-curve", "--claim", "reproduces {1, y^2}", cwd=self.dir)
        self.assertEqual(done.returncode, 1)
        self.assertIn("y^2 is not reproduced", done.stdout)
        done = run("verify", "unified-curve", "--claim", "reproduces {y^2, y^3}", "--param", "type=polynomial", cwd=self.dir)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(run("verify", "unified-curve", "--claim", "C2", "--param", "theta=1", cwd=self.dir).returncode, 3)

    def test_show_and_list(self):
        text = run("show", "unified-curve").stdout
        for part in ("nonstationary", "mu = cosh(theta/2^(k+1))", "reproduces {1, y, cos, sin}", "not y^2: moment 2 at residue 1"):
            self.assertIn(part, text)
        spaces = json.loads(run("show", "exponential-b-spline-4", "--json").stdout)["sequence"]["spaces"]
        self.assertEqual(spaces["hyperbolic"]["generated"], ["1", "y", "cosh", "sinh"])
        self.assertEqual(spaces["trigonometric"]["reproduced"], ["1", "y"])
        self.assertIn("mu", run("show", "unified-curve", "--latex").stdout)
        kinds = {s["name"]: s["kind"] for s in json.loads(run("list", "--json").stdout)["schemes"]}
        self.assertEqual(kinds["unified-curve"], "nonstationary")

    def test_bad_input(self):
        heptagon = EXAMPLES / "heptagon.csv"
        for arguments, part in (
                (("verify", "unified-curve", "--param", "theta=4"), "outside of the parameter's range"),
                (("verify", "unified-curve", "--param", "theta=pi"), "outside of the parameter's range"),
                (("verify", "unified-curve", "--param", "theta=pi^2"), "no angle"),
                (("verify", "unified-curve", "--param", "type=spherical"), "no such type"),
                (("verify", "unified-curve", "--param", "type=polynomial", "--param", "theta=1"), "given twice"),
                (("verify", "unified-curve", "--claim", "reproduces {cosh}"), "trigonometric type"),
                (("verify", "unified-curve", "--claim", "reproduces {tan}"), "no function"),
                (("verify", "four-point", "--claim", "reproduces {1}"), "not a nonstationary scheme"),
                (("verify", "four-point", "--param", "w=pi/100"), "--param w=pi/100"),
                (("norm", "unified-curve", "--order", "1", "--level", "2"), "nonstationary"),
                (("matrix", "unified-curve"), "nonstationary"),
                (("refine", "unified-curve", heptagon, "-o", "x.csv"), "--param theta=VALUE"),
                (("refine", "unified-curve", heptagon, "--param", "theta=[0,1]", "-o", "x.csv"), "--param theta=VALUE"),
                (("refine", "four-point", heptagon, "--param", "w=1/16", "--ends", "exact", "-o", "x.csv"), "not a nonstationary scheme"),
                (("refine", "unified-curve", heptagon, "--param", "theta=1", "--knots", "chordal", "-o", "x.csv"), "equally spaced")):
            done = run(*arguments, cwd=self.dir)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(part, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
