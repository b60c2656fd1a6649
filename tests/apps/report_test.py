"""limes report as an author meets it. Run by CTest as: python3 report_test.py LIMES CERTIFICATES

Certificates go to CERTIFICATES too, where script/test checks them once more.
"""

import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

LIMES, CERTIFICATES = sys.argv[1:3]
HAS_TEX = shutil.which("latexmk") is not None and shutil.which("pdflatex") is not None


class Report(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="limes-test-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def report(self, *arguments, env=None):
        return subprocess.run([LIMES, "report", *map(str, arguments)], cwd=self.dir, env=dict(os.environ, **(env or {})), capture_output=True, text=True,
                              timeout=500, check=False)

    def files(self, directory):
        root = self.dir / directory
        return {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}

    def test_source_figures_certificates_and_manifest(self):
        run = self.report("four-point", "cr2", "--no-pdf", "--json", "-o", "r")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        outputs = json.loads(run.stdout)["outputs"]
        self.assertEqual({output["kind"] for output in outputs}, {"pgf", "svg", "csv", "certificate", "latex", "latex-figures", "manifest"})
        files = self.files("r")
        self.assertEqual({str(pathlib.Path(output["file"]).relative_to("r")) for output in outputs}, set(files))
        manifest = json.loads(files["manifest.json"])
        self.assertEqual(manifest["command"], ["limes", "report", "four-point", "cr2", "-o", "r"])
        for entry in manifest["files"]:
            self.assertEqual(hashlib.sha256(files[entry["file"]]).hexdigest(), entry["sha256"])
        text = files["report.tex"].decode()
        for name in re.findall(r"\\limesplot\{([^}]*)\}", text):
            self.assertIn(f"figures/{name}.pgf", files)
        certificate = next(name for name in files if name.startswith("certificates/cr2.1"))
        self.assertIn(hashlib.sha256(files[certificate]).hexdigest()[:12], text)
        pathlib.Path(CERTIFICATES).mkdir(parents=True, exist_ok=True)
        (pathlib.Path(CERTIFICATES) / "report.cr2.json").write_bytes(files[certificate])

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_pdf_twice_the_same_bytes(self):
        pdfs = []
        for name in ("a", "b"):
            run = self.report("four-point", "a2-5-3", "-o", "r", env={"SOURCE_DATE_EPOCH": "1600000000"})
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            pdfs.append(self.files("r"))
            shutil.move(self.dir / "r", self.dir / name)
        self.assertEqual(pdfs[0], pdfs[1])
        self.assertNotIn("report.log", pdfs[0])
        self.assertIn("figures.pdf", pdfs[0])
        if shutil.which("pdftotext"):
            text = subprocess.run(["pdftotext", "-layout", self.dir / "a/report.pdf", "-"], capture_output=True, text=True, check=True).stdout
            for words in ("certified", "refuted", "Theorem U1", "Theorem N1", "2020-09-13", "Erratum", "References", "all digits are right", "Comparisons"):
                self.assertIn(words, text)
            self.assertNotIn("??", text)

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_no_overfull_boxes_and_no_undefined_references(self):
        self.assertEqual(self.report("cr1", "a3-5-3-3", "ternary-four-point", "unified-curve", "--no-pdf", "-o", "r").returncode, 0)
        for source in ("figures", "report", "report", "report"):
            subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", source], cwd=self.dir / "r", capture_output=True, check=True)
        log = (self.dir / "r/report.log").read_text(errors="replace")
        self.assertNotIn("There were undefined", log)
        tolerance = 1.0  # points
        wide = [float(x) for x in re.findall(r"Overfull \\hbox \(([0-9.]+)pt", log)]
        self.assertEqual([x for x in wide if x > tolerance], [])

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_fragment_in_a_plain_article(self):
        run = self.report("cr2", "--claim", "C2", "--fragment", "-o", "appendix.tex")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        (self.dir / "paper.tex").write_text("\\documentclass{article}\\begin{document}\n\\appendix\n\\input{appendix}\n\\end{document}\n")
        done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "paper.tex"], cwd=self.dir, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue((self.dir / "cr2.asked.1.C2.json").is_file())

    def test_markdown(self):
        run = self.report("chaikin", "--format", "markdown", "-o", "m")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        files = self.files("m")
        text = files["report.md"].decode()
        self.assertIn("# Smoothness of subdivision schemes", text)
        for picture in re.findall(r"\]\((figures/[^)]*)\)", text):
            self.assertIn(picture, files)

    def test_latex_error_is_told(self):
        tools = self.dir / "tools"
        tools.mkdir()
        fake = tools / "latexmk"
        fake.write_text("#!/bin/sh\nmkdir -p .latex\nfor s; do :; done\necho './report.tex:7: Undefined control sequence.' > .latex/${s%.tex}.log\nexit 12\n")
        fake.chmod(0o755)
        run = self.report("chaikin", "-o", "r", env={"PATH": f"{tools}:{os.environ['PATH']}"})
        self.assertEqual(run.returncode, 2)
        self.assertIn("LaTeX failed: report.tex:7: Undefined control sequence. (the log is ", run.stderr)
        fake.unlink()
        run = self.report("chaikin", "-o", "r", env={"PATH": str(tools)})
        self.assertEqual(run.returncode, 2)
        self.assertIn("--no-pdf", run.stderr)

    @unittest.skipUnless(HAS_TEX, "no LaTeX")
    def test_plots_of_pgfplots_compile_too(self):
        self.assertEqual(self.report("chaikin", "--no-pdf", "-o", "r").returncode, 0)
        done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "report"], cwd=self.dir / "r", capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("figures/chaikin-limit-1.pgf", done.stdout.replace("\n", ""))

    def test_nonstationary_and_surface_schemes(self):
        run = self.report("exponential-b-spline-3", "unified", "--no-pdf", "--json", "-o", "r")
        self.assertEqual(run.stderr, "")
        files = self.files("r")
        self.assertIn("figures/exponential-b-spline-3-angles-1.svg", files)
        self.assertIn("figures/unified-surfaces-1.svg", files)
        text = files["report.tex"].decode()
        self.assertIn("Every step generates the functions", text)
        self.assertIn("Undecided:", text)

    def test_directory_that_cannot_be_made(self):
        (self.dir / "file").write_text("")
        run = self.report("chaikin", "--no-pdf", "-o", "file/r")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"^limes: .*file/r")

    def test_bad_usage_and_status(self):
        self.assertEqual(self.report("four-point").returncode, 2)
        self.assertIn("to a .tex file", self.report("four-point", "--fragment", "-o", "x").stderr)
        self.assertEqual(self.report("four-point", "--format", "word", "-o", "x").returncode, 2)
        run = self.report("four-point", "--claim", "C2", "--param", "w=1/16", "--no-pdf", "-o", "r")
        self.assertEqual(run.returncode, 1, "refuted where certainty was expected")
        self.assertIn("It is false that for $w=1/16$", (self.dir / "r/report.tex").read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
