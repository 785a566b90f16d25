"""A process that is told to end while it starts, or while nobody reads what it tells."""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)
MANAGER = pathlib.Path(PROGRAM).parent / "suture-manager"


class Ending(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.brake = self.folder / "brake"

    def start(self, *command):
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

        def end():
            process.kill()
            process.communicate()

        self.addCleanup(end)
        return process

    def workstation(self, deployment, *arguments):
        file = self.folder / "d.json"
        file.write_text(json.dumps(deployment))
        return self.start(PROGRAM, "--deployment", file, *arguments)

    def component(self, name, class_name, **parameters):
        return {"name": name, "class": class_name, "library": LIBRARY, "parameters": parameters}

    def await_true(self, condition):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def test_tasks_stop_in_order_though_their_process_still_waits_for_another(self):
        address = f"unix:{self.folder}/manager.sock"
        manager = self.start(MANAGER, "--listen", address)
        self.assertIn("ready on", manager.stdout.readline())
        spindle = self.component("Spindle", "Spindle", cycles=1, brake=str(self.brake), key=str(self.folder / "key"))
        for number in (signal.SIGINT, signal.SIGTERM):
            self.brake.unlink(missing_ok=True)
            station = self.workstation(
                {"manager": address,
                 "processes": [{"name": "here", "components": [spindle, self.component("Hand", "Hand")]},
                               {"name": "there", "components": [self.component("Platter", "Platter", angle=0)]}],
                 "connections": [{"from": "here:Hand/Turntable", "to": "there:Platter/Turntable"}]},
                "--process", "here")
            self.await_true(lambda: self.brake.exists())
            self.assertEqual(self.brake.read_text(), "running\n")
            began = time.monotonic()
            station.send_signal(number)
            _, told = station.communicate(timeout=60)
            self.assertLess(time.monotonic() - began, 5)  # it would wait for 10 s
            self.assertEqual((station.returncode, told), (0, ""))
            self.assertEqual(self.brake.read_text().split(), ["running", "stopped"])
            self.assertEqual([one.name for one in self.folder.glob("*.sock")], ["manager.sock"])

    def test_a_reader_that_does_not_read_holds_up_nothing(self):
        spindle = self.component("Spindle", "Spindle", cycles=1000000, brake=str(self.brake))
        deployment = {"processes": [{"name": "robot", "components": [spindle]}]}
        pace = ("--report-fd", "-", "--report-interval", "0.01")
        station = self.workstation(deployment, *pace, "--seconds", "4")
        self.assertEqual(station.wait(timeout=60), 0)
        kinds = [json.loads(line)["kind"] for line in station.stdout]
        self.assertEqual((kinds[0], kinds[-1]), ("started", "report"))

        station = self.workstation(deployment, *pace)
        time.sleep(3)  # until the pipe is full
        station.terminate()
        self.assertEqual(station.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
