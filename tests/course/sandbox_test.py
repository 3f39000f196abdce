# SPDX-License-Identifier: GPL-3.0-or-later
"""What a job sees and which limits it has, in each sandbox that works here. attacks.cpp contains submissions that attack."""
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import toy_course
from toy_course import TOY, bubblewrap_problem, skip

import assignment
from errors import ToolFailure
from sandbox import SANDBOXES, Bubblewrap

LIMITS = assignment.read(TOY / "assignment.toml").limits
WORKING = [name for name, works in (("bubblewrap", not bubblewrap_problem()), ("user", os.geteuid() == 0)) if works]


class Jobs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="course test ")
        self.addCleanup(scratch.cleanup)
        os.chmod(scratch.name, 0o755)
        self.folder = Path(scratch.name)
        for name in ("kit", "work"):
            (self.folder / name).mkdir()
        (self.folder / "work").chmod(0o777)
        (self.folder / "kit/given").write_text("given")

    def run_in(self, name, script, seconds=5, clock=60):
        return SANDBOXES[name](self.folder / "kit", LIMITS).run(["sh", "-c", script], self.folder / "work", seconds, clock)

    def test_a_job_writes_only_to_its_folder_and_reads_the_kit(self):
        for name in WORKING:
            with self.subTest(name):
                kit = SANDBOXES[name](self.folder / "kit", LIMITS).kit
                status, text = self.run_in(name, f"cat '{kit}/given'; echo x > '{kit}/given' || echo x > made; exit 7")
                self.assertEqual((status, text[:5]), (7, "given"))
                self.assertEqual((self.folder / "kit/given").read_text(), "given")
                (self.folder / "work/made").unlink()

    def test_a_job_runs_as_a_different_user_with_an_empty_environment(self):
        os.environ["SECRET"] = "in the environment"
        for name in WORKING:
            with self.subTest(name):
                _, text = self.run_in(name, "env; id -u")
                self.assertNotIn("in the environment", text)
                self.assertNotEqual(text.split()[-1], "0")

    def test_bubblewrap_hides_other_files_processes_and_the_network(self):
        if "bubblewrap" not in WORKING:
            self.skipTest(bubblewrap_problem())
        _, text = self.run_in("bubblewrap", "ls -A / /dev /tmp; ls /proc /sys /etc 2> /dev/null; cat < /dev/tcp/127.0.0.1/1; kill -0 -1 || echo alone")
        self.assertEqual(text.split("sh: ")[0].split(), ["/:", *"bin dev kit lib lib64 tmp usr work".split(), "/dev:", "null", "/tmp:"])
        self.assertIn("alone", text)

    def test_processor_time_and_wall_clock_time_are_limited(self):
        for name in WORKING:
            with self.subTest(name):
                self.assertIn(self.run_in(name, "while :; do :; done", seconds=1)[0], (-24, 152))
                with self.assertRaisesRegex(ToolFailure, "a job did not end within 1 s"):
                    self.run_in(name, "sleep 1000 & sleep 1000", clock=1)

    def test_memory_processes_and_files_are_limited(self):
        for name in WORKING:
            with self.subTest(name):
                _, text = self.run_in(name, "ulimit -v; ulimit -p; ulimit -f")
                self.assertEqual([int(word) for word in text.split()], [512 << 10, 16, 64 << 11])

    def test_a_sandbox_that_does_not_work_names_a_remedy(self):
        with mock.patch.dict(os.environ, PATH="/nowhere"), self.assertRaisesRegex(ToolFailure, "bubblewrap is not installed"):
            Bubblewrap(self.folder, LIMITS)
        (self.folder / "bwrap").write_text("#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n")
        (self.folder / "bwrap").chmod(0o755)
        with mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"):
            sandbox = Bubblewrap(self.folder / "kit", LIMITS)
            with self.assertRaisesRegex(ToolFailure, "not work here \\(bwrap: No permissions to create new namespace\\).*podman run"):
                sandbox.require()


if __name__ == "__main__":
    if not WORKING:
        skip(f"no sandbox works here: {bubblewrap_problem()}")
    toy_course.main()
