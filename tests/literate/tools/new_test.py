# SPDX-License-Identifier: GPL-3.0-or-later
"""`literate new` and the Makefile of a new paper, with an installed engine without its C++ library."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from paper import ENGINE, RESULTS


class New(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="new ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()
        self.environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "ENGINE")}

    def installed(self, name: str) -> Path:
        """Installs an engine without its C++ library, which scripts do not need, and returns the prefix."""
        engine = self.folder / name / "share" / "literate"
        shutil.copytree(ENGINE, engine, ignore=shutil.ignore_patterns("*.cpp", "*.hpp", "__pycache__"))
        shutil.copytree(ENGINE / "template", engine / "template", dirs_exist_ok=True)
        (engine / "cmake" / "literateTargets.cmake").touch()
        (self.folder / name / "bin").mkdir()
        shutil.copy(RESULTS, self.folder / name / "bin" / "literate-results")
        (self.folder / name / "bin" / "literate").symlink_to("../share/literate/tools/literate")
        return self.folder / name

    def run_in(self, folder: Path, *command: str | Path, code: int = 0) -> str:
        """Runs a command and returns its output."""
        ran = subprocess.run(command, cwd=folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(ran.returncode, code, ran.stdout)
        return ran.stdout

    def new_paper(self, prefix: Path, *options: str) -> Path:
        """Writes a new paper and returns its folder."""
        self.run_in(self.folder, prefix / "bin" / "literate", "new", *options, "cup")
        return self.folder / "cup"

    def test_all_targets_work_in_a_new_python_paper_without_a_compiler(self):
        prefix = self.installed("engine")
        self.environment |= {"CXX": "/none", "CC": "/none"}
        paper = self.new_paper(prefix, "--python")
        self.assertIn("build/cup/cup.pdf", self.run_in(paper, "make"))
        self.assertEqual(self.run_in(paper, "make"), "build/cup/cup.pdf\n")
        self.run_in(paper, "make", "check")
        self.run_in(paper, "git", "init", "-q")
        self.run_in(paper, "git", "add", "-A")
        self.assertNotIn(".engine", self.run_in(paper, "git", "status", "--porcelain"))
        self.run_in(paper, "git", "-c", "user.name=a", "-c", "user.email=b", "commit", "-qm", "new")
        self.assertIn("cup: the same bytes", self.run_in(paper, "make", "verify"))
        self.assertIn("nothing changed", self.run_in(paper, "make", "changes"))
        self.assertIn("3 faults turn 2 of 2 claims", self.run_in(paper, "make", "severity"))
        self.assertIn("cup.tar.gz", self.run_in(paper, "make", "dist"))
        self.assertIn("cases.csv", self.run_in(paper, "make", "cases", "J=2"))
        (paper / "case.toml").write_text((paper / "case.toml").read_text().replace("angle = 90", "angle = 60"))
        self.assertIn("verdict  claim  longer: holds → fails", self.run_in(paper, "make", "changes"))
        self.assertTrue((paper / "build/cases/swing-60/cup.pdf").exists())
        self.assertLessEqual(len(self.run_in(paper, "make", "help").splitlines()), 20)

    def test_an_error_is_printed_without_the_failed_command(self):
        paper = self.new_paper(self.installed("engine"), "--python")
        prose = paper / "paper" / "cup.tex"
        prose.write_text(prose.read_text().replace(r"\val{period}", r"\val{perod}"))
        output = self.run_in(paper, "make", code=2).splitlines()
        self.assertEqual(output[-2], "paper/cup.tex:19: unknown value 'perod', did you mean 'period'?")
        self.assertNotIn("FAILED", "\n".join(output))

    def test_a_moved_engine_is_found_or_requested(self):
        prefix = self.installed("one")
        paper = self.new_paper(prefix, "--python")
        self.run_in(paper, "make")
        pdf = (paper / "build/cup/cup.pdf").read_bytes()
        two = prefix.rename(self.folder / "two")
        output = self.run_in(paper, "make", code=2)
        self.assertIn(f"there is no engine in '{self.folder}/one/share/literate': run make ENGINE=folder", output)
        self.run_in(paper, "make", f"ENGINE={two}/share/literate")
        self.run_in(paper, "make")  # it is remembered
        three = two.rename(self.folder / "three")
        self.environment["PATH"] = f"{three / 'bin'}:{os.environ['PATH']}"
        self.run_in(paper, "make")  # the command `literate` knows where it is
        self.installed("one")
        self.run_in(paper, "make", f"ENGINE={self.folder}/one/share/literate")
        self.assertIn(f"{self.folder}/one/", (paper / "build/cup.json").read_text())
        moved = paper.rename(self.folder / "moved cup")
        self.run_in(moved, "make")
        self.assertEqual((moved / "build/cup/cup.pdf").read_bytes(), pdf)

    def test_a_second_make_waits_for_the_first(self):
        paper = self.new_paper(self.installed("engine"), "--python")
        makes = [subprocess.Popen(["make"], cwd=paper, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                 for _ in range(2)]
        output = [make.communicate()[0] for make in makes]
        self.assertEqual([make.returncode for make in makes], [0, 0], output)
        self.assertEqual(sorted("typeset cup" in one for one in output), [False, True])
        pdf = (paper / "build/cup/cup.pdf").read_bytes()
        self.run_in(paper, "make", "clean")
        self.run_in(paper, "make")
        self.assertEqual((paper / "build/cup/cup.pdf").read_bytes(), pdf)

    def test_an_existing_folder_and_an_invalid_name_are_refused(self):
        literate = [sys.executable, ENGINE / "tools" / "literate", "new"]
        self.assertIn("the name of a paper consists of letters", self.run_in(self.folder, *literate, "a b", code=2))
        (self.folder / "full").mkdir()
        (self.folder / "full" / "file").touch()
        self.assertIn("this folder exists and is not empty", self.run_in(self.folder, *literate, "full", code=2))


if __name__ == "__main__":
    unittest.main()
