"""A process that collects what one of its tasks does, told by its deployment file alone."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)


def component(name, class_name, **parameters):
    return {"name": name, "class": class_name, "parameters": parameters}


class Collectors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_rows_and_events_up_to_a_fault_are_in_the_file(self):
        spindle = component("Spindle", "Spindle", cycles=200, brake=str(self.folder / "brake"))
        spindle["library"] = LIBRARY
        rows = component("Rows", "StateCollector", file="spindle.jsonl", reads=["angle"])
        life = component("Life", "EventCollector", file="spindle.jsonl")
        file = self.folder / "d.json"
        file.write_text(json.dumps({
            "processes": [{"name": "robot", "components": [rows, life, spindle]}],
            "connections": [{"from": "Rows/Source", "to": "Spindle/Turntable"},
                            {"from": "Life/Source", "to": "Spindle/component"}]}))
        station = subprocess.run([PROGRAM, "--deployment", file, "--seconds", "1", "--report-fd", "-"],
                                 capture_output=True, text=True, timeout=60)
        report = json.loads(station.stdout.splitlines()[-1])
        self.assertEqual({task["name"] for task in report["tasks"]}, {"Spindle", "Rows", "Life"})

        lines = [json.loads(line) for line in (self.folder / "spindle.jsonl").read_text().splitlines()]
        states = [line["value"]["state"] for line in lines if line["from"] == "Life"]
        self.assertEqual(states, ["Running", "Faulted"], station.stderr)
        rows = [line for line in lines if "row" in line]
        missed = sum(line.get("missed", 0) for line in lines)
        # From the first row that was asked for to the last before the fault.
        self.assertEqual(rows[-1]["angle"], 199, station.stderr)
        self.assertEqual(len(rows) + missed, rows[-1]["row"] - rows[0]["row"] + 1)
        for one, following in zip(rows, rows[1:]):
            self.assertEqual(following["angle"] - one["angle"], following["row"] - one["row"])


    def test_reports_are_there_for_people_too(self):
        spindle = component("Spindle", "Spindle", cycles=20, brake=str(self.folder / "brake"))
        spindle["library"] = LIBRARY
        rows = component("Rows", "StateCollector", file="spindle.jsonl")
        file = self.folder / "d.json"
        file.write_text(json.dumps({
            "processes": [{"name": "robot", "components": [rows, spindle]}],
            "connections": [{"from": "Rows/Source", "to": "Spindle/Turntable"}]}))
        station = subprocess.run([PROGRAM, "--deployment", file, "--seconds", "0.5", "--report-fd", "-",
                                  "--report-form", "text"],
                                 capture_output=True, text=True, timeout=60)
        self.assertIn("  Spindle: faulted (the spindle has seized), faults 1, cycles 19", station.stdout)
        self.assertIn("  robot:Rows/Source -> robot:Spindle/Turntable: local, faulted, both ends", station.stdout)
        self.assertIn("failure: component 'robot:Spindle' is parked", station.stdout)


if __name__ == "__main__":
    unittest.main()
