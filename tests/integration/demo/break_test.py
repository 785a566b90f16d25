"""A process is cut off while the demo runs: what it drives holds, does not jump, and goes on afterwards.

How soon, to the millisecond, depends here on what else the machine does; the demo itself judges that.
"""

import pathlib
import subprocess
import sys
import unittest

from programs import Demo

PROGRAMS = pathlib.Path(sys.argv.pop(1))


class Break(unittest.TestCase):
    def run_and_break(self, length, *options):
        with Demo(PROGRAMS, *options) as demo:
            status, output = demo.finish()
            result = demo.result()
            print(output)
            self.assertEqual(result["failures"], [])
            self.assertEqual(status, 0 if result["passed"] else 1, output)
            for slave in result["held"]:
                self.assertLess(slave["held_after"], length, slave)
                self.assertGreaterEqual(slave["resumed_after"], 0, slave)
                self.assertLess(slave["largest_step"], 0.01, slave)
            self.assertIn("ran to the end and had every connection again", output)
            return {slave["name"] for slave in result["held"]}

    def test_a_workstation(self):
        held = self.run_and_break(1, "--topology", "fig3c", "--seconds", "6", "--break", "right@1s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    def test_a_workstation_that_is_frozen(self):
        held = self.run_and_break(1, "--topology", "fig3c", "--network", "unix", "--seconds", "6", "--break", "right@1s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    def test_cameras(self):
        held = self.run_and_break(0.8, "--topology", "fig3b", "--seconds", "12", "--break", "vision@7s+800ms")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    def test_one_that_drives_nobody_elsewhere(self):
        held = self.run_and_break(1, "--topology", "fig3a", "--network", "tcp", "--seconds", "5", "--break", "right@1s")
        self.assertEqual(held, set())

    def test_what_cannot_be_broken(self):
        for text, why in (("kitchen@1s", "no process 'kitchen' here; there are 'left' and 'right'"),
                          ("right", "--break right: that names no process and moment. Write for example vision@4s"),
                          ("right@8s", "--break right@8s: the run ends less than 3 s after that is mended")):
            with self.subTest(text):
                process = subprocess.run([PROGRAMS / "suture-demo", "--break", text],
                                         capture_output=True, text=True, timeout=60)
                self.assertEqual(process.returncode, 1)
                self.assertIn(why, process.stderr)
                self.assertEqual(process.stdout, "", "it is refused before the run")


unittest.main()
