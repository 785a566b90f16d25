"""examples/01_counter counts in one process, and across two."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop())
PATIENCE = 60  # s; only so that a hang ends the test


class Counter(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        # Where the manager's default address is.
        self.environment = dict(os.environ, TMPDIR=folder.name, XDG_RUNTIME_DIR=folder.name)

    def start(self, program, *arguments):
        process = subprocess.Popen([PROGRAMS / program, *arguments], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=self.environment)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def counts(self, *arguments):
        """Runs the client to its end and looks at what it has counted."""
        process = self.start("01_counter", *arguments)
        output, errors = process.communicate(timeout=PATIENCE)
        self.assertEqual((process.returncode, errors), (0, ""))
        values = [int(value) for value in re.findall(r"^(\d+), [\d.]+ ms old$", output, re.M)]
        self.assertGreater(len(values), 5, output)
        self.assertEqual(values, sorted(values))
        self.assertGreater(values[-1], values[0])
        self.assertRegex(output, r"(?m)^passed \d+$")

    def test_one_process(self):
        self.counts()

    def test_two_processes(self):
        manager = self.start("suture-manager")
        self.assertIn("ready on", manager.stdout.readline())
        self.start("01_counter", "provider")
        self.counts("client")

    def test_without_a_manager_the_client_says_what_to_start(self):
        process = self.start("01_counter", "client")
        output, errors = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 1)
        self.assertIn("suture-manager", errors)


unittest.main()
