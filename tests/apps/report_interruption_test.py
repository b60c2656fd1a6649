"""limes report that is interrupted (Ctrl-C, budget) or whose LaTeX fails. Run by CTest as: python3 report_interruption_test.py LIMES

Nothing here depends on the speed of the machine: the signal is sent once a line of progress or a file says how far the work is, and what is then left
to do takes far longer than any time limit.
"""

import json
import os
import pathlib
import pty
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest

from limes_case import LimesCase, OWN_SCHEME

LIMES = sys.argv[1]
HAS_TEX = shutil.which("latexmk") is not None and shutil.which("pdflatex") is not None
PATIENCE = 120  # seconds, before a test is given up

# The second claim is true up to w* = 0.19273.. : so near to it nothing that is tried succeeds soon.
HARD_CLAIMS = OWN_SCHEME + "".join(f'[[claims]]\nclaim = "C1"\nregion = {{ w = ["{k}/10000", "1927292/10000000"] }}\n' for k in range(1, 200))

# Hundreds of thousands of samples for each of the least-squares problems of the table of costs.
HARD_STUDY = """name = "heavy"
kind = "uniform"
[uniform]
first_index = -2
mask = ["1/8", "1/2", "3/4", "1/2", "1/8"]
[weight]
function = "polynomial(-1024+1280*u^2-640*u^4+160*u^6-20*u^8+u^10, domain=[-2,2])"
samples = 10000000
precision = 256
[[claims]]
claim = "C2"
"""


def is_running(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


class Case(LimesCase):
    def environment(self, tools=None):
        path = os.environ["PATH"]
        return dict(os.environ, PATH=f"{tools}:{path}" if tools else path)

    def tool(self, name, script):
        tools = self.dir / "tools"
        tools.mkdir(exist_ok=True)
        (tools / name).write_text("#!/bin/sh\n" + script)
        (tools / name).chmod(0o755)
        return tools

    def files(self):
        root = self.dir / "r"
        return {str(path.relative_to(root)) for path in root.rglob("*") if path.is_file()}

    def interrupt(self, *arguments, when, tools=None):
        """Runs limes report with a terminal as stderr and sends SIGINT once `when` (what was written there -> bool) holds: status and what was written."""
        terminal, stderr = pty.openpty()
        written = []

        def read():
            try:
                while data := os.read(terminal, 4096):
                    written.append(data.decode(errors="replace"))
            except OSError:  # the other end is closed
                pass

        process = subprocess.Popen([LIMES, "report", *map(str, arguments), "-o", "r"], cwd=self.dir, env=self.environment(tools), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=stderr)
        os.close(stderr)
        reader = threading.Thread(target=read)
        reader.start()
        try:
            deadline = time.monotonic() + PATIENCE
            while not when("".join(written)):
                self.assertIsNone(process.poll(), "ended too soon: " + "".join(written))
                self.assertLess(time.monotonic(), deadline, "".join(written))
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            status = process.wait(timeout=PATIENCE)
        finally:
            process.kill()
            process.wait()
            reader.join()
            os.close(terminal)
        return status, "".join(written).replace("\r\n", "\n")

    def assert_whole(self, files):
        self.assertEqual([name for name in files if name.endswith(".part") or name.startswith(".latex")], [])
        self.assertTrue({"report.tex", "manifest.json"} <= files, files)
        self.assertNotIn("report.pdf", files)
        self.assertIn("\\end{document}", (self.dir / "r/report.tex").read_text())
        manifest = json.loads((self.dir / "r/manifest.json").read_text())
        self.assertTrue({entry["file"] for entry in manifest["files"]} <= files)

class Interruption(Case):
    def test_while_deciding(self):
        (self.dir / "slow.toml").write_text(HARD_CLAIMS)
        status, written = self.interrupt("slow.toml", "--threads", "1", when=lambda text: "1 of 200 claims" in text)
        self.assertEqual(status, 3)
        self.assertRegex(written, r"limes: interrupted: \d+ of 200 claims undecided for this reason")
        self.assert_whole(self.files())
        self.assertIn("certificates/mine.1.C1.json", self.files())
        self.assertIn("interrupted", (self.dir / "r/report.tex").read_text())

    def test_while_studying(self):
        (self.dir / "heavy.toml").write_text(HARD_STUDY)
        status, written = self.interrupt("chaikin", "heavy.toml", "--threads", "1", "--no-pdf", when=lambda text: "1 of 2 schemes" in text)
        self.assertEqual(status, 3)
        self.assertIn("limes: interrupted: all 3 claims were decided", written)
        self.assert_whole(self.files())
        self.assertTrue({"certificates/heavy.1.C2.json", "certificates/chaikin.1.C1.json"} <= self.files())

    def test_while_latex_runs(self):
        started = self.dir / "started"
        # As latexmk does, it waits for a child of its own.
        tools = self.tool("latexmk", f"mkdir -p .latex\necho half > .latex/figures.pdf\nsleep 1000 &\necho $$ $! > {started}.part\nmv {started}.part {started}\nwait\n")
        status, written = self.interrupt("chaikin", when=lambda text: started.exists(), tools=tools)
        self.assertEqual(status, 3)
        self.assertIn("limes: interrupted: all 2 claims were decided", written)
        self.assert_whole(self.files())
        self.assertNotIn("figures.pdf", self.files())
        self.assertFalse((self.dir / "r/.latex").exists())
        pids = started.read_text().split()
        deadline = time.monotonic() + PATIENCE
        while any(map(is_running, pids)) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual([pid for pid in pids if is_running(pid)], [])

    def test_budget(self):
        (self.dir / "slow.toml").write_text(HARD_CLAIMS)
        run = subprocess.run([LIMES, "report", "slow.toml", "-o", "r", "--budget", "1"], cwd=self.dir, capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual(run.returncode, 3)
        self.assertRegex(run.stderr, r"^limes: the time budget is used up: \d+ of 200 claims undecided for this reason; the report has the others\n$")
        self.assert_whole(self.files())
        self.assertIn("the time budget is used up", (self.dir / "r/report.tex").read_text())

    def test_an_older_report_does_not_survive_an_interruption(self):
        (self.dir / "r").mkdir()
        for name in ("report.pdf", "figures.pdf", "figures.tex", "report.log"):
            (self.dir / "r" / name).write_text("old")
        (self.dir / "slow.toml").write_text(HARD_CLAIMS)
        run = subprocess.run([LIMES, "report", "slow.toml", "-o", "r", "--budget", "0.2"], cwd=self.dir, capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual(run.returncode, 3)
        self.assert_whole(self.files())
        self.assertEqual({"figures.pdf", "figures.tex", "report.log"} & self.files(), set())


class Latex(Case):
    def run_report(self, *arguments, tools=None):
        return subprocess.run([LIMES, "report", *arguments, "-o", "r"], cwd=self.dir, env=self.environment(tools), capture_output=True, text=True, timeout=PATIENCE,
                              check=False)

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_broken_pdflatex(self):
        # The real latexmk with an engine that fails.
        tools = self.tool("pdflatex", "for s; do :; done\nname=$(basename \"$s\" .tex)\n"
                          "printf 'This is pdfTeX\\n./%s.tex:12: LaTeX Error: File `nonsense.sty'\"'\"' not found.\\n\\nl.12 x\\n./%s.tex:13: Another.\\n' $name $name > .latex/$name.log\n"
                          "exit 1\n")
        run = self.run_report("chaikin", tools=tools)
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        found = re.search(r"LaTeX failed: figures\.tex:12: LaTeX Error: File `nonsense\.sty' not found\. \(the log is (.*)\)", run.stderr)
        self.assertTrue(found, run.stderr)
        self.assertTrue((self.dir / found[1]).is_file())
        self.assertFalse((self.dir / "r/.latex").exists())
        self.assertTrue({"report.tex", "certificates/chaikin.1.C1.json"} <= self.files())
        self.assertNotIn("report.pdf", self.files())

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_pdflatex_that_dies(self):
        run = self.run_report("chaikin", tools=self.tool("pdflatex", "kill -9 $$\n"))
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"^limes: LaTeX failed: latexmk's status \d+")
        self.assertFalse((self.dir / "r/.latex").exists())

    def test_same_bytes_again_whatever_the_threads(self):
        trees = []
        for threads in ("1", "2"):
            self.assertEqual(self.run_report("cinpact-2.5", "chaikin", "--no-pdf", "--threads", threads).returncode, 0)
            trees.append({name: (self.dir / "r" / name).read_bytes() for name in self.files()})
            shutil.rmtree(self.dir / "r")
        self.assertEqual(trees[0], trees[1])
        self.assertTrue(any(".sum-rules-" in name for name in trees[0]))

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_pdf_of_a_weight_function_twice_the_same_bytes(self):
        pdfs = []
        for _ in range(2):
            self.assertEqual(self.run_report("cinpact-2.5").returncode, 0)
            pdfs.append((self.dir / "r/report.pdf").read_bytes())
            shutil.rmtree(self.dir / "r")
        self.assertEqual(pdfs[0], pdfs[1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
