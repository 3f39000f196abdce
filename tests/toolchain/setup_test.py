# SPDX-License-Identifier: GPL-3.0-or-later
"""`make setup` installs the packages of a target or prints one line with the reason. Scripts replace apt and dpkg."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import source_tree

SETUP = source_tree.ROOT / "src/toolchain/setup"


class Setup(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for tool in ("awk", "cut", "dirname", "grep", "head", "id", "mkdir", "tail", "env", "sudo"):
            if path := shutil.which(tool):
                (self.folder / tool).symlink_to(path)
        self.tool("id", "echo 0")

    def tool(self, name: str, script: str) -> None:
        """Replaces a tool by a script."""
        path = self.folder / name
        path.unlink(missing_ok=True)
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)

    def setup(self, *targets: str) -> subprocess.CompletedProcess:
        return subprocess.run(["/bin/sh", SETUP, *targets], cwd=self.folder, env={"PATH": str(self.folder)},
                              capture_output=True, text=True)

    def test_an_unknown_target_is_an_error(self):
        run = self.setup("repot")
        self.assertEqual((run.returncode, run.stderr),
                         (2, "setup: no package list for 'repot'; the targets are those of 'make help'\n"))

    def test_without_apt_it_lists_the_packages(self):
        run = self.setup("report", "bench")
        self.assertEqual(run.returncode, 3)
        self.assertIn('then run "make report bench"', run.stderr)
        self.assertRegex(run.stderr, r"g\+\+ .*\[gcc-c\+\+\]")
        self.assertIn("libbenchmark-dev", run.stderr)
        self.assertNotIn("bubblewrap", run.stderr)

    def test_it_does_nothing_if_no_package_is_missing(self):
        self.tool("apt-get", "exit 1")
        self.tool("dpkg-query", "printf installed")
        self.assertEqual(self.setup("report").returncode, 0)

    def test_it_installs_only_missing_packages(self):
        self.tool("dpkg-query", 'case "$*" in *gnuplot-nox) ;; *) printf installed ;; esac')
        self.tool("apt-get", f'echo "$*" >>{self.folder}/arguments')
        run = self.setup("report")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex((self.folder / "arguments").read_text(), r"(?m)install --yes --no-install-recommends gnuplot-nox$")

    def test_an_error_of_apt_is_one_line(self):
        self.tool("dpkg-query", "")
        self.tool("apt-get", 'echo "E: Could not get lock /var/lib/dpkg/lock-frontend"; exit 100')
        run = self.setup("report")
        self.assertEqual(run.returncode, 3)
        self.assertEqual(run.stderr.count("\n"), 1)
        self.assertIn("apt-get update failed: E: Could not get lock", run.stderr)

    def test_without_root_and_sudo_it_prints_the_command_for_an_administrator(self):
        self.tool("id", "echo 1000")
        (self.folder / "sudo").unlink(missing_ok=True)
        self.tool("dpkg-query", "")
        self.tool("apt-get", "")
        run = self.setup("report")
        self.assertEqual(run.returncode, 3)
        self.assertIn("an administrator can run: apt-get install --no-install-recommends make git", run.stderr)

    def test_every_target_that_builds_has_packages(self):
        targets = set(re.findall(r"(?m)^([a-z-]+):.* ## ", source_tree.text("Makefile"))) - {"setup", "clean", "help"}
        listed = set(" ".join(re.findall(r"(?m)^= [a-z]+: (.*)$", source_tree.text("src/toolchain/packages.txt"))).split())
        self.assertEqual(targets - listed, set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
