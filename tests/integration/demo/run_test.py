"""Runs the demo for three seconds on one topology and lane, and checks what it says.

How closely a slave follows depends here on what else the machine does. The law itself, to a
millimetre, is tested in virtual time: tests/integration/teleoperation/law_test.cpp.
"""

import pathlib
import re
import sys

from programs import Demo

LOOSE = 10  # times the demo's own bounds
PROCESSES = {"single": 1, "fig3a": 2, "fig3c": 2}
SLAVES = {
    "single": {"console:PSM2": "console:MTML", "console:PSM1": "console:MTMR"},
    "fig3a": {"left:PSM2": "left:MTML", "right:PSM1": "right:MTMR"},
    "fig3c": {"right:PSM1": "left:MTML", "left:PSM2": "right:MTMR"},
}


def expected_lane(connection, lane):
    source, target = connection["name"].split(" -> ")
    if lane != "auto":
        return lane
    return "local" if source.split(":")[0] == target.split(":")[0] else "shm"


def follows_late(check):
    return not check["passed"] and re.search(r"follows .*error .* at p99", check["text"])


def check(result, topology, lane):
    failed = [one for one in result["checks"] if not one["passed"]]
    assert result["passed"] == (not failed), result["checks"]
    assert all(follows_late(one) for one in failed), failed
    assert len(result["processes"]) == PROCESSES[topology]
    assert len(result["connections"]) == 12
    for connection in result["connections"]:
        wanted = expected_lane(connection, lane)
        assert connection["lane"] == wanted, connection
        assert connection["end"] == "both", connection
        on_wire = connection["bytes_sent"] + connection["bytes_received"]
        assert (on_wire > 0) == (wanted != "local"), connection
    slaves = {arm["name"]: arm for arm in result["arms"] if "follows" in arm}
    assert {name: arm["follows"] for name, arm in slaves.items()} == SLAVES[topology]
    for arm in slaves.values():
        assert arm["travel"] >= 0.03, arm
        assert arm["position_error"]["p99"] <= LOOSE * 0.001, arm
        assert arm["orientation_error"]["p99"] <= LOOSE * 0.0174533, arm


def main():
    programs, topology, lane = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    with Demo(programs, "--topology", topology, "--lane", lane, "--seconds", "3") as demo:
        status, output = demo.finish()
        print(output)
        result = demo.result()
        assert status == (0 if result["passed"] else 1), f"exit status {status}"
        check(result, topology, lane)
        assert "\x1b" not in output, "colours in a pipe"
        assert demo.leftovers() == [], demo.leftovers()


main()
