"""A recorder of the demo loses records, of which its file tells: the demo says so, and fails, because they may have told more."""

import json
import pathlib
import sys
import unittest

from programs import Demo

PROGRAMS = pathlib.Path(sys.argv.pop(1))
LOST = 7


class LostRecords(unittest.TestCase):
    def test_the_verdict_counts_them(self):
        with Demo(PROGRAMS, "--topology", "single", "--network", "unix", "--lane", "shm", "--seconds", "6", rate=200) as demo:
            demo.await_progress(seconds=2)
            recorder = self.recorder_of(demo, "PSM1")
            with recorder.open("a") as file:  # a line goes into it whole, as those of the recorder do
                file.write(json.dumps({"lost": LOST}) + "\n")
            status, output = demo.finish()
            print(output)
        self.assertEqual(status, 1, output)
        self.assertRegex(output, rf"FAILED  console:PSM1 follows console:MTMR: .*{LOST} records did not get into a file of the recorders")
        self.assertNotRegex(output, "FAILED  console:PSM2")

    def recorder_of(self, demo, arm):
        """Returns the file of the recorder that is connected to `arm`."""
        file = next(pathlib.Path(demo.folder.name).glob("*/deployment.json"))
        deployment = json.loads(file.read_text())
        components = {one["name"]: one for process in deployment["processes"] for one in process["components"]}
        for connection in deployment["connections"]:
            client, provider = (connection[end].split(":")[-1].split("/")[0] for end in ("from", "to"))
            if provider == arm and components[client]["class"] == "Recorder":
                return file.parent / components[client]["parameters"]["file"]
        raise AssertionError(f"nothing records {arm}")


unittest.main()
