"""A process whose task faults is restarted within the budget, then parked in its safe state, with dumps of each fault."""

import json
import unittest

from stations import Stations, component


class Faults(Stations):
    def setUp(self):
        super().setUp()
        self.brake = self.folder / "brake"
        self.key = self.folder / "key"

    def robot(self, restart, black_box=None, locked=False):
        spindle = component("Spindle", "Spindle", cycles=50, brake=str(self.brake))
        if locked:
            spindle["parameters"]["key"] = str(self.key)
        if restart:
            spindle["restart"] = restart
        process = {"name": "robot", "components": [spindle]}
        if black_box:
            process["black_box"] = black_box
        return self.workstation({"processes": [process]}, "--report-fd", "-", "--report-interval", "0.05")

    def await_message(self, station, fits):
        for line in station.stdout:
            message = json.loads(line)
            if fits(message):
                return message
        self.fail(station.stderr.read())

    def await_failure(self, station):
        return self.await_message(station, lambda message: message["kind"] == "failure")["text"]

    def end(self, station):
        """Returns exit status and what was told."""
        station.terminate()
        _, told = station.communicate(timeout=60)
        return station.returncode, told

    def test_restarts_end_with_the_budget(self):
        dumps = self.folder / "faults"
        dumps.mkdir()
        station = self.robot({"most": 2, "per": "1000s"}, {"folder": "faults", "rows": 4096}, locked=True)
        # The next fault waits for the dump of the one before: two that are close share a file.
        for number in (1, 2, 3):
            self.key.touch()
            self.await_true(lambda: any(dumps.glob(f"*.Spindle.{number}.jsonl")))
        self.assertEqual(
            self.await_failure(station),
            "component 'robot:Spindle' is parked, its code threw: the spindle has seized. It is restarted no more. "
            "Correct the cause and start the process anew")
        report = self.await_message(station, lambda message: message["kind"] == "report")
        self.assertEqual([(task["state"], task["faults"]) for task in report["tasks"]], [("faulted", 3)])
        status, told = self.end(station)
        self.assertEqual(status, 1)
        self.assertEqual(self.brake.read_text().split(), ["running", "closed", "open", "closed", "open", "closed"])
        files = sorted(dumps.iterdir())
        self.assertEqual([file.name.split(".")[-3:] for file in files],
                         [["Spindle", str(n), "jsonl"] for n in (1, 2, 3)])
        for number, file in enumerate(files, 1):
            self.assertIn(f"Its last state is in {file}", told)
            fault, *rows = [json.loads(line) for line in file.read_text().splitlines()]
            self.assertEqual(fault, {"from": "Spindle", "fault": "the spindle has seized",
                                     "first": number, "last": number})
            angles = [row["angle"] for row in rows if row["from"] == "Spindle/Turntable"]
            # The dump has every cycle up to the fault but the one that threw, and perhaps some after the restart.
            self.assertGreaterEqual(len(angles), 49)
            self.assertIn(50 * number - 1, angles)
            self.assertEqual(angles, sorted(angles))

    def test_without_a_budget_the_first_fault_is_the_last(self):
        station = self.robot(None)
        self.assertNotIn("restarted no more", self.await_failure(station))
        self.assertEqual(self.end(station)[0], 1)
        self.assertEqual(self.brake.read_text().split(), ["running", "closed"])

    def test_a_restart_within_the_budget_is_no_failure(self):
        station = self.robot({"most": 16, "per": "0.001s"})
        for line in station.stderr:
            if "runs again after fault" in line:
                break
        status, _ = self.end(station)
        self.assertEqual(status, 0)

    def test_a_faulted_provider_is_not_there_again_when_its_client_ends(self):
        address = f"unix:{self.folder}/manager.sock"
        self.manager(address)
        spindle = component("Spindle", "Spindle", cycles=50, brake=str(self.brake), key=str(self.key))
        deployment = {"manager": address,
                      "processes": [{"name": "robot", "components": [spindle]},
                                    {"name": "console", "components": [component("Hand", "Hand")]}],
                      "connections": [{"from": "console:Hand/Turntable", "to": "robot:Spindle/Turntable"}]}
        reports = ("--report-fd", "-", "--report-interval", "0.05")
        robot = self.workstation(deployment, "--process", "robot", *reports)
        console = self.workstation(deployment, "--process", "console", *reports)
        for station in (robot, console):
            self.await_message(station, lambda message: message.get("connections"))
        self.key.touch()
        self.await_message(robot, lambda message: "brings nothing until its provider is restarted" in message.get("text", ""))
        self.end(console)
        self.await_message(robot, lambda message: [one["status"] for one in message.get("connections", [])] == ["closed"])
        self.assertNotIn("is there again", self.end(robot)[1])


if __name__ == "__main__":
    unittest.main()
