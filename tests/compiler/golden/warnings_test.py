"""What suturec has written compiles without a warning, headers and sources.

  warnings_test.py COMPILER ROOT FLAG...    every ROOT/**/*.suture.cpp, as one translation unit
"""

import pathlib
import subprocess
import sys

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-fsyntax-only"]
LOSSY = "int planted(double value);\nint planted(double value) { return value; }\n"


def compiles(compiler, flags, text):
    done = subprocess.run([compiler, *STRICT, *flags, "-x", "c++", "-"], input=text, text=True, check=False)
    return done.returncode == 0


def main():
    compiler, root, *flags = sys.argv[1:]
    sources = sorted(pathlib.Path(root).rglob("*.suture.cpp"))
    assert sources, f"nothing below {root}"
    assert not compiles(compiler, flags, LOSSY), "a conversion that loses was not refused (the message above is expected)"
    text = "".join(f'#include "{source.relative_to(root)}"\n' for source in sources)
    if not compiles(compiler, [f"-I{root}", *flags], text):
        return f"{compiler} has something to say about {root}"
    print(f"{len(sources)} files without a warning")
    return 0


if __name__ == "__main__":
    sys.exit(main())
