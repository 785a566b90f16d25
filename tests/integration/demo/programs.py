"""Starts the demo's programs, and looks for what they leave behind."""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

sys.path.append(str(pathlib.Path(__file__).parents[2] / "support"))
from rights import BEFORE_COMPILERS, WITHOUT_REAL_TIME  # the second one also for those who import this

PATIENCE = 150  # s; only so that a hang ends the test
# This is the rate of the demo, Hz. It is low, because some demos run beside each other, and threads that wake up more often would leave no
# time to those that look at images, or to the demo itself, which ends the run: at 1000 Hz one demo over TLS wants most of two processors.
RATE = 500


class Demo:
    """This is a demo under way, with standard output and error together.

    Without `real_time` its user may have no real-time priorities: two demos beside each other would take all time of two
    processors from all other processes, so those that have them take turns (CMakeLists.txt).
"""

    def __init__(self, programs, *arguments, rate=RATE, real_time=False):
        self.folder = tempfile.TemporaryDirectory()
        self.json = pathlib.Path(self.folder.name) / "result.json"
        # The demo has its own temporary folder, so that what it leaves there can be seen.
        environment = dict(os.environ, TMPDIR=self.folder.name)
        self.process = subprocess.Popen(
            [*BEFORE_COMPILERS, *([] if real_time else WITHOUT_REAL_TIME), programs / "suture-demo", "--json", self.json,
             "--rate", str(rate), *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        self.folder.cleanup()

    def finish(self):
        """Returns exit status and output."""
        output, _ = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, output

    def await_progress(self, seconds=0):
        """Reads up to the first line of progress after that time: everything is connected and runs."""
        lines = []
        for line in self.process.stdout:
            ran = re.match(r" *(\d+\.\d) s ", line)
            if ran and float(ran[1]) >= seconds:
                return
            lines.append(line)
        raise AssertionError("the demo ended before its first line of progress:\n" + "".join(lines))

    def result(self):
        return json.loads(self.json.read_text())

    def child(self, name):
        """Returns the process id of the workstation `name`, or of the program `name`."""
        for pid, arguments in children_of(self.process.pid):
            if name in arguments or pathlib.Path(arguments[0]).name == name:
                return pid
        raise AssertionError(f"no process {name}")

    def children(self):
        return [pid for pid, _ in children_of(self.process.pid)]

    def leftovers(self):
        """Returns what is in the temporary folder beside the result."""
        return [path.name for path in pathlib.Path(self.folder.name).iterdir() if path != self.json]


def children_of(parent):
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            status = (entry / "stat").read_text().rsplit(")", 1)[1].split()
            arguments = (entry / "cmdline").read_bytes().decode().split("\0")
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(status[1]) == parent:
            yield int(entry.name), arguments


def eventually(condition, patience=10):
    """Returns true once the condition holds. It is for what another process does and no one announces."""
    deadline = time.monotonic() + patience
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.02)
    return True


def all_end(pids):
    """Returns true once none of the processes exists."""
    return eventually(lambda: not any(pathlib.Path(f"/proc/{pid}").exists() for pid in pids))


def is_frozen(pid):
    status = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1]
    return status.split()[0] == "T"


def interrupt(process):
    process.send_signal(signal.SIGINT)
