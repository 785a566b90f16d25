"""What tests of workstations share: a folder with a deployment, and processes that end with the test."""

import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PROGRAM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)
MANAGER = pathlib.Path(PROGRAM).parent / "suture-manager"


def component(name, class_name, **parameters):
    return {"name": name, "class": class_name, "library": LIBRARY, "parameters": parameters}


class Stations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *command, **settings):
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **settings)

        def end():
            process.kill()
            process.communicate()

        self.addCleanup(end)
        return process

    def manager(self, address):
        """Returns once it listens there."""
        manager = self.start(MANAGER, "--listen", address)
        self.assertIn("ready on", manager.stdout.readline())
        return manager

    def workstation(self, deployment, *arguments, **settings):
        file = self.folder / "d.json"
        file.write_text(json.dumps(deployment))
        return self.start(PROGRAM, "--deployment", file, *arguments, **settings)

    def await_true(self, condition):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def await_line(self, station, end):
        hangs = threading.Timer(60, station.kill)
        hangs.start()
        try:
            if not any(line.endswith(end) for line in station.stderr):
                self.fail(f"it ended before it said {end}, or hung")
        finally:
            hangs.cancel()
