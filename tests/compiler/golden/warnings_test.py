"""What suturec has written compiles without a warning, headers and sources.

  warnings_test.py COMPILER ROOT FLAG...    every generated ROOT/**/*.cpp, as one translation unit
"""

import os
import pathlib
import subprocess
import sys
import tempfile

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-c", "-o", "unit.o", "unit.cpp"]
LOSSY = "int planted(double value);\nint planted(double value) { return value; }\n"
LAUNCHER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")


def compiles(compiler, flags, text):
    """Compiles in the working folder, so that a launcher that remembers what it has compiled takes paths below it for equal."""
    with tempfile.TemporaryDirectory(dir=".") as folder:
        pathlib.Path(folder, "unit.cpp").write_text(text, encoding="utf-8")
        done = subprocess.run([*filter(None, [LAUNCHER]), compiler, *flags, *STRICT], cwd=folder, check=False)
    return done.returncode == 0


def main():
    compiler, root, *flags = sys.argv[1:]
    sources = sorted([*pathlib.Path(root).rglob("*.suture.cpp"), *pathlib.Path(root).rglob("*.wire.cpp")])
    assert sources, f"nothing below {root}"
    assert not compiles(compiler, flags, LOSSY), "a conversion that loses was not refused (the message above is expected)"
    text = "".join(f'#include "{source.relative_to(root)}"\n' for source in sources)
    if not compiles(compiler, [f"-I{root}", *flags], text):
        return f"{compiler} has something to say about {root}"
    print(f"{len(sources)} files without a warning")
    return 0


if __name__ == "__main__":
    sys.exit(main())
