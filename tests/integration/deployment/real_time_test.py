"""The file of a process schedules its threads and locks its memory, with the rights to that and without."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.append(str(pathlib.Path(__file__).parents[2] / "support"))
from rights import WITHOUT_REAL_TIME, may_be_real_time

PROGRAM, LIBRARY, MANAGER = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
PROCESSOR = min(os.sched_getaffinity(0))


def threads(pid):
    """Returns the policy and priority of each thread, by its name."""
    found = {}
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        thread = int(task.name)
        found[(task / "comm").read_text().strip()] = (
            os.sched_getscheduler(thread), os.sched_getparam(thread).sched_priority, os.sched_getaffinity(thread))
    return found


def locked_bytes(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmLck:"):
            return 1024 * int(line.split()[1])
    return 0


class RealTime(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, arguments, **options):
        process = subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True, **options)

        def end():
            process.kill()
            process.communicate()

        self.addCleanup(end)
        return process

    def start_station(self, real_time, prefix=()):
        """Starts a task under SCHED_FIFO, and one beside it whose connection to it is carried by a frame link."""
        socket = f"unix:{self.folder}/manager.sock"
        manager = self.start([MANAGER, "--listen", socket])
        self.assertIn("ready on", manager.stdout.readline())
        spindle = {"name": "Spindle", "class": "Spindle", "library": LIBRARY,
                   "parameters": {"cycles": 1000000, "brake": str(self.folder / "brake")},
                   "scheduling": {"policy": "fifo", "priority": 20, "processor": PROCESSOR}}
        rows = {"name": "Rows", "class": "StateCollector", "parameters": {"file": "rows.jsonl", "reads": ["angle"]}}
        deployment = self.folder / "d.json"
        deployment.write_text(json.dumps({
            "manager": socket,
            "processes": [{"name": "robot",
                           "scheduling": {"policy": "round_robin", "priority": 10},
                           "lock_memory": True,
                           "real_time": real_time,
                           "components": [spindle, rows]}],
            "connections": [{"from": "Rows/Source", "to": "Spindle/Turntable", "lane": "frame"}]}, indent=1))
        self.told = self.folder / "stderr"
        with self.told.open("w") as stderr:
            return self.start([*prefix, PROGRAM, "--deployment", deployment, "--report-fd", "-",
                               "--report-interval", "0.05"], stderr=stderr)

    def await_report(self, station):
        for line in station.stdout:
            report = json.loads(line)
            if report["kind"] == "report" and report["connections"]:
                return report
        self.fail(self.told.read_text())

    def await_told(self, count):
        deadline = time.monotonic() + 60
        while True:
            lines = self.told.read_text().splitlines()
            if len(lines) >= count:
                return lines
            self.assertLess(time.monotonic(), deadline, lines)
            time.sleep(0.01)

    @unittest.skipUnless(may_be_real_time(20), "this user may not have real-time priorities, or lock memory")
    def test_threads_have_what_the_file_says(self):
        station = self.start_station("required")
        report = self.await_report(station)
        found = threads(station.pid)
        self.assertEqual(found["Spindle"], (os.SCHED_FIFO, 20, {PROCESSOR}), found)
        everywhere = os.sched_getaffinity(0)
        self.assertEqual(found["suture-lane"], (os.SCHED_RR, 10, everywhere), found)
        self.assertEqual(found["suture-control"], (os.SCHED_RR, 10, everywhere), found)
        self.assertEqual(found["Rows"], (os.SCHED_OTHER, 0, everywhere), found)
        self.assertEqual(os.sched_getscheduler(station.pid), os.SCHED_OTHER)
        self.assertGreater(locked_bytes(station.pid), 1 << 20)
        scheduling = {task["name"]: task["scheduling"] for task in report["tasks"]}
        self.assertEqual(scheduling, {"Spindle": f"fifo 20 on processor {PROCESSOR}", "Rows": "default"})
        self.assertEqual(self.told.read_text(), "")

    def test_a_missing_right_is_told_and_the_process_runs(self):
        station = self.start_station("preferred", WITHOUT_REAL_TIME)
        report = self.await_report(station)
        found = threads(station.pid)
        self.assertEqual(found["Spindle"], (os.SCHED_OTHER, 0, {PROCESSOR}), found)
        self.assertEqual(locked_bytes(station.pid), 0)
        scheduling = {task["name"]: task["scheduling"] for task in report["tasks"]}
        self.assertEqual(scheduling["Spindle"], f"default on processor {PROCESSOR}")
        lines = self.await_told(3)
        self.assertEqual(len(lines), 3, lines)
        for line, asked in zip(lines, (
                "cannot lock the memory of process 'robot': this user may lock a limited amount only. ",
                "cannot give the thread of component 'Spindle' SCHED_FIFO priority 20: Operation not permitted. ",
                "cannot give the thread of the connections of process 'robot' SCHED_RR priority 10: ")):
            self.assertIn(": warning: " + asked, line)

    def test_a_missing_right_that_is_required_stops_the_start(self):
        station = self.start_station("required", WITHOUT_REAL_TIME)
        self.assertEqual(station.communicate(timeout=60)[0], "")
        self.assertEqual(station.returncode, 1)
        lines = self.told.read_text().splitlines()
        self.assertIn("suture why", lines.pop())
        self.assertEqual([": error: cannot " in line for line in lines], [True] * 3, lines)


if __name__ == "__main__":
    unittest.main()
