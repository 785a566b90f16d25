"""One of two demos beside each other has real-time priorities, and the other one says why it has none."""

import pathlib
import sys
import unittest

from programs import Demo
from rights import may_be_real_time

PROGRAMS = pathlib.Path(sys.argv.pop(1))
PRIORITY = 80  # of drives, in the topologies
TURN = "at most 250 ms old, for another demo has the real-time priorities of this machine"


@unittest.skipUnless(may_be_real_time(PRIORITY), "this user may have no real-time priorities")
class Turn(unittest.TestCase):
    def test_second_demo_runs_without(self):
        with Demo(PROGRAMS, "--topology", "single", "--seconds", "60", real_time=True) as first:
            first.await_progress()
            with Demo(PROGRAMS, "--topology", "single", "--seconds", "1", real_time=True) as second:
                _, output = second.finish()
                tasks = [task["scheduling"] for process in second.result()["processes"] for task in process["tasks"]]
        self.assertIn(TURN, output)
        self.assertFalse(any("fifo" in one for one in tasks), tasks)


unittest.main()
