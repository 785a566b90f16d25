"""Runs clang-tidy on sources, by the commands of a unity build.

  tidy.py BUILD < FILES      on the sources named on standard input, and for each header on a source that includes it
  tidy.py BUILD --all        on all that is built, as it is built: many sources in one unit have their headers read once

A unity build's list of commands knows the files that include the sources, and not the sources: each gets the command of the file
that includes it. A source that the build does not compile has no command, and is left out.
"""

import json
import multiprocessing.pool
import os
import pathlib
import re
import subprocess
import sys

TOOL = "clang-tidy-19"
# The root CMakeLists.txt has clang include this before anything else, and so must clang-tidy.
FIRST = pathlib.Path(__file__).parents[2] / "runtime/suture/loop/kj_comparisons.h"
FINDING = re.compile(r": (?:warning|error): ")
INCLUDED = re.compile(r'^#include "(.+)"$', re.M)
INCLUDE = re.compile(r'^#include [<"](.+)[>"]$', re.M)


def units(build):
    """Returns the command of each file that the build compiles."""
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    # Some warnings of g++ are errors for clang. Only findings count here, since a build shows the warnings.
    return [{**entry, "command": entry["command"].replace(" -Werror", "")} for entry in entries
            if not entry["file"].endswith(".capnp.c++")]


def commands(build):
    """Returns the command of each source."""
    result = {}
    for entry in units(build):
        file = pathlib.Path(entry["file"])
        sources = [str(file)]
        if file.parent.name == "Unity":
            sources = INCLUDED.findall(file.read_text(encoding="utf-8"))
        for source in sources:
            command = entry["command"].replace(str(file), source)
            # The first is the library's own: tests compile some sources once more, with other definitions.
            result.setdefault(source, {**entry, "file": source, "command": command})
    return result


def including(header, sources, preferred=()):
    """Returns one of the sources that include a header, by other headers if need be; None if none does. One of the preferred if it can be."""
    texts = {source: INCLUDE.findall(pathlib.Path(source).read_text(encoding="utf-8")) for source in sources if pathlib.Path(source).exists()}
    headers = {}  # the includes of each header of the folders where a source lies
    for folder in {pathlib.Path(source).parent for source in texts}:
        for path in folder.glob("*.h"):
            headers[str(path)] = INCLUDE.findall(path.read_text(encoding="utf-8"))
    reached, added = {header}, {header}
    while added:
        has = lambda includes: any(str(one).endswith("/" + include) for include in includes for one in added)
        found = [source for source in texts if has(texts[source])]
        if found:
            own = str(pathlib.Path(header).with_suffix(".cpp"))
            return min(found, key=lambda source: (source not in preferred, source != own, source))
        added = {path for path in headers if path not in reached and has(headers[path])}
        reached |= added
    return None


def examine(job):
    database, source, options = job
    result = subprocess.run([TOOL, "--quiet", f"--extra-arg-before=-include{FIRST}", *options, "-p", database, source], capture_output=True, text=True)
    return result.returncode, [line for line in result.stdout.splitlines() if FINDING.search(line)] or [result.stderr]


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    options = []
    if "--all" in sys.argv:
        examined = units(build)
        options = ["--checks=-bugprone-suspicious-include"]  # a unit includes sources
    else:
        known = commands(build)
        wanted = [str(pathlib.Path(line).resolve()) for line in sys.stdin.read().split()]
        chosen = {source for source in wanted if source in known}
        for header in wanted:
            if header.endswith(".h"):
                chosen |= {including(header, known, chosen)} - {None}
        examined = [known[source] for source in sorted(chosen)]
    database = build / "tidy"
    database.mkdir(exist_ok=True)
    (database / "compile_commands.json").write_text(json.dumps(examined), encoding="utf-8")
    bad, told = 0, set()
    with multiprocessing.pool.ThreadPool(os.cpu_count()) as pool:
        for status, lines in pool.imap_unordered(examine, [(database, entry["file"], options) for entry in examined]):
            bad += status != 0
            for line in lines if status != 0 else []:
                if line not in told:  # a header's finding comes with each source that includes it
                    told.add(line)
                    print(line, flush=True)
    print(f"{TOOL}: {len(examined)} examined, {bad} with findings.")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
