"""A process is cut off while the demo runs: what it drives holds, does not jump, and goes on afterwards.

How soon, to the millisecond, depends here on what else the machine does; the demo itself judges that.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from programs import PATIENCE, Demo, all_end, eventually, interrupt, is_frozen

PROGRAMS = pathlib.Path(sys.argv.pop(1))
TOPOLOGIES = pathlib.Path(__file__).resolve().parents[3] / "examples" / "teleoperation"


class Broken(unittest.TestCase):
    def run_and_break(self, *options, **how):
        with Demo(PROGRAMS, *options, **how) as demo:
            status, output = demo.finish()
            result = demo.result()
            print(output)
            self.assertEqual(result["failures"], [])
            self.assertEqual(status, 0 if result["passed"] else 1, output)
            for slave in result["held"]:
                self.assertLess(slave["held_after"], 0.75, slave)  # of one second
                self.assertIsNotNone(slave["resumed_after"], slave)
                self.assertLess(slave["largest_jump"], 0.01, slave)
            self.assertIn("ran to the end and had every connection again", output)
            return {slave["name"] for slave in result["held"]}


class Vision(Broken):
    def test_the_emergency_stop_of_twenty_processes(self):
        held = self.run_and_break("--topology", "fig3b_tasks", "--network", "unix", "--seconds", "12",
                                  "--break", "coordinator@7s+1200ms", rate=200)
        self.assertEqual(held, {"psm1:PSM1", "psm2:PSM2"})

    def test_cameras(self):
        held = self.run_and_break("--topology", "fig3b", "--seconds", "12", "--break", "vision@7s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})


class RealTime(Broken):
    def test_the_workstation_that_permits_power(self):
        held = self.run_and_break("--topology", "fig3c", "--seconds", "8", "--break", "left@3s", real_time=True)
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})


class Permits(Broken):
    """These cut off what permits power, or what needs it, and nothing that drives a slave of another process."""

    def test_a_frozen_process_that_drives_no_other(self):
        """Its own slave holds, and does not jump when it goes on; the other one follows meanwhile."""
        held = self.run_and_break("--topology", "fig3a", "--network", "tcp", "--seconds", "7", "--break", "right@3s")
        self.assertEqual(held, {"right:PSM1"})

    def test_a_frozen_process_that_permits_power(self):
        held = self.run_and_break("--topology", "fig3a", "--network", "unix", "--seconds", "7", "--break", "left@3s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    @unittest.skipUnless(os.geteuid() == 0, "only root may pull cables between network namespaces")
    def test_a_workstation_without_the_permits_of_the_other(self):
        held = self.run_and_break("--topology", "fig3a", "--network", "namespaces", "--seconds", "7", "--break", "right@3s")
        self.assertEqual(held, {"right:PSM1"})

    def test_a_process_on_which_no_slave_depends(self):
        topology = json.loads((TOPOLOGIES / "fig3a.json").read_text())
        topology["processes"].append({"name": "nobody", "components": [
            {"name": "Registration", "class": "RegistrationTable", "parameters": {}}]})
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "with_nobody.json"
            file.write_text(json.dumps(topology))
            with Demo(PROGRAMS, "--topology", file, "--network", "unix", "--seconds", "6", "--break", "nobody@2s") as demo:
                _, output = demo.finish()
                self.assertEqual(demo.result()["held"], [])
        self.assertIn("no slave depends directly on nobody, so that none had to hold", output)


class Workstations(Broken):
    def test_a_workstation(self):
        held = self.run_and_break("--topology", "fig3c", "--seconds", "8", "--break", "right@3s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    def test_a_workstation_that_is_frozen(self):
        held = self.run_and_break("--topology", "fig3c", "--network", "unix", "--seconds", "8", "--break", "right@3s")
        self.assertEqual(held, {"left:PSM2", "right:PSM1"})

    def finish_after_a_stop(self, demo):
        """Lets the demo have no time until its run would have been over."""
        over = time.monotonic() + 6
        demo.process.send_signal(signal.SIGSTOP)
        self.assertTrue(eventually(lambda: time.monotonic() > over, PATIENCE))
        demo.process.send_signal(signal.SIGCONT)
        status, output = demo.finish()
        self.assertEqual(demo.result()["failures"], [], output)
        self.assertIn("ran to the end and had every connection again", output)

    def test_a_demo_that_gets_no_time_breaks_later(self):
        with Demo(PROGRAMS, "--topology", "fig3a", "--network", "unix", "--seconds", "6", "--break", "right@2s") as demo:
            demo.await_progress()
            self.finish_after_a_stop(demo)

    def test_a_demo_that_gets_no_time_mends_later(self):
        with Demo(PROGRAMS, "--topology", "fig3a", "--network", "unix", "--seconds", "6", "--break", "right@2s") as demo:
            demo.await_progress()
            right = demo.child("right")
            self.assertTrue(eventually(lambda: is_frozen(right), PATIENCE))
            self.finish_after_a_stop(demo)

    def test_what_cannot_be_broken(self):
        for text, why in (("kitchen@1s", "--break kitchen@1s: topology 'fig3c' has processes 'left' and 'right'. Name one of them, or "
                                        "choose by --topology one that has 'kitchen'"),
                          ("right", "--break right: that names no process and moment. Write for example vision@4s"),
                          ("right@1.2.3", "--break right@1.2.3: that names no process and moment"),
                          ("right@.", "--break right@.: that names no process and moment"),
                          ("right@99999999s", "--break right@99999999s: that names no process and moment"),
                          ("right@1s", "--break right@1s: the arms get ready within the first 2 s"),
                          ("right@2s+500ms", "--break right@2s+500ms: that is over before anybody could tell who holds"),
                          ("right@8s", "--break right@8s: the run ends less than 3 s after that is over")):
            with self.subTest(text):
                process = subprocess.run([PROGRAMS / "suture-demo", "--break", text],
                                         capture_output=True, text=True, timeout=60)
                self.assertEqual(process.returncode, 1)
                self.assertIn(why, process.stderr)
                self.assertEqual(process.stdout, "", "it is refused before the run")

    def test_a_process_that_is_alone(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--topology", "single", "--break", "console@1s"],
                                 capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("it is the only process, and talks to no other", process.stderr)

    def test_an_interrupt_meanwhile_blames_no_process(self):
        with Demo(PROGRAMS, "--network", "unix", "--seconds", "60", "--break", "right@3s+30s") as demo:
            demo.await_progress()
            right = demo.child("right")
            self.assertTrue(eventually(lambda: is_frozen(right), PATIENCE))
            children = demo.children()
            interrupt(demo.process)
            status, output = demo.finish()
            self.assertEqual(status, 130, output)
            self.assertNotIn("never moved again", output)
            self.assertTrue(all_end(children), "processes are left")

    def test_a_killed_demo_leaves_no_frozen_process(self):
        with Demo(PROGRAMS, "--network", "unix", "--seconds", "60", "--break", "right@3s+30s") as demo:
            demo.await_progress()
            right = demo.child("right")
            self.assertTrue(eventually(lambda: is_frozen(right), PATIENCE))
            children = demo.children()
            demo.process.kill()
            demo.process.wait()
            self.assertTrue(all_end(children), "processes are left")


unittest.main()
