"""Gives a header of Suture to a compiler where `emit` and `slots` are macros, as Qt has them: the first error says what to do.

  qt_keywords_test.py COMPILER FLAG...
"""

import subprocess
import sys


def main():
    command = [sys.argv[1], "-std=c++20", "-fsyntax-only", *sys.argv[2:], "-xc++", "-"]
    text = "#define emit\n#define slots\n#define signals public\n#include <suture/component/events.h>\n"
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    errors = [line for line in done.stderr.splitlines() if "error:" in line]
    told = bool(errors) and "QT_NO_KEYWORDS" in errors[0]
    print("the first error says what to do" if told else f"expected QT_NO_KEYWORDS in the first error, got\n{done.stderr}")
    return 0 if told else 1


if __name__ == "__main__":
    sys.exit(main())
