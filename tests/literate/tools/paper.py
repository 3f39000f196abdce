# SPDX-License-Identifier: GPL-3.0-or-later
"""A small paper in a temporary folder, for tests. LITERATE_RESULTS is the path of literate-results."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ENGINE = Path(os.environ.get("LITERATE_ENGINE", Path(__file__).resolve().parents[3] / "src" / "literate"))
RESULTS = os.environ["LITERATE_RESULTS"]
LITERATE = [sys.executable, "-S", str(ENGINE / "tools" / "literate")]
sys.path.insert(0, str(ENGINE / "tools"))

CMAKE = """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES NONE)
set(literate_RESULTS "$ENV{LITERATE_RESULTS}")
include("$ENV{LITERATE_ENGINE}/cmake/LiteratePaper.cmake")
literate_add_paper(NAME small SCRIPT compute.py DOCUMENT paper MAIN small.tex CASE case.toml FIGURES figures
  SOURCES compute.py FAULTS faults.txt)
"""
CASE = "x = 1.5\nerror = 1e-4\nslope = 2.0\nlimit = 10.0\n"
SCRIPT = """import literate

def compute(document, case):
    x = literate.number(case["x"], error=case["error"], unit="m", digits=3)
    document.value("x", case["x"], error=case["error"], unit="m", digits=3)
    document.value("share", 0.25, error=1e-6, percent=1)
    document.value("title", "A & B")
    document.flag("big", case["x"] > 1)
    document.table("lengths", [literate.column("name"), literate.column("length", "m", decimals=2)],
                   [["first", (case["x"], case["error"])], ["second", (2.5, 1e-3)]])
    document.figure("line", 6, 4, {"points": {"a": [0, 1, 2], "b": [0, case["slope"], 2 * case["slope"]]}})
    document.claim("short", route="the number itself", criteria=[
        literate.at_most("length", x, literate.limit(case["limit"], "choice", "a room"))])

literate.run(compute)
"""
PROSE = r"""\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{literate}
\begin{document}
\section{Length}\label{sec:length}
\statement[us]{short}{It fits into a room of \val{share} of the house.}
It is \val{x}, or \val[2]{x}, \ifflag{big}{big}{small} \claim{short}.
\input{sections/more}
\begin{table}\caption{Lengths, such as \val{x}.}\label{tab:lengths}\tab{lengths}\end{table}
\begin{figure}\fig{line}\caption{A line.}\end{figure}
\claimledger
\end{document}
"""
MORE = "More is in table~\\ref{tab:lengths} on page~\\pageref{tab:lengths}: \\val{share} of \\val{title}.\n"
FAULTS = "big | compute.py | case[\"x\"] > 1 | case[\"x\"] > 2 | the flag\n"


class Paper:
    """A paper in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.build = folder / "build"
        self.output = self.build / "small"
        self.pdf = self.output / "small.pdf"
        self.settings = self.build / "small.json"
        self.environment = os.environ | {"LITERATE_ENGINE": str(ENGINE), "LC_ALL": "C.UTF-8"}
        for name, text in {"CMakeLists.txt": CMAKE, "case.toml": CASE, "compute.py": SCRIPT, "faults.txt": FAULTS,
                           "paper/small.tex": PROSE, "paper/sections/more.tex": MORE, ".gitignore": "/build/\n",
                           "figures/line.gp": 'plot points using "a":"b" with lines notitle\n'}.items():
            self.write(name, text)

    def write(self, name: str, text: str) -> None:
        """Writes a file of the paper."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def replace(self, name: str, before: str, after: str) -> None:
        """Edits a file of the paper."""
        text = (self.folder / name).read_text()
        assert before in text, f"{name} has no {before}"
        self.write(name, text.replace(before, after))

    def run(self, *command: str, **options) -> tuple[int, str]:
        """Runs a program in the paper's folder and returns its exit code and output."""
        ran = subprocess.run(command, cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, errors="replace", **options)
        return ran.returncode, ran.stdout

    def literate(self, *arguments: str) -> tuple[int, str]:
        """Runs a verb of `literate`."""
        return self.run(*LITERATE, *arguments)

    def make(self, target: str = "small") -> tuple[int, str]:
        """Configures if needed and builds."""
        if not (self.build / "build.ninja").exists():
            code, output = self.run("cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release")
            if code:
                return code, output
        return self.run("ninja", "-C", str(self.build), target)

    def clean_pdf(self) -> bytes:
        """Returns the PDF of a clean build of a copy."""
        with tempfile.TemporaryDirectory() as folder:
            copy = Paper(Path(folder, "clean"))
            shutil.copytree(self.folder, copy.folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("build"))
            copy.environment = self.environment
            code, output = copy.make()
            assert copy.pdf.exists(), output
            return copy.pdf.read_bytes()

    def text(self) -> str:
        """Returns the words of the PDF."""
        return subprocess.run(["pdftotext", "-layout", str(self.pdf), "-"], capture_output=True, text=True, check=True).stdout

    def commit(self, message: str = "state") -> None:
        """Commits all files."""
        git = ["git", "-c", "user.name=A", "-c", "user.email=a@b.c"]
        if not (self.folder / ".git").exists():
            subprocess.run([*git, "init", "--quiet"], cwd=self.folder, check=True)
        subprocess.run([*git, "add", "-A"], cwd=self.folder, check=True)
        subprocess.run([*git, "commit", "--quiet", "-m", message], cwd=self.folder, check=True)


def rules_in(output: str) -> list[str]:
    """Returns the rules that Ninja ran, without those that run in every build."""
    return [rule for rule in re.findall(r"^\[\d+/\d+\] (.*)$", output, re.MULTILINE)
            if not rule.startswith(("look up", "Re-", "check the claims"))]


class PaperTest(unittest.TestCase):
    """A test with a paper that has not been built."""

    maxDiff = None

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="paper-")
        self.addCleanup(folder.cleanup)
        self.paper = Paper(Path(folder.name).resolve() / "small")

    def make(self, code: int = 0, paper: Paper | None = None) -> str:
        """Builds, requires an exit code, and returns the output."""
        found, output = (paper or self.paper).make()
        self.assertEqual(found, code, output)
        return output
