"""Runs a process of more components than the usual limit of descriptors lets it have."""

import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)


class Descriptors(unittest.TestCase):
    def test_the_hard_limit_is_used(self):
        spindle = {"class": "Spindle", "library": LIBRARY, "parameters": {"cycles": 1_000_000}}
        components = [{"name": f"Spindle{i}", **spindle} for i in range(100)]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "d.json"
            file.write_text(json.dumps({"processes": [{"name": "all", "components": components}]}))
            hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
            ended = subprocess.run(
                (PROGRAM, "--deployment", file, "--seconds", "0.2"),
                capture_output=True,
                text=True,
                timeout=60,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (64, hard)),
            )
        self.assertEqual(ended.returncode, 0, ended.stderr)


if __name__ == "__main__":
    unittest.main()
