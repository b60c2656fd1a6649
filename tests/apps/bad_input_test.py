"""Input that is wrong, hostile, or of another kind than a verb is about: one clear line, status 2, and no damage.

Run by CTest as: python3 bad_input_test.py LIMES
"""

import json
import sys
import unittest

from limes_case import LimesCase


class BadInput(LimesCase):
    def test_verbs_about_one_mask_refuse_schemes_without_one(self):
        for scheme, kind in (("unified", "surface"), ("catmull-clark", "surface"), ("unified-curve", "nonstationary")):
            for verb in (["norm", scheme, "--order", "0", "--level", "2"], ["holder", scheme], ["map", scheme, "--claim", "C1"],
                         ["matrix", scheme]):
                self.assert_bad_input(self.limes(*verb), f"{scheme} is a {kind} scheme", verb[0])

    def test_a_surface_scheme_that_leads_to_itself(self):
        own = self.write("self.toml", 'name = "self"\nkind = "surface"\n[surface]\ncurve = "self.toml"\n')
        self.assert_bad_input(self.limes("verify", own), "self.toml", "is no surface scheme")
        one = self.write("one.toml", 'name = "one"\nkind = "surface"\n[surface]\ncurve = "two.toml"\n')
        self.write("two.toml", 'name = "two"\nkind = "surface"\n[surface]\ncurve = "one.toml"\n')
        self.assert_bad_input(self.limes("show", one), "one.toml", "is no surface scheme")
        self.assert_bad_input(self.limes("show", self.write("b.toml", 'name = "b"\nkind = "surface"\n[surface]\ncurve = "unified"\n')),
                              "is no surface scheme")

    def test_a_long_chain_of_definitions(self):
        def chain(length, height):
            lines = [f'a{k:03} = "a{k + 1:03}{"*1" * height}"' for k in range(length)] + [f'a{length:03} = "1"']
            return ('name = "deep"\nkind = "nonuniform"\n[nonuniform]\npoints = 4\n[nonuniform.let]\n' + "\n".join(lines) +
                    '\n[nonuniform.rule]\nnew = "a000*at(f(3,0),1/2)"\n')
        run = self.limes("show", self.write("chain.toml", chain(200, 3)))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assert_bad_input(self.limes("show", self.write("deep.toml", chain(250, 90))), "deep.toml")

    def test_deeply_nested_json(self):
        deep = "[" * 200000
        for text in (deep, deep + "]" * 200000, '{"a":' * 200000):
            self.assert_bad_input(self.limes("jsr", self.write("deep.json", text)), "deep.json")
        header = ('{"format":"limes-pyramid","version":1,"kind":"curve","rows":1,"columns":1,"channels":1,"levels":0,"boundary":"periodic",'
                  '"bits":8,"homogeneous":false,"filters":' + deep + "]" * 200000 + "}\n" + "\0" * 8)
        self.assertEqual(self.limes("multiresolution", "chaikin", "--extension", "2", "-o", "f.json").returncode, 0)
        self.assert_bad_input(self.limes("reconstruct", self.write("deep.pyr", header), "--filters", "f.json", "-o", "out.csv"), "deep.pyr")

    def test_a_directory_for_a_file(self):
        run = self.limes("check", "--json", ".", "missing.json")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr.count("\n"), 2, run.stderr)
        self.assertEqual(json.loads(run.stdout), {"results": []})
        self.assert_bad_input(self.limes("jsr", "."), "cannot read")
        self.assert_bad_input(self.limes("refine", "four-point", ".", "--param", "w=1/16", "-o", "out.csv"), "cannot read")

    def test_numbers_beyond_double(self):
        mask = f'name = "big"\nkind = "uniform"\n[uniform]\nmask = ["1{"0" * 400}", "1", "1-1{"0" * 400}", "1"]\n'
        run = self.limes("holder", self.write("big.toml", mask))
        self.assertIn(run.returncode, (0, 2, 3), run.stderr)
        self.assert_bad_input(self.limes("derive", "--weight", "polynomial(1e200*(1-u^2), domain=[-1,1])"), "range")
        self.assert_bad_input(self.limes("derive", "--weight", "polynomial(1-u^2, domain=[-1000000000,1000000000])", "--domain", "[-1,1]"),
                              "support")

    def test_moments_far_from_the_parametrisation(self):
        self.assert_bad_input(self.limes("show", self.write("shift.toml", 'name = "shift"\nkind = "nonstationary"\n[nonstationary]\n'
                                                            'types = { trigonometric = "[0, 1]" }\nfirst_index = 500000\nmask = ["mu", "1", "1"]\n')),
                              "too far")

    def test_an_angle_that_the_scheme_has_not(self):
        own = self.write("away.toml", 'name = "away"\nkind = "nonstationary"\n[nonstationary]\ntypes = { trigonometric = "[1, 2]" }\n'
                                      'interpolate = ["1", "y", "cos", "sin"]\n')
        square = self.write("square.csv", "0,0\n1,0\n1,1\n0,1\n")
        self.assert_bad_input(self.limes("refine", own, square, "--closed", "--param", "type=polynomial", "-o", "out.csv"), "outside")

    def test_an_output_that_is_the_input(self):
        square = self.write("square.csv", "0,0\n1,0\n1,1\n0,1\n")
        before = (self.dir / "square.csv").read_bytes()
        self.assert_bad_input(self.limes("refine", "four-point", square, "--closed", "--param", "w=1/16", "-o", square), "input")
        self.assertEqual((self.dir / "square.csv").read_bytes(), before)

    def test_hardly_any_time(self):
        for verb in (["holder", "four-point", "--param", "w=1/16"], ["holder", "deslauriers-dubuc-12"]):
            run = self.limes(*verb, "--budget", "0.001")
            self.assertEqual(run.returncode, 3, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
