"""examples/09_three_namespaces: two arms on two machines, watched from a third; skipped for users who may lay no networks."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

from example import EXAMPLES, PATIENCE, PROGRAMS, SCALE, Example

SCRIPT = EXAMPLES / "09_three_namespaces" / "run.sh"


class ThreeNamespaces(Example):
    def test_the_screen_sees_both_arms_and_nothing_is_left(self):
        process = subprocess.run([SCRIPT, "8", PROGRAMS], capture_output=True, text=True, timeout=PATIENCE,
                                 env=dict(self.environment))
        if process.returncode == 77:
            self.assertIn("skipped: network namespaces and a bridge between them need root", process.stderr)
            self.assertEqual(process.stdout, "")
            sys.stderr.write(process.stderr)
            sys.stderr.flush()
            os._exit(77)  # ctest's word for it
        self.assertEqual(process.returncode, 0, process.stderr)
        moved = [(float(master), float(slave)) for master, slave in
                 re.findall(r"(?m)^Display: master moved by +([\d.]+) mm, slave by +([\d.]+) mm$", process.stdout)]
        ratios = [slave / master for master, slave in moved if master >= 30]
        self.assertTrue(ratios, process.stdout + process.stderr)
        self.assertTrue(any(abs(ratio - SCALE) <= 0.1 * SCALE for ratio in ratios), process.stdout)
        self.assertEqual(list(pathlib.Path(self.folder).iterdir()), [])


unittest.main()
