"""C1 at extraordinary vertices, and pictures of characteristic maps, as a user meets them.

Run by CTest as: python3 characteristic_map_test.py LIMES LIMES_CHECK
"""

import json
import sys
import unittest

from limes_case import LimesCase

LIMES_CHECK = sys.argv[2]


class CharacteristicMaps(LimesCase):
    def test_smooth_at_every_valence(self):
        for scheme in ("unified", "catmull-clark", "doo-sabin"):
            angle = ("--param", "theta=0") if scheme == "unified" else ()
            run = self.run_program("verify", scheme, "--claim", "C1", *angle, "--certificates", self.dir / "c", "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            result, = json.loads(run.stdout)["results"]
            self.assertEqual((result["verdict"], result["theorem"]), ("certified", "E2"))
            checked = self.run_program(result["certificate"], program=LIMES_CHECK)
            self.assertEqual(checked.returncode, 0, checked.stdout)
            self.assertIn("C1 for almost every net at extraordinary", checked.stdout)
            self.assertIn("of all valences", checked.stdout)

    def test_rules_that_change_are_undecided(self):
        run = self.run_program("verify", "unified", "--claim", "C1", "--param", "theta=1", "--valence", "5", "--certificates", self.dir)
        self.assertEqual(run.returncode, 3, run.stdout + run.stderr)
        self.assertIn("theta != 0", run.stdout)

    def test_pictures(self):
        run = self.run_program("show", "unified", "--characteristic-map", "5", "-o", "map.svg", "-o", "map.png", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual([output["kind"] for output in json.loads(run.stdout)["outputs"]], ["svg", "png"])
        self.assertIn("0.537944", (self.dir / "map.svg").read_text())
        self.assertTrue((self.dir / "map.png").read_bytes().startswith(b"\x89PNG"))

    def test_user_errors(self):
        for arguments, reason in ((("show", "four-point", "--characteristic-map", "5", "-o", "map.svg"), "no surface scheme"),
                                  (("show", "unified", "--characteristic-map", "5"), "needs a file"),
                                  (("show", "unified", "--characteristic-map", "5", "-o", "map.obj"), "ending"),
                                  (("show", "unified", "--characteristic-map", "2", "-o", "map.svg"), "characteristic-map"),
                                  (("show", "unified", "-o", "map.svg"), "belongs to --characteristic-map")):
            run = self.run_program(*arguments)
            self.assertEqual(run.returncode, 2, run.stdout)
            self.assertIn(reason, run.stderr)
            self.assertFalse((self.dir / "map.svg").exists())


unittest.main(argv=sys.argv[:1])
