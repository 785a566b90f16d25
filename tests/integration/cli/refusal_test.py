"""A robot that executes a command and refuses what it asks for says so by an event, which `suture call` tells.

Arguments: those of system.py, and the program suture-workstation.
"""

import json
import pathlib
import sys
import time
import unittest

WORKSTATION = sys.argv.pop(5)

from system import PATIENCE, System  # it takes the arguments before

ARM = "arm:PSM/Arm"


class Refusal(System):
    def setUp(self):
        super().setUp()
        self.start_manager()
        file = pathlib.Path(self.address.removeprefix("unix:")).parent / "d.json"
        file.write_text(json.dumps({
            "manager": self.address,
            "processes": [{"name": "arm", "components": [{"name": "PSM", "class": "Psm"},
                                                         {"name": "PSMDrives", "class": "PsmDrives", "parameters": {"permit": 0}}]}],
            "connections": [{"from": "arm:PSM/Drives", "to": "arm:PSMDrives/Drives"}]}))
        self.start(WORKSTATION, "--deployment", file, "--report-fd", "-", "--report-form", "text", first="started")
        deadline = time.monotonic() + PATIENCE
        while self.told("read", ARM, "operating_state")["value"]["state"] != "Disabled":  # it has not heard of its drives yet
            self.assertLess(time.monotonic(), deadline)

    def refusal(self, command):
        """Returns what the arm says, to people and to programs, when it is told to do that. It says so each time."""
        done = self.run_suture("call", ARM, command)
        self.assertEqual((done.returncode, done.stdout), (1, "done\n"), done.stderr)
        title = f"suture: call {command} of {ARM}: it was executed, and the component said meanwhile: "
        self.assertTrue(done.stderr.startswith(title), done.stderr)
        asked = self.run_suture("call", ARM, command, "--json")
        told = json.loads(asked.stdout)
        self.assertEqual((asked.returncode, asked.stderr, told["command"]), (1, "", command))
        (complaint,) = told["complaints"]
        said = done.stderr.removeprefix(title)
        self.assertEqual(said, f"{complaint['event']}: {complaint['text']}\n")
        return said

    def test_a_refused_command_is_told(self):
        self.assertRegex(self.refusal("resume"), "^error: .")

    def test_a_warning_is_told_and_not_told_again_of_another_command(self):
        """The arm tells of a refused motion once, until it obeys again."""
        done = self.run_suture("call", ARM, "home")
        self.assertEqual((done.returncode, done.stdout), (0, "done\n"))
        self.assertTrue(done.stderr.endswith(" meanwhile: warning: motion needs an enabled arm\n"), done.stderr)
        self.assertEqual(self.said("call", ARM, "enable"), "done\n")


unittest.main()
