"""A process collects what one of its tasks does, told by its deployment file alone."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)


def component(name, class_name, **parameters):
    return {"name": name, "class": class_name, "parameters": parameters}


class Collectors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "spindle.jsonl"

    def start(self, cycles, collectors, *options):
        """Starts a process; `collectors` are components, with what of the spindle each is connected to."""
        spindle = component("Spindle", "Spindle", cycles=cycles, brake=str(self.folder / "brake"))
        spindle["library"] = LIBRARY
        deployment = self.folder / "d.json"
        deployment.write_text(json.dumps({
            "processes": [{"name": "robot", "components": [*(one for one, _ in collectors), spindle]}],
            "connections": [{"from": one["name"] + "/Source", "to": "Spindle/" + of} for one, of in collectors]}))
        told = self.folder / "stderr"
        with told.open("w") as stderr:
            station = subprocess.Popen(
                [PROGRAM, "--deployment", deployment, "--report-fd", "-", "--report-interval", "0.05", *options],
                stdout=subprocess.PIPE, stderr=stderr, text=True)

        def end():
            station.kill()
            station.communicate()

        self.addCleanup(end)
        return station

    def told(self):
        return (self.folder / "stderr").read_text()

    def collected(self):
        """Returns the complete lines."""
        text = self.file.read_text() if self.file.exists() else ""
        return [json.loads(line) for line in text.splitlines(keepends=True) if line.endswith("\n")]

    def await_collected(self, *fits):
        """Returns what is in the file once it has a line for each of `fits`."""
        deadline = time.monotonic() + 30
        while True:
            lines = self.collected()
            if all(any(map(one, lines)) for one in fits):
                return
            self.assertLess(time.monotonic(), deadline, (lines[-3:], self.told()))
            time.sleep(0.02)

    def end(self, station):
        station.terminate()
        station.communicate(timeout=60)

    def test_rows_and_events_up_to_a_fault_are_in_the_file(self):
        # The collectors are connected within these seconds: before that the provider keeps nothing for them.
        cycles = 3000
        station = self.start(cycles, [
            (component("Rows", "StateCollector", file="spindle.jsonl", reads=["angle"]), "Turntable"),
            (component("Life", "EventCollector", file="spindle.jsonl"), "component")])
        for line in station.stdout:
            report = json.loads(line)
            if report["kind"] == "report" and any(task["state"] == "faulted" for task in report["tasks"]):
                break
        else:
            self.fail(self.told())
        self.assertEqual({task["name"] for task in report["tasks"]}, {"Spindle", "Rows", "Life"})
        self.await_collected(lambda line: line.get("angle") == cycles - 1,
                             lambda line: line["from"] == "Life" and line["value"]["state"] == "Faulted")
        self.end(station)

        lines = self.collected()
        states = [line["value"]["state"] for line in lines if line["from"] == "Life"]
        self.assertEqual(states, ["Running", "Faulted"], self.told())
        lines = [line for line in lines if line["from"] == "Rows"]
        rows = [line for line in lines if "row" in line]
        # The rows go from the first that was asked for to the last before the fault.
        self.assertEqual(rows[-1]["angle"], cycles - 1, self.told())
        before = None
        missed = 0
        for line in lines[lines.index(rows[0]):]:
            if "missed" in line:
                missed += line["missed"]
                continue
            if before:
                self.assertEqual(line["row"] - before["row"], missed + 1)
                self.assertEqual(line["angle"] - before["angle"], missed + 1)
            before, missed = line, 0

    def test_a_second_start_leaves_the_recording_alone(self):
        self.start(10**9, [(component("Rows", "StateCollector", file="spindle.jsonl"), "Turntable")])
        self.await_collected(lambda line: "row" in line)
        second = subprocess.run([PROGRAM, "--deployment", self.folder / "d.json"], capture_output=True, text=True, timeout=60)
        self.assertEqual(second.returncode, 1)
        self.assertIn("another recording is being written to it", second.stderr)
        # What the first writes meanwhile lies behind what it had.
        newest = max(line.get("row", 0) for line in self.collected())
        self.await_collected(lambda line: line.get("row", 0) > newest)
        self.assertNotIn("\0", self.file.read_text())
        self.assertEqual(self.collected()[0]["from"], "Rows")

    def test_a_disk_that_is_full_at_the_last_look_is_told(self):
        # It looks at the connection, when there is nothing yet, and not again before the end.
        station = self.start(10**9, [(component("Rows", "StateCollector", file="/dev/full", period=3600), "Turntable")])
        begun = None
        for line in station.stdout:
            report = json.loads(line)
            cycles = {task["name"]: task["cycles"] for task in report.get("tasks", [])}
            if begun is None and cycles.get("Rows", 0) > 0:
                begun = cycles["Spindle"]
            if begun is not None and cycles.get("Spindle", 0) > begun + 1:
                break
        station.terminate()
        rest, _ = station.communicate(timeout=60)
        self.assertEqual(station.returncode, 1, self.told())
        parked = "component 'robot:Rows' is parked, its code threw: recording to /dev/full: the file system did not take all of it"
        self.assertIn(parked, self.told())
        failures = [line for line in map(json.loads, rest.splitlines()) if line["kind"] == "failure"]
        self.assertEqual(len(failures), 1, failures)
        self.assertIn(parked, json.dumps(failures[0]))

    def test_reports_are_there_for_people_too(self):
        station = self.start(20, [(component("Rows", "StateCollector", file="spindle.jsonl"), "Turntable")],
                             "--report-form", "text")
        awaited = ["  Spindle: faulted (the spindle has seized), faults 1, cycles 19",
                   "  robot:Rows/Source -> robot:Spindle/Turntable: local, faulted, both ends",
                   "failure: component 'robot:Spindle' is parked"]
        for line in station.stdout:
            awaited = [text for text in awaited if text not in line]
            if not awaited:
                break
        self.assertEqual(awaited, [], self.told())
        self.end(station)


if __name__ == "__main__":
    unittest.main()
