"""A slave stops following while the demo runs, because somebody interferes: the demo says so, and since when."""

import json
import pathlib
import subprocess
import sys
import unittest

from programs import PATIENCE, Demo

PROGRAMS = pathlib.Path(sys.argv.pop(1))


class StopsFollowing(unittest.TestCase):
    def run_with(self, command):
        """Returns what the demo says of PSM1, at which `command` is called in the middle of the run."""
        with Demo(PROGRAMS, "--topology", "single", "--network", "unix", "--lane", "shm", "--seconds", "10", rate=200) as demo:
            demo.await_progress(seconds=4)
            file = next(pathlib.Path(demo.folder.name).glob("*/deployment.json"))
            manager = json.loads(file.read_text())["manager"]
            called = subprocess.run([PROGRAMS / "suture", "call", "--manager", manager, *command],
                                    capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(called.returncode, 0, called.stderr)
            status, output = demo.finish()
            print(output)
            self.assertEqual(status, 1, output)
            arms = {arm["name"]: arm for arm in demo.result()["arms"]}
        self.assertLess(arms["console:PSM1"]["followed"], 0.9)
        return output

    def check(self, output):
        self.assertRegex(output, r"FAILED  console:PSM1 follows console:MTMR: .*the slave followed for \d+ % of the time, "
                                 r"at least 90 % required: not from \d+\.\d to \d+\.\d s after it began")

    def test_a_teleoperation_that_is_disabled(self):
        self.check(self.run_with(("console:TeleopR/Teleoperation", "disable")))

    def test_a_slave_that_is_paused(self):
        self.check(self.run_with(("console:PSM1/Arm", "pause")))


unittest.main()
