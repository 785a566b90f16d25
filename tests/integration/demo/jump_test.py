"""A slave of the demo jumps for a moment, by what its recorder wrote: the demo names it, and fails, in a topology of each kind."""

import json
import pathlib
import sys
import unittest

from programs import Demo, eventually

PROGRAMS = pathlib.Path(sys.argv.pop(1))
JUMP = 0.02  # m


class Jump(unittest.TestCase):
    def verdict_with_a_jump(self, topology, slave):
        """Returns what the demo says if one row of the slave's recording has another set-point and place than the rows around it."""
        with Demo(PROGRAMS, "--topology", topology, "--network", "unix", "--lane", "shm", "--seconds", "4", rate=200) as demo:
            demo.await_progress(seconds=2)
            recorder = next(pathlib.Path(demo.folder.name).glob(f"*/{slave}.jsonl"))
            self.assertTrue(eventually(lambda: self.last_row(recorder)), "the slave was never enabled")
            row = self.last_row(recorder)
            for pose in ("setpoint", "measured"):
                row[pose][1] += JUMP
            with recorder.open("a") as file:  # a line goes into it whole, as those of the recorder do
                file.write(json.dumps(row) + "\n")
            status, output = demo.finish()
            print(output)
            self.assertEqual(status, 1, output)
            arms = {arm["name"].split(":")[1]: arm for arm in demo.result()["arms"]}
        jumped, other = arms[slave], arms["PSM1" if slave == "PSM2" else "PSM2"]
        self.assertGreater(jumped["largest_jump"], 0.003)
        self.assertLess(other["largest_jump"], 0.003)
        return output

    def last_row(self, recorder):
        rows = [json.loads(line) for line in recorder.read_text().split("\n")[:-1] if '"setpoint"' in line]
        return rows[-1] if rows and rows[-1]["enabled"] else None

    def test_a_slave_that_follows_a_master(self):
        self.assertRegex(self.verdict_with_a_jump("single", "PSM1"),
                         r"FAILED  console:PSM1: its set-point jumped by \d+\.\d mm, at most 3.0 mm allowed")

    def test_a_slave_that_is_guided(self):
        self.assertRegex(self.verdict_with_a_jump("fig3b", "PSM2"),
                         r"FAILED  left:PSM2: its set-point jumped by \d+\.\d mm, at most 3.0 mm allowed")


unittest.main()
