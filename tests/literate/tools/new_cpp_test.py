# SPDX-License-Identifier: GPL-3.0-or-later
"""A new paper in C++ builds at once, from a checkout and from an installation. LITERATE_BUILD is the engine's build folder."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from paper import ENGINE


class NewInCpp(unittest.TestCase):
    def run_in(self, folder: Path, *command: str | Path) -> str:
        """Runs a command that must succeed and returns its output."""
        ran = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(ran.returncode, 0, ran.stdout)
        return ran.stdout

    def test_from_an_installation_and_from_a_checkout(self):
        with tempfile.TemporaryDirectory(prefix="new-") as name:
            folder = Path(name).resolve()
            self.run_in(folder, "cmake", "--install", os.environ["LITERATE_BUILD"] + "/src/literate", "--prefix", folder / "prefix")
            for literate in (folder / "prefix" / "bin" / "literate", ENGINE / "tools" / "literate"):
                with self.subTest(literate):
                    self.run_in(folder, literate, "new", "cup")
                    paper = folder / "cup"
                    self.assertIn("build/cup/cup.pdf", self.run_in(paper, "make"))
                    self.assertEqual(self.run_in(paper, "make"), "build/cup/cup.pdf\n")
                    self.run_in(paper, "make", "check")
                    self.run_in(paper, "git", "init", "-q")
                    self.run_in(paper, "git", "add", "-A")
                    self.run_in(paper, "git", "-c", "user.name=a", "-c", "user.email=b", "commit", "-qm", "new")
                    self.assertIn("cup: the same bytes", self.run_in(paper, "make", "verify"))
                    self.assertIn("3 faults turn 2 of 2 claims", self.run_in(paper, "make", "severity"))
                    shutil.rmtree(paper)


if __name__ == "__main__":
    unittest.main()
