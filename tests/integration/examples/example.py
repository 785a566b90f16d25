"""Starting the numbered examples as a user would; only the folder of their sockets is the test's own."""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop())
EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"
SCALE = 0.4  # of the teleoperations
PATIENCE = 60  # s; only so that a hang ends the test


def overdue(*unused):
    raise AssertionError(f"nothing has come for so long that the test ends: {PATIENCE} s")


class Example(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # The manager's default address is in this folder.
        self.environment = dict(os.environ, TMPDIR=folder.name, XDG_RUNTIME_DIR=folder.name)
        signal.signal(signal.SIGALRM, overdue)
        signal.alarm(PATIENCE)
        self.addCleanup(signal.alarm, 0)

    def start(self, program, *arguments):
        process = subprocess.Popen([PROGRAMS / program, *arguments], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=self.environment)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def start_manager(self):
        manager = self.start("suture-manager")
        self.await_line(manager.stdout, "ready on")

    def station(self, example, file, *arguments, program=None):
        """Starts the program of an example, or another one, with one of its deployment files. Its manager is the test's own."""
        deployment = json.loads((EXAMPLES / example / file).read_text())
        if "manager" in deployment:
            deployment["manager"] = f"unix:{self.folder}/suture/manager.sock"
        copy = self.folder / file
        copy.write_text(json.dumps(deployment))
        return self.start(program or example, "--deployment", copy, *arguments)

    def await_line(self, stream, pattern):
        """Reads up to the line in which the pattern is found."""
        for line in stream:
            if found := re.search(pattern, line):
                return found
        return self.fail(f"it ended before it wrote a line with: {pattern}")

    def await_motion(self, stream, name):
        """Returns how far a MotionDisplay says that its master and slave have moved, in mm, once either has moved by 30 mm."""
        while True:
            found = self.await_line(stream, rf"^{name}: master moved by +([\d.]+) mm, slave by +([\d.]+) mm$")
            master, slave = float(found[1]), float(found[2])
            if max(master, slave / SCALE) >= 30:
                return master, slave

    def output_of(self, process):
        """Returns what a program prints until it ends by itself, which must be well."""
        output, errors = process.communicate()
        told = r"\w+: (runs|waits for) '.*"  # how a workstation starts
        problems = [line for line in errors.splitlines() if not re.fullmatch(told, line)]
        self.assertEqual((process.returncode, problems), (0, []), output)
        return output

    def refusal_of(self, process):
        """Returns what a program says that ends because something is missing or wrong."""
        output, errors = process.communicate()
        self.assertEqual((process.returncode, output), (1, ""), errors)
        return errors

    def end(self, process):
        """Ends a program as Ctrl-C does, which must be well."""
        process.send_signal(signal.SIGINT)
        self.output_of(process)
