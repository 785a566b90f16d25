"""A process is told to end while it starts, or while what it tells is not read."""

import fcntl
import json
import signal
import sys
import termios
import time
import unittest

from stations import Stations, component


def unread(pipe):
    """Returns how many bytes wait in it."""
    return int.from_bytes(fcntl.ioctl(pipe, termios.FIONREAD, bytes(4)), sys.byteorder)


class Ending(Stations):
    def setUp(self):
        super().setUp()
        self.brake = self.folder / "brake"

    def test_tasks_stop_in_order_while_their_process_waits(self):
        address = f"unix:{self.folder}/manager.sock"
        self.manager(address)
        spindle = component("Spindle", "Spindle", cycles=1, brake=str(self.brake), key=str(self.folder / "key"))
        for number in (signal.SIGINT, signal.SIGTERM):
            self.brake.unlink(missing_ok=True)
            station = self.workstation(
                {"manager": address,
                 "processes": [{"name": "here", "components": [spindle, component("Hand", "Hand")]},
                               {"name": "there", "components": [component("Platter", "Platter", angle=0)]}],
                 "connections": [{"from": "here:Hand/Turntable", "to": "there:Platter/Turntable"}]},
                "--process", "here")
            self.await_true(lambda: self.brake.exists() and self.brake.read_text() == "running\n")
            began = time.monotonic()
            station.send_signal(number)
            _, told = station.communicate(timeout=60)
            self.assertLess(time.monotonic() - began, 5)  # it would wait for 10 s
            self.assertEqual(station.returncode, 0)
            self.assertNotIn("error", told)
            self.assertEqual(self.brake.read_text().split(), ["running", "stopped"])
            self.assertEqual([one.name for one in self.folder.glob("*.sock")], ["manager.sock"])

    def test_the_last_report_is_told_once(self):
        station = self.workstation({"processes": [{"name": "robot", "components": []}]}, "--report-fd", "-", "--report-interval", "0.2",
                                   "--seconds", "0.2")
        kinds = [json.loads(line)["kind"] for line in station.communicate(timeout=60)[0].splitlines()]
        self.assertEqual(kinds, ["started", "report"])

    def test_the_reports_of_a_pause_are_left_out(self):
        interval, pause = 0.05, 2
        station = self.workstation({"processes": [{"name": "robot", "components": []}]}, "--report-fd", "-", "--report-interval",
                                   str(interval))

        def next_age():
            return json.loads(station.stdout.readline())["age"] / 1e9

        self.assertEqual(json.loads(station.stdout.readline())["kind"], "started")
        before = next_age()
        station.send_signal(signal.SIGSTOP)
        time.sleep(pause)  # the pause itself: another process follows no stepped clock
        station.send_signal(signal.SIGCONT)
        after = next_age()
        while after - before < pause / 2:  # those were written before it stood still
            before, after = after, next_age()
        # Those of the pause would come at once; each of the others is due an interval after the one before, but for the first.
        ages = [next_age() for _ in range(20)]
        self.assertGreater(ages[-1] - after, (len(ages) - 2) * interval)

    def test_a_reader_that_does_not_read_holds_up_nothing(self):
        spindle = component("Spindle", "Spindle", cycles=1000000, brake=str(self.brake))
        deployment = {"processes": [{"name": "robot", "components": [spindle]}]}
        pace = ("--report-fd", "-", "--report-interval", "0.01")
        station = self.workstation(deployment, *pace, "--seconds", "4")
        self.assertEqual(station.wait(timeout=60), 0)
        kinds = [json.loads(line)["kind"] for line in station.stdout]
        self.assertEqual((kinds[0], kinds[-1]), ("started", "report"))

        # A pipe of one page has no room as soon as anything is in it.
        station = self.workstation(deployment, *pace, pipesize=4096)
        self.await_true(lambda: unread(station.stdout) > 0)
        station.terminate()
        self.assertEqual(station.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
