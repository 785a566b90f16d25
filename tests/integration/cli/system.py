"""Runs a system, and `suture` beside it. Arguments of a test: the programs suture, suture-manager, cli_robot, cli_stranger."""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SUTURE, MANAGER, ROBOT, STRANGER = sys.argv[1:5]
del sys.argv[1:5]
PATIENCE = 60  # s; only so that a hang ends the test


def state_of(thread):
    return (thread / "stat").read_text().rpartition(")")[2].split()[0]


class System(unittest.TestCase):
    def setUp(self):
        self.maxDiff = None
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.address = f"unix:{folder.name}/manager.sock"

    def start(self, *command, ending=signal.SIGTERM, first="ready", **settings):
        """Starts a process that says `first` when it is ready; when the test ends, processes are ended, the latest first."""
        process = subprocess.Popen(command, text=True, stdout=subprocess.PIPE, **settings)
        self.addCleanup(self.end, process, ending)
        self.heard = process.stdout.readline()
        self.assertIn(first, self.heard)
        return process

    def start_and_hear(self, *command):
        """Does the same, and returns what it said."""
        self.start(*command)
        return self.heard

    def end(self, process, ending):
        process.send_signal(ending)
        process.communicate(timeout=PATIENCE)
        self.assertIn(process.returncode, (0, -ending))

    def stop(self, process):
        """Stops it, as a debugger does; on a busy machine its threads come to know it one by one."""
        process.send_signal(signal.SIGSTOP)
        deadline = time.monotonic() + PATIENCE
        while not all(state_of(thread) == "T" for thread in pathlib.Path(f"/proc/{process.pid}/task").iterdir()):
            self.assertLess(time.monotonic(), deadline, "it does not stop")
            time.sleep(0.001)

    def start_manager(self):
        return self.start(MANAGER, "--listen", self.address)

    def start_robot(self, name="robot"):
        return self.start(ROBOT, self.address, name)

    def start_robot_ahead(self, seconds, name="robot"):
        """Does the same, with another steady clock. Only root may."""
        return self.start("/usr/bin/unshare", "--time", "--monotonic", str(seconds), "--fork", "--kill-child",
                          ROBOT, self.address, name, ending=signal.SIGKILL)  # unshare hears nothing else

    def start_stranger(self, how):
        return self.start(STRANGER, self.address, how, how)

    def run_suture(self, *words):
        verb, *rest = words
        return self.run_without_manager(verb, "--manager", self.address, *rest)

    def run_without_manager(self, *words):
        done = subprocess.run([SUTURE, *words], capture_output=True, text=True, timeout=PATIENCE)
        self.assertIn(done.returncode, (0, 1, 2), done)  # no crash
        return done

    def told_without_manager(self, *words):
        done = self.run_without_manager(*words, "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return json.loads(done.stdout)

    def said(self, *words):
        """Returns what it prints; at the end all must be well."""
        done = self.run_suture(*words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return done.stdout

    def told(self, *words):
        """Does the same for programs."""
        return json.loads(self.said(*words, "--json"))

    def await_silence(self, name):
        """Waits until the manager has missed that process."""
        deadline = time.monotonic() + PATIENCE
        while not any(one["name"] == name and one["silent"] for one in self.told("ps")):
            self.assertLess(time.monotonic(), deadline, "it is not missed")
            time.sleep(0.01)

    def refused(self, *words, status=1):
        """Returns what it says, to people and to programs, when it cannot do as asked."""
        done = self.run_suture(*words)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done.stderr)
        asked = self.run_suture(*words, "--json")
        self.assertEqual((asked.returncode, asked.stderr), (status, ""), asked.stdout)
        error = json.loads(asked.stdout)["error"]
        said, _, more = done.stderr.rstrip("\n").partition("\nsuture: `suture why ")
        self.assertEqual(said, "suture: " + error)
        self.assertTrue(more.endswith("` tells more") or not more, more)
        return error
