# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a student's code, and the compiler on it, apart from everything else.

Bubblewrap: a job sees /usr, a read-only kit and its own folder; no other file, no other process, no network; nothing
survives it. User: for a container that holds one submission; a job runs as a user without rights, who can read nothing that
is closed to others. Both limit processor time, memory and file sizes of each process and the number of processes. Neither
limits the sum over the processes of a job.
"""
import os
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass
from itertools import count

from errors import ToolFailure

# systemd sets these users aside for services that have none of their own, so that they own nothing and nobody logs in as one.
FIRST_USER, USERS = 61184, 4000
MAX_FILE_MB = 64  # of an object or a program
MAX_TEXT = 100_000  # bytes that are read of what a job prints


@dataclass(frozen=True)
class Ended:
    status: int  # exit code, or minus the signal
    text: str  # the beginning of what it printed
    seconds: float  # by the clock
    is_hung: bool  # it was ended by the clock


class Sandbox:
    """Runs jobs in a folder of theirs. They find the kit as `self.kit`."""

    users = count(16 * os.getpid())

    def __init__(self, kit, limits):
        self.outside_kit = str(kit)
        self.kit = self.outside_kit
        self.limits = limits
        self.user = None  # of the latest job

    def command(self, words, work, seconds, writable=False):
        """The command that runs `words` in the folder `work`, with this much processor time for each process."""
        raise NotImplementedError

    def clean(self):
        """Ends what the latest job left."""

    def limited(self, words, seconds):
        return ["prlimit", f"--cpu={seconds}:{seconds + 1}", f"--as={self.limits.memory_mb << 20}",
                f"--nproc={self.limits.processes}", f"--fsize={MAX_FILE_MB << 20}", "--core=0", "--nofile=256", "--", *words]

    def as_nobody(self, words):
        """As a user whom no other job has, since the kernel counts processes by user, and root's not at all."""
        self.user = FIRST_USER + next(Sandbox.users) % USERS
        return without_rights(self.user, words)

    def run(self, words, work, seconds, clock):
        """Runs a job that may write to its folder, to its end or until `clock` seconds have passed."""
        begin = time.monotonic()
        is_hung = False
        with tempfile.TemporaryFile() as output:
            with subprocess.Popen(self.command(words, work, seconds, writable=True), stdin=subprocess.DEVNULL, stdout=output,
                                  stderr=output, cwd=work, start_new_session=True) as process:
                try:
                    process.wait(clock)
                except subprocess.TimeoutExpired:
                    is_hung = True
                finally:
                    if process.poll() is None:
                        os.killpg(process.pid, signal.SIGKILL)
            self.clean()
            output.seek(0)
            text = output.read(MAX_TEXT).decode(errors="replace")
        return Ended(process.returncode, text, time.monotonic() - begin, is_hung)

    def require(self):
        """Raises ToolFailure unless a job can run here."""
        with tempfile.TemporaryDirectory(prefix="course-") as work:
            os.chmod(work, 0o755)
            ended = self.run(["true"], work, seconds=10, clock=self.clock)
        if ended.status != 0:
            reason = (ended.text.strip().splitlines() or ["it did not start"])[0]
            raise ToolFailure(f"the sandbox does not work here ({reason}). {self.hint}")


def without_rights(user, words):
    return ["setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups", "--no-new-privs", "--bounding-set=-all",
            "--inh-caps=-all", "--", *words]


class Bubblewrap(Sandbox):
    clock = 300  # seconds for a job that processor time limits already: in here it can wait for nothing
    hint = ("Grade in a container: podman build -t course --build-arg TARGETS=course . && podman run --rm --network none "
            "-v \"$PWD:/halfspace\" course make course DO=grade SUBMISSIONS=folder SANDBOX=user")

    def __init__(self, kit, limits):
        super().__init__(kit, limits)
        self.kit = "/kit"
        if not shutil.which("bwrap"):
            raise ToolFailure("bubblewrap is not installed; run \"make setup course\"")

    def command(self, words, work, seconds, writable=False):
        inner, unshared = self.limited(words, seconds), ["--unshare-user"]
        if os.geteuid() == 0:
            inner, unshared = self.as_nobody(inner), []
        return ["bwrap", *unshared, "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try",
                "--die-with-parent", "--new-session", "--clearenv", "--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C.UTF-8",
                "--ro-bind", "/usr", "/usr", "--symlink", "usr/bin", "/bin", "--symlink", "usr/lib", "/lib",
                "--symlink", "usr/lib64", "/lib64", "--perms", "0755", "--dir", "/dev", "--dev-bind", "/dev/null", "/dev/null",
                "--perms", "1777", "--size", str(MAX_FILE_MB << 20), "--tmpfs", "/tmp", "--ro-bind", self.outside_kit, self.kit,
                "--bind" if writable else "--ro-bind", str(work), "/work", "--chdir", "/work", "--", *inner]


class User(Sandbox):
    clock = 60
    hint = "This sandbox is for root in a container that holds nothing else."

    def command(self, words, work, seconds, writable=False):
        inner = ["env", "-i", f"--chdir={work}", "PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", *self.limited(words, seconds)]
        return self.as_nobody(inner)

    def clean(self):
        subprocess.run(without_rights(self.user, ["sh", "-c", "kill -KILL -1"]), stderr=subprocess.DEVNULL, check=False)


SANDBOXES = {"bubblewrap": Bubblewrap, "user": User}
