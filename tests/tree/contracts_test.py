"""Checks the deployments that are shipped: each connection has a contract, with terms that suit what its client does with the values.

  contracts_test.py ROOT      checks the deployments of that tree, and that it finds what is planted in one of them
"""

import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()

# These clients read no value of which the age is judged: they hear events and give commands, or ask for a certain time (delayed()).
WITHOUT_AGES = {("Assistant", None), ("SystemConsole", None), ("SyntheticEndoscope", None), ("Surgeon", "Hand"),
                ("Surgeon", "Teleoperation"), ("KnotSurgeon", "Guidance"), ("Recorder", "Stop"), ("Recorder", "Teleoperation"),
                ("KnotRecorder", "Guidance")}
# These clients move an arm or give it power, so they must not act on a value that is stale or whose provider is lost.
ACTING = {"Follower", "KnotGuide", "KnotSurgeon", "Mtm", "MtmDrives", "Psm", "PsmDrives", "Surgeon", "Teleop"}
# These clients have a limit of their own for the data of their arms, by that parameter; without it, this many seconds.
OWN_LIMIT = {"Teleop": ("max_age", 0.02), "KnotGuide": ("max_age", 0.02), "MtmDrives": ("permit", 0.03), "PsmDrives": ("permit", 0.03)}
OTHER_LIMITS = {"KnotGuide": {"Vision", "Registration"}}
RECORDING = {"Recorder", "KnotRecorder"}

UNITS = {"s": 1, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}


def seconds(text):
    number, unit = re.fullmatch(r"([0-9.]+)([a-z]+)", text).groups()
    return float(number) * UNITS[unit]


def problems_of(connection, component):
    """Returns what is wrong with the contract of a connection whose client is that component."""
    kind, interface = component["class"], connection["from"].split("/")[1]
    terms = connection.get("contract")
    if terms is None:
        return ["has no contract"]
    found = [f"leaves out {term}" for term in ("on_loss",) if term not in terms]
    if not {(kind, None), (kind, interface)} & WITHOUT_AGES:
        found += [f"leaves out {term}" for term in ("max_age", "on_stale") if term not in terms]
    if kind in ACTING:
        found += [f"acts on old values: {term} is {terms[term]}" for term in ("on_stale", "on_loss")
                  if terms.get(term) in ("last", "zero")]
    if "max_age" in terms:
        found += problems_of_age(seconds(terms["max_age"]), terms.get("on_stale"), component, interface)
    return found


def problems_of_age(age, on_stale, component, interface):
    kind = component["class"]
    if kind in OWN_LIMIT and interface not in OTHER_LIMITS.get(kind, set()):
        parameter, default = OWN_LIMIT[kind]
        own = component.get("parameters", {}).get(parameter, default)
        if abs(age - own) > 1e-9:
            return [f"has another max_age than the {own} s of its client's {parameter}"]
    if kind in RECORDING and (age < 1 or on_stale != "last"):
        return ["keeps values of a short hiccup from a recording"]
    return []


def badly_agreed(deployment):
    components = {f"{process['name']}:{one['name']}": one for process in deployment["processes"]
                  for one in process["components"]}
    return [f"{one['from']} {problem}" for one in deployment["connections"]
            for problem in problems_of(one, components[one["from"].split("/")[0]])]


class Contracts(unittest.TestCase):
    def test_each_connection_has_one_that_suits_its_client(self):
        files = [path for path in (ROOT / "examples").rglob("*.json") if "connections" in json.loads(path.read_text())]
        self.assertGreaterEqual(len(files), 15)
        for path in files:
            with self.subTest(path.relative_to(ROOT)):
                self.assertEqual(badly_agreed(json.loads(path.read_text())), [])

    def test_what_is_planted_is_found(self):
        deployment = json.loads((ROOT / "examples/teleoperation/fig3b.json").read_text())
        connections = {one["from"]: one for one in deployment["connections"]}
        del connections["left:Console/MTML"]["contract"]
        connections["left:Guide/LeftMaster"]["contract"]["on_stale"] = "last"
        connections["left:MTMLDrives/Stop"]["contract"]["max_age"] = "250ms"
        connections["left:PSM2/Drives"]["contract"] = {}
        connections["left:RecorderPSM2/Arm"]["contract"]["max_age"] = "20ms"
        self.assertEqual(badly_agreed(deployment),
                         ["left:PSM2/Drives leaves out on_loss", "left:PSM2/Drives leaves out max_age",
                          "left:PSM2/Drives leaves out on_stale",
                          "left:MTMLDrives/Stop has another max_age than the 0.03 s of its client's permit",
                          "left:Console/MTML has no contract",
                          "left:RecorderPSM2/Arm keeps values of a short hiccup from a recording",
                          "left:Guide/LeftMaster acts on old values: on_stale is last"])


unittest.main()
