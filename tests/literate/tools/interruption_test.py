# SPDX-License-Identifier: GPL-3.0-or-later
"""After any interruption the next plain build gives the bytes of a clean build."""

import os
import random
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from paper import CASE, MORE, SCRIPT, Paper, PaperTest

from literate_tools.settings import read_settings
from literate_tools.typeset import clear, pdflatex, run_latex

# Behaves like the program of its name, and does something after the first of its work.
WRAPPER = """#!/bin/sh
PATH={path}
{name} "$@"
code=$?
[ -e {marker} ] && exit $code
touch {marker}
{act}
exit $code
"""


# Waits before a script computes, the first time.
SLEEPING = """import os, time
if not os.path.exists("{marker}"):
    open("{marker}", "w")
    time.sleep(60)
"""


class Interruptions(PaperTest):
    def setUp(self) -> None:
        super().setUp()
        self.tools = self.paper.folder.parent / "bin"
        self.tools.mkdir()
        self.marker = self.paper.folder.parent / "reached"

    def wrap(self, name: str, act: str) -> None:
        """Puts a wrapper of a tool first on the PATH."""
        path = os.environ["PATH"]
        script = self.tools / name
        script.write_text(WRAPPER.format(path=path, name=name, marker=self.marker, act=act))
        script.chmod(0o755)
        self.paper.environment["PATH"] = f"{self.tools}:{path}"

    def edit(self) -> None:
        """Edits numbers, figure and words."""
        self.paper.replace("case.toml", "x = 1.5", "x = 1.75")
        self.paper.replace("case.toml", "slope = 2.0", "slope = 3.0")
        self.paper.replace("paper/sections/more.tex", "More", "\\newpage Much")

    def assert_recovers(self) -> None:
        """Builds without wrappers and compares with a clean build."""
        self.paper.environment["PATH"] = os.environ["PATH"]
        self.make()
        self.assertEqual(self.paper.pdf.read_bytes(), self.paper.clean_pdf())

    def stop_when_reached(self, kill) -> None:
        """Starts a build and stops it while the wrapped tool runs."""
        build = subprocess.Popen(["ninja", "-C", str(self.paper.build), "small"], cwd=self.paper.folder, env=self.paper.environment,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
                                 preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # a shell ignores it in the background
        while not self.marker.exists():
            self.assertIsNone(build.poll(), "the build ended before the tool was reached")
            time.sleep(0.01)
        kill(build)
        build.wait()
        self.marker.unlink()

    def reset(self) -> None:
        """Builds the paper before the edit."""
        self.paper.write("case.toml", CASE)
        self.paper.write("paper/sections/more.tex", MORE)
        self.paper.environment["PATH"] = os.environ["PATH"]
        self.make()

    def test_ctrl_c(self):
        for name in ("script", "gnuplot", "pdflatex"):
            with self.subTest(name):
                self.reset()
                pdf = self.paper.pdf.read_bytes()
                self.edit()
                if name == "script":
                    self.paper.write("compute.py", SLEEPING.format(marker=self.marker) + SCRIPT)
                else:
                    self.wrap(name, "sleep 60")
                self.stop_when_reached(lambda build: build.send_signal(signal.SIGINT))
                self.assertEqual(self.paper.pdf.read_bytes(), pdf)  # the previous one stays
                self.paper.write("compute.py", SCRIPT)
                self.assert_recovers()

    def test_kill_9_with_half_written_files(self):
        latex = self.paper.output / "latex"
        half = "for f in {}; do head -c $(($(stat -c %s \"$f\") / 2)) \"$f\" >\"$f.half\" && mv \"$f.half\" \"$f\"; done; sleep 60"
        for what, name, files in [("a drawing", "gnuplot", "line.pdf line.tex"),
                                  ("LaTeX's own files", "pdflatex", f"{latex}/small.aux {latex}/small.pdf {latex}/small.log {latex}/small.fls")]:
            with self.subTest(what):
                self.reset()
                self.edit()
                self.wrap(name, half.format(files))
                self.stop_when_reached(kill_session)
                self.assert_recovers()

    def test_a_missing_tool_and_a_tool_that_fails(self):
        for name, package in (("gnuplot", "gnuplot-nox"), ("pdflatex", "texlive-latex-base")):
            with self.subTest(f"{name} is missing"):
                shutil.rmtree(self.tools)
                self.tools.mkdir()
                for tool in ("sh", "ninja", "cmake", "gnuplot", "pdflatex"):
                    if tool != name:
                        (self.tools / tool).symlink_to(shutil.which(tool))
                self.paper.environment["PATH"] = str(self.tools)
                self.assertIn(f"{name} is not installed (Debian package {package})", self.make(1))
                self.assert_recovers()
                self.edit()
            with self.subTest(f"{name} fails"):
                shutil.rmtree(self.tools)
                self.tools.mkdir()
                (self.tools / name).write_text("#!/bin/sh\necho out of order; exit 7\n")
                (self.tools / name).chmod(0o755)
                self.paper.environment["PATH"] = f"{self.tools}:{os.environ['PATH']}"
                self.assertIn("out of order", self.make(1))
                self.assert_recovers()
            shutil.rmtree(self.paper.folder)
            self.paper = Paper(self.paper.folder)

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("mount"), "only root mounts a small disk")
    def test_a_full_disk(self):
        disk = self.paper.build
        disk.mkdir(parents=True)
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", disk], check=True)
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        for left in (0, 4096, 20000, 60000, 100000):
            with self.subTest(f"{left} bytes are left"):
                self.reset()
                pdf = self.paper.pdf.read_bytes()
                self.edit()
                fill(disk / "filler", left)
                code, output = self.paper.make()
                if self.paper.pdf.read_bytes() != pdf:
                    self.assertEqual(self.paper.pdf.read_bytes(), self.paper.clean_pdf())
                (disk / "filler").unlink()
                self.assert_recovers()

    def test_auxiliary_files_of_a_removed_package_do_no_harm(self):
        self.paper.replace("paper/small.tex", r"\begin{document}", "\\usepackage{hyperref}\n\\begin{document}\n\\tableofcontents")
        self.make()
        self.paper.replace("paper/small.tex", "\\usepackage{hyperref}\n", "")
        self.assert_recovers()


def fill(file: Path, left: int) -> None:
    """Fills a disk with a file, except for some bytes."""
    with open(file, "wb", buffering=0) as out:
        try:
            while out.write(b"x" * 4096):
                pass
        except OSError:
            pass
    os.truncate(file, max(file.stat().st_size - left, 0))


def kill_session(build: subprocess.Popen) -> None:
    """Kills a build and all of its processes."""
    for process in Path("/proc").glob("[0-9]*"):
        try:
            session = int((process / "stat").read_text().rpartition(")")[2].split()[3])
            if session == build.pid:
                os.kill(int(process.name), signal.SIGKILL)
        except (OSError, ValueError):
            pass


class ManyEdits(PaperTest):
    N_BUILDS = 200

    def test_page_numbers_are_never_those_of_an_earlier_text(self):
        # A page holds a dozen lines, so most edits move something to a different page.
        self.paper.write("paper/small.tex", r"""\documentclass{article}
\textheight=12\baselineskip
\begin{document}
\tableofcontents\listoffigures
\input{a}\input{b}\input{c}
\end{document}
""")
        for name in "abc":
            self.paper.write(f"paper/{name}.tex", self.section(name, 3, 1))
        self.paper.make("small-results")
        settings = read_settings(self.paper.settings)
        dice = random.Random(2385)
        for build in range(self.N_BUILDS):
            name = dice.choice("abc")
            self.paper.write(f"paper/{name}.tex", self.section(name, dice.randint(0, 14), dice.randint(0, 2)))
            pdf = run_latex(settings).read_bytes()
            if build % 20 == 19:
                clear(settings)
                self.assertEqual(run_latex(settings).read_bytes(), pdf, f"build {build}")
            elif build % 5 == 4:
                self.assertEqual(pdflatex(settings), [])
                self.assertEqual((settings.latex / "small.pdf").read_bytes(), pdf, f"build {build}")

    def section(self, name: str, n_lines: int, n_figures: int) -> str:
        """Returns a section with this many lines and figures, which cites the other sections by page."""
        figures = "".join(f"\\begin{{figure}}[h]\\caption{{{name}{i}}}\\end{{figure}}\n" for i in range(n_figures))
        lines = "".join(f"Line {i}, see \\ref{{a}}, \\ref{{b}} on page \\pageref{{b}}, \\ref{{c}} on page \\pageref{{c}}.\n\n" for i in range(n_lines))
        return f"\\section{{{name}}}\\label{{{name}}}\n{lines}{figures}"


if __name__ == "__main__":
    unittest.main()
