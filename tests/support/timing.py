"""Prints what tests/timing.sh shows: timing.py BUILD [--summary] [PRESET...]

run.sh leaves the seconds of each build and test in BUILD/PRESET/Testing, ctest leaves those of each test, and run_gtest.py has gtest
write those of each case.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import xml.etree.ElementTree

PRESETS = ("dev", "tsan", "asan")
SLOWEST = 20
MOST_PARTS = 15


def minutes(seconds):
    return f"{seconds / 60:5.1f} min"


class Run:
    """This is the last run of a preset."""

    def __init__(self, build, preset):
        self.preset, self.records = preset, build / preset / "Testing"

    def seconds(self, part):
        file = self.records / f"seconds.{part}"
        return int(file.read_text(encoding="utf-8")) if file.exists() else None

    def tests(self):
        """Returns name and seconds of each test of ctest."""
        file = self.records / "tests.xml"
        if not file.exists():
            return []
        cases = xml.etree.ElementTree.parse(file).getroot().iter("testcase")
        return [(case.get("name"), float(case.get("time"))) for case in cases]

    def labels(self):
        """Returns the labels of each test, joined. It asks ctest for them, because its records have none."""
        command = ["ctest", "--test-dir", self.records.parent, "--show-only=json-v1"]
        known = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["tests"]
        named = {}
        for test in known:
            properties = {one["name"]: one["value"] for one in test.get("properties", [])}
            named[test["name"]] = " and ".join(properties.get("LABELS", [])) or "no label"
        return named

    def cases(self):
        """Yields name and seconds of each case of the gtest programs, which run many in one test."""
        for file in self.records.glob("cases/*.json"):
            for suite in json.loads(file.read_text(encoding="utf-8"))["testsuites"]:
                for case in suite["testsuite"]:
                    if case["status"] == "RUN":
                        yield f"{suite['name']}.{case['name']}", float(case["time"].rstrip("s"))

    def in_one_process(self):
        """Returns the tests that are gtest programs; their cases are listed instead of them."""
        return {file.stem for file in self.records.glob("cases/*.json")}


def part_of(test):
    """Returns the part of the tree that a test is of: its folder, what a gtest program tests, or the suite of a discovered case."""
    if test.startswith(("integration.", "compiler.")):
        return ".".join(test.split(".")[:2])
    head = test.split(".")[0]
    return head if "/" not in head else head.split("/")[-1]


def print_summary(runs):
    total = 0
    for run in runs:
        build, test = run.seconds("build"), run.seconds("test")
        if build is None:
            continue
        total += build + (test or 0)
        ran = f"test {minutes(test)}" if test is not None else "not tested"
        print(f"{run.preset:5} build {minutes(build)}, {ran}")
    print(f"total {minutes(total)}")


def print_sums(run, what, group):
    """Adds up tests that run side by side: the sum is more than the minutes that passed."""
    sums = collections.Counter()
    for name, seconds in run.tests():
        sums[group(name)] += seconds
    print(f"\n{run.preset}: seconds by {what}")
    for part, seconds in sums.most_common(MOST_PARTS):
        print(f"{seconds:8.1f}  {part}")


def print_slowest(run):
    shards = run.in_one_process()
    alone = [(name, seconds) for name, seconds in run.tests() if name not in shards]
    slowest = sorted([*alone, *run.cases()], key=lambda entry: -entry[1])[:SLOWEST]
    print(f"\n{run.preset}: the slowest {len(slowest)} tests and cases")
    for name, seconds in slowest:
        print(f"{seconds:8.1f}  {name}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--summary", action="store_true", help="the minutes of each preset alone")
    parser.add_argument("presets", nargs="*", default=PRESETS)
    arguments = parser.parse_intermixed_args()
    runs = [Run(arguments.build, preset) for preset in arguments.presets]
    print_summary(runs)
    if not arguments.summary:
        for run in runs:
            if run.tests():
                labels = run.labels()
                print_sums(run, "tier", lambda name, labels=labels: labels.get(name, "no longer there"))
                print_sums(run, "part", part_of)
                print_slowest(run)


if __name__ == "__main__":
    main()
