"""Runs suturec on headers, and compilers on what it writes.

  TEST SUTUREC COMPILERS CAPNP PLUGIN SCHEMAS FLAG...    COMPILERS are separated by semicolons
"""

import pathlib
import subprocess
import sys
import tempfile

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-fsyntax-only"]


def run(folder, *command):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return [] if done.returncode == 0 else [f"{' '.join(command)}\n{done.stdout}{done.stderr}"]


def main(headers):
    """Takes the texts of headers by their names; one may include what is generated for those before it."""
    suturec, compilers, capnp, plugin, schemas, *flags = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in headers.items():
            pathlib.Path(folder, name).write_text(text, encoding="utf-8")
        pathlib.Path(folder, "wire").mkdir()  # Its headers are a system's, whose warnings nobody reads.
        locks = [name.replace(".h", ".capnp") for name in headers]
        problems = []
        for action in (["--update-lock"], ["--out", ".", "--components-file", "components.cpp"]):
            problems = problems or run(folder, suturec, *action, "--lock-dir", ".", *headers, "--", "-I.", *flags)
        problems = problems or run(folder, capnp, "compile", f"-I{schemas}", "-I.", f"-o{plugin}:wire", *locks)
        sources = sorted(path.name for path in pathlib.Path(folder).glob("*.cpp"))
        pathlib.Path(folder, "all.cc").write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
        for compiler in compilers.split(";") if not problems else []:
            problems += run(folder, compiler, *STRICT, "-I.", "-isystem", "wire", *flags, "all.cc")
    print("\n".join(problems) or f"{len(sources)} files compile")
    return 1 if problems else 0
