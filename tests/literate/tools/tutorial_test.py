# SPDX-License-Identifier: GPL-3.0-or-later
"""TUTORIAL.md works as printed: the test writes its files, runs its commands and compares their output, in order. So does
the manual's paper with a fit.

A line with a file name in bold precedes the block of code with the content of the file. If the line begins with «Add to», the
block goes above the comment in the file that marks the spot. A block `console` has commands with their output. LITERATE_BUILD is
the engine's build folder.
"""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from paper import ENGINE

BLOCK = re.compile(r"^([^\n]*)\n```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COMMENT = re.compile(r"^.*Table, figure and claim come here\.\n", re.MULTILINE)
PROGRESS = re.compile(r"\[\d+/\d+\] |make: \*\*\* ")  # progress of Ninja; the last line of make


class Reader:
    """Follows the tutorial in a folder."""

    def __init__(self, folder: Path, test: unittest.TestCase) -> None:
        self.home = self.folder = folder
        self.test = test

    def follow(self, text: str) -> None:
        """Writes the files and runs the commands of a part of the tutorial."""
        for line, language, content in BLOCK.findall(text):
            if language == "console":
                self.run_all(content)
            elif name := re.search(r"\*\*(.+?)\*\*", line):
                self.write(self.folder / name[1], content, line.startswith("Add to "))

    def write(self, path: Path, content: str, is_added: bool) -> None:
        """Writes a file, or adds to one."""
        if is_added:
            text = path.read_text()
            self.test.assertEqual(len(COMMENT.findall(text)), 1, path)
            content = COMMENT.sub(lambda comment: content + comment[0], text)
        path.parent.mkdir(exist_ok=True)
        path.write_text(content)

    def run_all(self, content: str) -> None:
        """Runs commands and compares their output."""
        for part in re.split(r"^\$ ", content, flags=re.MULTILINE)[1:]:
            command, _, expected = part.partition("\n")
            if command.startswith("cd "):
                self.folder /= command[3:]
                continue
            ran = subprocess.run(["bash", "-c", command], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            lines = [line for line in ran.stdout.replace(str(self.home), "/home/you").splitlines(True) if not PROGRESS.match(line)]
            self.test.assertEqual("".join(lines), expected, command)


class Tutorial(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls) -> None:
        temporary = tempfile.TemporaryDirectory(prefix="tutorial-")
        cls.addClassCleanup(temporary.cleanup)
        cls.base = Path(temporary.name).resolve()
        subprocess.run(["cmake", "--install", os.environ["LITERATE_BUILD"] + "/src/literate", "--prefix", cls.base / "prefix"],
                       check=True, capture_output=True)
        os.environ["PATH"] = f"{cls.base / 'prefix' / 'bin'}:{os.environ['PATH']}"
        os.environ |= {f"GIT_{who}_{what}": "reader@example.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}

    def reader(self, home: str, *new: str) -> Reader:
        """Returns a reader, who starts with an empty folder or, given arguments of `literate new`, with a new paper."""
        (self.base / home).mkdir()
        reader = Reader(self.base / home, self)
        if new:
            reader.run_all(f"$ literate new {' '.join(new)}\n{new[-1]}: cd there and run make; README.md describes the files\n"
                           f"$ cd {new[-1]}\n$ rm -r src/* cases faults.txt figures/period.gp\n")
        return reader

    def test_the_tutorial_prints_what_it_shows(self):
        self.reader("tutorial").follow((ENGINE / "TUTORIAL.md").read_text())

    def test_the_paper_with_a_fit_is_built(self):
        reader = self.reader("fit", "--python", "spring")
        reader.follow(section("A paper with a fit"))
        results = json.loads((reader.folder / "build/spring/generated/results.json").read_text())
        self.assertEqual({name: claim["verdict"] for name, claim in results["claims"].items()}, dict.fromkeys(("catalogue", "straight", "unstretched"), "holds"))


def section(heading: str) -> str:
    """Returns a section of the manual."""
    return re.search(rf"^## {heading}\n(.*?)^## ", (ENGINE / "README.md").read_text(), re.MULTILINE | re.DOTALL)[1]


if __name__ == "__main__":
    unittest.main()
