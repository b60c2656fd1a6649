"""What the tests of the command line share: a directory of its own for each test, the program (the first argument of every test), and the
form of errors."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # nothing is left in the source tree

OWN_SCHEME = """name = "mine"
kind = "uniform"
[parameters]
w = ["0", "1/4"]
[uniform]
mask = ["-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"]
[[claims]]
claim = "C1"
region = { w = ["1/100", "1/8"] }
"""


class LimesCase(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="limes-test-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def run_program(self, *arguments, program=None, timeout=200):
        return subprocess.run([program or sys.argv[1], *map(str, arguments)], cwd=self.dir, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=timeout, check=False)

    def limes(self, *arguments):
        return self.run_program(*arguments)

    def assert_bad_input(self, run, *parts):
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, "one clear line: " + run.stderr)
        for part in parts:
            self.assertIn(part, run.stderr)

    def write(self, name, text):
        (self.dir / name).write_text(text, encoding="utf-8")
        return "./" + name
