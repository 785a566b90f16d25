"""The emergency stop is pressed while the demo runs: both slaves hold, do not jump, and go on once it is released.

How soon, to the millisecond, depends here on what else the machine does; the demo itself judges that.
"""

import pathlib
import subprocess
import sys
import unittest

from programs import Demo

PROGRAMS = pathlib.Path(sys.argv.pop(1))


class Pressed(unittest.TestCase):
    def run_and_stop(self, *options, real_time=False):
        with Demo(PROGRAMS, *options, real_time=real_time) as demo:
            status, output = demo.finish()
            result = demo.result()
            print(output)
            self.assertEqual(result["failures"], [])
            self.assertEqual(status, 0 if result["passed"] else 1, output)
            self.assertEqual(len(result["held"]), 2, output)
            for slave in result["held"]:
                self.assertLess(slave["held_after"], 0.75, slave)  # of one second
                self.assertIsNotNone(slave["resumed_after"], slave)
                self.assertLess(slave["largest_jump"], 0.01, slave)
            self.assertIn("the emergency stop is pressed after 3 s and released 1 s later", output)
            self.assertIn("PSM1, with the stop pressed", output)
            return output


class RealTime(Pressed):
    def test_across_processes(self):
        self.run_and_stop("--topology", "fig3c", "--seconds", "7", "--stop", "3s", real_time=True)


class Stop(Pressed):
    def test_in_one_process_without_real_time_priorities(self):
        output = self.run_and_stop("--topology", "single", "--seconds", "7", "--stop", "3s")
        self.assertIn("at most 250 ms old, for this user may have no real-time priorities", output)
        self.assertNotIn("warning", output)

    def test_impossible_stops_are_refused(self):
        for text, why in (("never", "--stop never: that is no moment. Write for example 6s, or 6s+1500ms"),
                          ("right@1s", "--stop right@1s: that is no moment"),
                          ("1s", "--stop 1s: the arms get ready within the first 2 s"),
                          ("2s+500ms", "--stop 2s+500ms: that is over before anybody could tell who holds"),
                          ("8s", "--stop 8s: the run ends less than 3 s after that is over")):
            with self.subTest(text):
                process = subprocess.run([PROGRAMS / "suture-demo", "--stop", text],
                                         capture_output=True, text=True, timeout=60)
                self.assertEqual(process.returncode, 1)
                self.assertIn(why, process.stderr)
                self.assertEqual(process.stdout, "", "it is refused before the run")

    def test_a_stop_and_a_break_are_judged_one_at_a_time(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--stop", "2s", "--break", "right@2s"],
                                 capture_output=True, text=True, timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("--break excludes --stop", process.stderr)


unittest.main()
