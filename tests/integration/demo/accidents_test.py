"""These kill processes of a running demo, and interrupt it."""

import json
import os
import pathlib
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import unittest.mock

from programs import WITHOUT_REAL_TIME, Demo, all_end, interrupt

PROGRAMS = pathlib.Path(sys.argv.pop(1))
SECONDS = 10  # the longest that a death may go unanswered
TOPOLOGIES = pathlib.Path(__file__).resolve().parents[3] / "examples" / "teleoperation"


class Killed(unittest.TestCase):
    def kill(self, name, blamed):
        with Demo(PROGRAMS, "--seconds", "60") as demo:
            demo.await_progress()
            children = demo.children()
            self.assertEqual(len(children), 3)
            killed = time.monotonic()
            os.kill(demo.child(name), signal.SIGKILL)
            status, output = demo.finish()
            took = time.monotonic() - killed
            self.assertEqual(status, 1, output)
            self.assertIn(f"{blamed} was killed by signal 9 (Killed)", output)
            self.assertLess(took, SECONDS)
            self.assertTrue(all_end(children), "processes are left")
            self.assertEqual(demo.leftovers(), [])
            return output

    def test_left_workstation(self):
        output = self.kill("left", "process 'left'")
        self.assertIn("connection 'right:TeleopR/Slave -> left:PSM2/Arm' is lost", output)

    def test_right_workstation(self):
        output = self.kill("right", "process 'right'")
        self.assertIn("connection 'left:TeleopL/Slave -> right:PSM1/Arm' is lost", output)

    def test_global_manager(self):
        self.kill("suture-manager", "the global manager")


class Ended(unittest.TestCase):
    def test_interrupt_ends_every_process(self):
        with Demo(PROGRAMS, "--seconds", "60") as demo:
            demo.await_progress()
            children = demo.children()
            interrupt(demo.process)
            status, output = demo.finish()
            self.assertEqual(status, 130, output)
            self.assertIn("Interrupted after", output)
            self.assertTrue(all_end(children), "processes are left")
            self.assertEqual(demo.result()["failures"], [])
            self.assertEqual(demo.leftovers(), [])

    def test_interrupt_while_starting(self):
        with Demo(PROGRAMS, "--seconds", "60") as demo:
            demo.process.stdout.readline()
            children = demo.children()
            interrupt(demo.process)
            status, output = demo.finish()
            self.assertEqual(status, 130, output)
            self.assertTrue(all_end(children), "processes are left")
            self.assertEqual(demo.leftovers(), [])

    @unittest.skipUnless(os.geteuid() == 0, "only root may lay cables between network namespaces")
    def test_interrupt_while_cables_are_laid(self):
        """The interrupt comes in the middle of the first cable's commands, and those of the second follow."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        command = pathlib.Path(folder.name) / "ip"
        command.write_text(f"""#!/bin/sh
case "$*" in
  *netns*) mkdir "$0.sent" && kill -INT "$(cut -d' ' -f4 /proc/$PPID/stat)" ;;
esac
exec {shutil.which("ip")} "$@"
""")
        command.chmod(0o755)
        with unittest.mock.patch.dict(os.environ, PATH=f"{folder.name}:{os.environ['PATH']}"):
            with Demo(PROGRAMS, "--seconds", "60", "--network", "namespaces") as demo:
                status, output = demo.finish()
        self.assertEqual(status, 130, output)

    def test_interrupt_is_told_though_the_picture_fails(self):
        with Demo(PROGRAMS, "--topology", "fig3b", "--seconds", "60", "--picture", "/no/such/knot.png") as demo:
            demo.await_progress()
            interrupt(demo.process)
            status, output = demo.finish()
            self.assertEqual(status, 130, output)
            self.assertRegex(output, "(writing the|drawing a) picture")

    def test_a_killed_demo_leaves_no_process(self):
        with Demo(PROGRAMS, "--seconds", "60") as demo:
            demo.await_progress()
            children = demo.children()
            demo.process.kill()
            demo.process.wait()
            self.assertTrue(all_end(children), "processes are left")


class Workstation(unittest.TestCase):
    """These run the programs without the demo around them."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, program, *arguments):
        process = subprocess.Popen([*WITHOUT_REAL_TIME, PROGRAMS / program, *arguments], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def workstation(self, topology, *arguments):
        process = self.start("suture-workstation", "--deployment", topology, "--report-fd", "-",
                             *arguments)
        # This reads all the time, since a workstation leaves out reports that are not taken.
        process.messages = queue.Queue()
        reader = threading.Thread(target=self.read, args=(process,))
        reader.start()
        self.addCleanup(reader.join)
        self.addCleanup(process.kill)
        return process

    def read(self, process):
        for line in process.stdout:
            process.messages.put(json.loads(line))
        process.messages.put({"kind": "end"})

    def next_message(self, process):
        message = process.messages.get()
        if message["kind"] == "end":
            self.fail(f"it has ended: {process.stderr.read()}")
        return message

    def await_message(self, process, kind):
        while (message := self.next_message(process))["kind"] != kind:
            pass
        return message

    def await_failure(self, process, subject):
        while not (text := self.await_message(process, "failure")["text"]).startswith(subject):
            pass
        return text

    def newest_report(self, process):
        """Returns one that is written after this call."""
        while not process.messages.empty():
            self.next_message(process)
        self.await_message(process, "report")  # may have been on its way
        return self.await_message(process, "report")

    def two_processes(self):
        topology = json.loads((TOPOLOGIES / "fig3c.json").read_text())
        topology["manager"] = f"unix:{self.folder}/manager.sock"
        for process in topology["processes"]:  # a user without the right would be told so
            for one in (process, *process["components"]):
                one.pop("scheduling", None)
        file = self.folder / "d.json"
        file.write_text(json.dumps(topology))
        manager = self.start("suture-manager", "--listen", topology["manager"])
        self.assertIn("ready on", manager.stdout.readline())
        self.file, self.manager = file, manager
        stations = [self.workstation(file, "--process", name) for name in ("left", "right")]
        for station in stations:
            self.await_message(station, "started")
        return stations

    def await_line(self, process, text):
        for line in process.stderr:
            if text in line:
                return
        self.fail(f"never told: {text}")

    def test_runs_for_its_time_alone(self):
        process = self.workstation(TOPOLOGIES / "single.json", "--seconds", "0.5")
        report = self.await_message(process, "report")
        self.assertEqual(report["process"], "console")
        self.assertEqual(len(report["connections"]), 41)
        self.assertEqual(len(report["tasks"]), 19)
        self.assertEqual(process.wait(timeout=60), 0)

    def test_messages_of_arms_are_told_if_asked_for(self):
        process = self.workstation(TOPOLOGIES / "single.json", "--messages")
        self.await_line(process, "console: PSM1/Arm status: ")

    def test_being_told_to_end_is_a_success(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.workstation(TOPOLOGIES / "single.json")
            self.await_message(process, "started")
            process.send_signal(number)
            self.assertEqual(process.wait(timeout=60), 0)

    def test_a_killed_slave_leaves_the_master_running(self):
        left, right = self.two_processes()
        right.kill()
        text = self.await_failure(left, "connection 'left:TeleopL/Slave -> right:PSM1/Arm' is lost, closed: ")
        self.assertIn("Start that process again", text)
        before, after = self.await_message(left, "report"), self.await_message(left, "report")
        for one, next_one in zip(before["tasks"], after["tasks"]):
            self.assertEqual(next_one["state"], "running")
            self.assertGreater(next_one["cycles"], one["cycles"])
        left.terminate()
        self.assertEqual(left.wait(timeout=60), 1)
        self.assertIn(text, left.stderr.read())

    def test_a_frozen_slave_is_not_said_to_have_ended(self):
        left, right = self.two_processes()
        right.send_signal(signal.SIGSTOP)
        text = self.await_failure(left, "connection 'left:TeleopL/Slave -> right:PSM1/Arm' is lost, silent: "
                                        "its process has not answered")
        right.kill()
        self.assertIn("It is connected anew when that process goes on", text)

    def test_a_slave_that_is_started_again_is_found_again(self):
        left, right = self.two_processes()
        right.kill()
        self.await_line(left, "connection 'left:TeleopL/Slave -> right:PSM1/Arm' is lost")
        right = self.workstation(self.file, "--process", "right")
        self.await_message(right, "started")
        self.await_line(left, "connection 'left:TeleopL/Slave -> right:PSM1/Arm' is there again")
        slave = {one["name"]: one for one in self.newest_report(left)["connections"]}
        self.assertEqual(slave["left:TeleopL/Slave -> right:PSM1/Arm"]["status"], "connected")
        left.terminate()
        self.assertEqual(left.wait(timeout=60), 0)

    def test_without_the_global_manager_everything_runs_on(self):
        left, _ = self.two_processes()
        self.manager.kill()
        self.await_line(left, "does not answer: connections live on, new ones have to wait for one that does")
        before, after = self.await_message(left, "report"), self.await_message(left, "report")
        for one, next_one in zip(before["tasks"], after["tasks"]):
            self.assertGreater(next_one["cycles"], one["cycles"])
        self.start("suture-manager", "--listen", f"unix:{self.folder}/manager.sock")
        self.await_line(left, "manager.sock is there again")
        left.terminate()
        self.assertEqual(left.wait(timeout=60), 0)

    def test_two_that_are_told_to_end_lose_nothing(self):
        stations = self.two_processes()
        for station in stations:
            station.terminate()
        for station in stations:
            self.assertEqual(station.wait(timeout=60), 0)
            self.assertEqual(station.stderr.read(), "")


unittest.main()
