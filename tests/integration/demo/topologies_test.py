"""A topology is a deployment file: those beside the demo are found by themselves, and any other may be named."""

import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from programs import Demo

PROGRAMS = pathlib.Path(sys.argv.pop(1))
EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "examples"
TOPOLOGIES = EXAMPLES / "teleoperation"


def refusal_of(topology):
    process = subprocess.run([PROGRAMS / "suture-demo", "--topology", topology], capture_output=True, text=True, timeout=60)
    return process.returncode, process.stdout, process.stderr


class Topologies(unittest.TestCase):
    def test_each_file_is_offered_with_its_title(self):
        text = subprocess.run([PROGRAMS / "suture-demo", "--help"], capture_output=True, text=True, timeout=60).stdout
        files = list(TOPOLOGIES.glob("*.json"))
        self.assertGreaterEqual(len(files), 5)
        for file in files:
            title = json.loads(file.read_text())["title"]
            self.assertRegex(text, rf"(?m)^  {file.stem} +{title}$")

    def test_a_task_that_moves_a_slave_has_contracts(self):
        contracts = 0
        for file in EXAMPLES.glob("*/*.json"):
            deployment = json.loads(file.read_text())
            movers = [f"{process['name']}:{one['name']}/" for process in deployment["processes"]
                      for one in process["components"] if one["class"] in ("Teleop", "KnotGuide")]
            for one in deployment["connections"]:
                if one["from"].startswith(tuple(movers)) and one["to"].endswith(("/Arm", "/Vision")):
                    self.assertIn("max_age", one.get("contract", {}), f"{file}: {one['from']}")
                    contracts += 1
        self.assertGreaterEqual(contracts, 35)

    def test_contracts_accept_the_permits_that_drives_accept(self):
        """Without real-time priorities the demo gives drives an older permit, which their contract must not refuse."""
        with Demo(PROGRAMS, "--topology", "single", "--seconds", "60") as demo:
            demo.await_progress()
            deployment = json.loads(next(pathlib.Path(demo.folder.name).glob("*/deployment.json")).read_text())
        permits = {f"{process['name']}:{one['name']}": one["parameters"]["permit"] for process in deployment["processes"]
                   for one in process["components"] if one["class"].endswith("Drives")}
        ages = {one["from"].split("/")[0]: one["contract"]["max_age"] for one in deployment["connections"]
                if one["to"].endswith("/Stop") and "max_age" in one["contract"]}
        self.assertEqual(set(permits.values()), {0.25})
        self.assertEqual(ages, {drives: "250ms" for drives in permits})

    def test_recorders_see_each_cycle_of_their_arms(self):
        recorders = 0
        for file in TOPOLOGIES.glob("*.json"):
            deployment = json.loads(file.read_text())
            periods = {f"{process['name']}:{one['name']}": one.get("parameters", {}).get("period")
                       for process in deployment["processes"] for one in process["components"]}
            for one in deployment["connections"]:
                recorder, arm = one["from"].split("/")[0], one["to"].split("/")[0]
                if ":Recorder" in recorder and one["to"].endswith("/Arm"):
                    self.assertLessEqual(periods[recorder], periods[arm], f"{file}: {recorder}")
                    recorders += 1
        self.assertGreaterEqual(recorders, 16)

    def test_an_unknown_name_is_answered_with_the_known_ones(self):
        status, output, errors = refusal_of("fig3d")
        self.assertEqual((status, output), (1, ""))
        self.assertIn("finding topology 'fig3d': ", errors)
        self.assertIn("has 'fig3a', 'fig3a_clutch', 'fig3b', 'fig3b_tasks', 'fig3c' and 'single'. Name one of them, or a deployment file", errors)

    def test_what_differs_is_told_by_the_files(self):
        def compared(first, second):
            process = subprocess.run([PROGRAMS / "suture-demo", "--compare", first, second], capture_output=True, text=True,
                                     timeout=60)
            self.assertEqual((process.returncode, process.stderr), (0, ""))
            return process.stdout

        text = compared("fig3a", "fig3c")
        self.assertEqual([" ".join(line.split()) for line in re.findall(r"(?m)^Teleop.*$", text)],
                         ['TeleopL/frames/Slave/moving "PSM2_tip" "PSM1_tip"',
                          'TeleopL/frames/Slave/reference "PSM2_base" "PSM1_base"',
                          'TeleopR/frames/Slave/moving "PSM1_tip" "PSM2_tip"',
                          'TeleopR/frames/Slave/reference "PSM1_base" "PSM2_base"',
                          "TeleopL/Jaw PSM2/Jaw PSM1/Jaw", "TeleopL/Slave PSM2/Arm PSM1/Arm",
                          "TeleopR/Jaw PSM1/Jaw PSM2/Jaw", "TeleopR/Slave PSM1/Arm PSM2/Arm"])
        self.assertIn("19 of 19 components run in the same process, 37 of 41 connections lead to the same provider.", text)
        self.assertIn(hashlib.sha256((PROGRAMS / "suture-workstation").read_bytes()).hexdigest(), text)
        text = compared("single", "fig3a")
        self.assertRegex(text, r"(?m)^PSM1 +console +right$")
        self.assertIn("0 of 19 components run in the same process, 41 of 41 connections lead to the same provider.", text)
        with tempfile.TemporaryDirectory() as folder:
            changed = pathlib.Path(folder) / "changed.json"
            fig3a = (TOPOLOGIES / "fig3a.json").read_text()
            begin = fig3a.index('"left:TeleopL/Master"')
            changed.write_text(fig3a[:begin].replace('"scale": 0.4', '"scale": 0.3', 1) +
                               fig3a[begin:].replace('"max_age": "20ms"', '"max_age": "9ms"', 1))
            text = compared("fig3a", changed)
        self.assertRegex(text, r"(?m)^TeleopL/parameters/scale +0\.4 +0\.3$")
        self.assertRegex(text, r'(?m)^TeleopL/Master/contract/max_age +"20ms" +"9ms"$')
        self.assertNotIn("TeleopR", text)

    def test_a_comparison_refuses_options_of_a_run(self):
        for option in (("--json", "result.json"), ("--picture", "knot.png"), ("--seconds", "5"), ("--topology", "fig3a")):
            with self.subTest(option[0]):
                process = subprocess.run([PROGRAMS / "suture-demo", "--compare", "fig3a", "fig3c", *option],
                                         capture_output=True, text=True, timeout=60)
                self.assertNotEqual(process.returncode, 0)
                self.assertIn(f"{option[0]} excludes --compare", process.stderr)
                self.assertEqual(process.stdout, "")

    def test_file_that_is_not_there(self):
        status, output, errors = refusal_of("/no/such.json")
        self.assertEqual((status, output), (1, ""))
        self.assertIn("finding topology '/no/such.json'", errors)

    def test_new_file_is_a_new_topology(self):
        """One master drives the slave of the other workstation, and no master drives the other slave."""
        deployment = json.loads((TOPOLOGIES / "fig3c.json").read_text())
        deployment["title"] = "one slave alone"
        left, right = (process["components"] for process in deployment["processes"])
        gone = ("TeleopR", "SurgeonR", "RecorderMTMR")
        right[:] = [one for one in right if one["name"] not in gone]
        console = next(one for one in left if one["class"] == "SystemConsole")
        console["parameters"]["system"].remove("TeleopR")
        deployment["connections"] = [one for one in deployment["connections"]
                                     if not any(name in one["from"] + one["to"] for name in gone)]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "alone.json"
            file.write_text(json.dumps(deployment))
            with Demo(PROGRAMS, "--topology", file, "--seconds", "4") as demo:
                _, output = demo.finish()
                result = demo.result()
        self.assertEqual(result["failures"], [], output)
        self.assertEqual(result["topology"], "alone")
        self.assertIn("Teleoperation alone  2 processes", output)
        self.assertIn("one slave alone", output)
        self.assertEqual({arm["name"]: arm["follows"] for arm in result["arms"] if "follows" in arm},
                         {"right:PSM1": "left:MTML"})


unittest.main()
