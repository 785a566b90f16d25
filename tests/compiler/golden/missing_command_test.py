"""Gives a component that lacks a command of its contract to a compiler without suturec: it reports one error, which stands where the
component is made and names both.

  missing_command_test.py COMPILER FLAG...
"""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HEADER = "robots/simulated_arm.h"
COMMAND = "  void set_speed(double speed) override { everything_.speed = speed; }\n"


def main():
    text = (HERE / HEADER).read_text(encoding="utf-8")
    assert COMMAND in text
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / HEADER
        header.parent.mkdir()
        header.write_text(text.replace(COMMAND, ""), encoding="utf-8")
        command = [sys.argv[1], "-std=c++20", "-fsyntax-only", f"-I{folder}", f"-I{HERE}", f"-I{HERE}/expected", *sys.argv[2:],
                   HERE / "expected/robots/simulated_arm.suture.cpp"]
        done = subprocess.run(command, capture_output=True, text=True)
    errors = [line for line in done.stderr.splitlines() if "error:" in line]
    named = "robots::Arm::set_speed(double)" in done.stderr or "'set_speed'" in done.stderr
    named = named and len(errors) == 1 and "simulated_arm.suture.cpp:" in errors[0] and "robots::SimulatedArm" in errors[0]
    print("one error that names it" if named else f"expected one error with component and command, got\n{done.stderr}")
    return 0 if named else 1


if __name__ == "__main__":
    sys.exit(main())
