# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a student's code, and the compiler that compiles it, in a sandbox.

Bubblewrap: a job sees /usr, the read-only kit and its own folder, but no other files, no other processes and no network. All
its processes end with it. User: for a container that contains one submission. A job runs as a user without privileges, who
cannot read files that are private to root. Both limit the processor time, memory and file size of each process and the number
of processes. Neither limits the total over all processes of a job.
"""
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from itertools import count
from pathlib import Path

from assignment import Limits
from errors import ToolFailure

# systemd reserves these user ids for services without a permanent user, so they own no files and nobody logs in with them.
FIRST_USER, USERS = 61184, 4000
MAX_FILE_MB = 64  # of an object or a program
MAX_TEXT = 100_000  # bytes of a job's output that are read


class Sandbox:
    """Runs jobs, each in its own folder. Jobs find the kit at `self.kit`."""

    users = count(16 * os.getpid())
    clock: int
    hint: str

    def __init__(self, kit: Path, limits: Limits) -> None:
        self.outside_kit = str(kit)
        self.kit = self.outside_kit
        self.limits = limits
        self.user: int  # of the latest job

    def command(self, words: list[str], work: str | Path, seconds: int, writable: bool = False) -> list[str]:
        """Returns the command that runs `words` in the folder `work`, with this limit of processor time for each process."""
        raise NotImplementedError

    def clean(self) -> None:
        """Kills processes that the latest job has left behind."""

    def limited(self, words: list[str], seconds: int) -> list[str]:
        return ["prlimit", f"--cpu={seconds}:{seconds + 1}", f"--as={self.limits.memory_mb << 20}",
                f"--nproc={self.limits.processes}", f"--fsize={MAX_FILE_MB << 20}", "--core=0", "--nofile=256", "--", *words]

    def as_nobody(self, words: list[str]) -> list[str]:
        """Runs `words` as a user of no other job. The kernel counts processes per user, and does not limit those of root."""
        self.user = FIRST_USER + next(Sandbox.users) % USERS
        return without_privileges(self.user, words)

    def run(self, words: list[str], work: str | Path, seconds: int, clock: float) -> tuple[int, str]:
        """Runs a job that may write to its folder. Returns its exit code, or minus its signal, and the beginning of its output."""
        begin = time.monotonic()
        with tempfile.TemporaryFile() as output:
            process = subprocess.Popen(self.command(words, work, seconds, writable=True), stdin=subprocess.DEVNULL, stdout=output,
                                       stderr=output, cwd=work, start_new_session=True)
            # process.wait(timeout=…) would poll only every 50 ms.
            timer = threading.Timer(clock, os.killpg, (process.pid, signal.SIGKILL))
            timer.start()
            process.wait()
            timer.cancel()
            self.clean()
            output.seek(0)
            text = output.read(MAX_TEXT).decode(errors="replace")
        if time.monotonic() - begin >= clock:
            raise ToolFailure(f"a job did not end within {clock} s; is the machine too busy?")
        return process.returncode, text

    def require(self) -> None:
        """Raises ToolFailure unless the sandbox works on this machine."""
        with tempfile.TemporaryDirectory(prefix="course-") as work:
            os.chmod(work, 0o755)
            status, text = self.run(["true"], work, seconds=10, clock=self.clock)
        if status != 0:
            reason = (text.strip().splitlines() or ["it did not start"])[0]
            raise ToolFailure(f"the sandbox does not work here ({reason}). {self.hint}")


def without_privileges(user: int, words: list[str]) -> list[str]:
    return ["setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups", "--no-new-privs", "--bounding-set=-all",
            "--inh-caps=-all", "--", *words]


class Bubblewrap(Sandbox):
    clock = 300  # seconds; the limit of processor time ends a job long before, since it has nothing to wait for
    hint = ("Grade in a container: podman build -t course --build-arg TARGETS=course . && podman run --rm --network none "
            "-v \"$PWD:/halfspace\" course make course DO=grade SUBMISSIONS=folder SANDBOX=user")

    def __init__(self, kit: Path, limits: Limits) -> None:
        super().__init__(kit, limits)
        self.kit = "/kit"
        if not shutil.which("bwrap"):
            raise ToolFailure("bubblewrap is not installed; run \"make setup course\"")

    def command(self, words: list[str], work: str | Path, seconds: int, writable: bool = False) -> list[str]:
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
    hint = "This sandbox is for root in a container that contains nothing else."

    def command(self, words: list[str], work: str | Path, seconds: int, writable: bool = False) -> list[str]:
        inner = ["env", "-i", f"--chdir={work}", "PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", *self.limited(words, seconds)]
        return self.as_nobody(inner)

    def clean(self) -> None:
        subprocess.run(without_privileges(self.user, ["sh", "-c", "kill -KILL -1"]), stderr=subprocess.DEVNULL, check=False)


SANDBOXES: dict[str, type[Sandbox]] = {"bubblewrap": Bubblewrap, "user": User}
