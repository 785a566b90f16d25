"""Takes random headers through suturec, Cap'n Proto and two compilers, and values through what they give.

  random_headers_test.py --suture BUILD [--seed N] [--headers N] [--batch N] [--keep DIR]

Each header has a seed of its own. One that fails is made smaller and printed; --seed N --headers 1 repeats it.
"""

import argparse
import pathlib
import random
import shutil
import sys
import tempfile

from random_header import Header
from reduce import reduced
from tools import Tools

LENGTH = 4000  # of a tool's message: what matters stands at its beginning


def suspects(headers, failure):
    """Returns the headers that the tool's message names, all if it names none."""
    named = [header for header in headers if f"{header.name}." in failure.text or f"{header.name}::" in failure.text]
    return named or headers


def report(tools, header, failure, folder):
    """Returns what to tell of a header that fails alone."""
    small = reduced(header, lambda smaller: failure.is_like(tools.failure_of([smaller], folder, failure.stage)))
    again = tools.failure_of([small], folder, failure.stage) or failure
    return f"seed {header.name[1:]}: {failure}\nThe smallest header that fails so:\n\n{small.header()}\n{again.text[:LENGTH]}"


def failing(tools, headers, folder, tell):
    """Returns the headers of a batch that fail, and tells of each; all of them if they fail together only."""
    failure = tools.failure_of(headers, folder)
    if failure is None:
        return []
    found = []
    for header in suspects(headers, failure):
        alone = tools.failure_of([header], folder)
        if alone is not None:
            tell(report(tools, header, alone, folder))
            found.append(header)
    if not found:
        tell(f"None of {', '.join(header.name for header in headers)} fails alone, but together: {failure}\n{failure.text[:LENGTH]}")
        return headers
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suture", type=pathlib.Path, required=True, help="build folder of Suture")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 30), help="that of the first header")
    parser.add_argument("--headers", type=int, default=20)
    parser.add_argument("--batch", type=int, default=20, help="so many headers are compiled at once")
    parser.add_argument("--keep", type=pathlib.Path, help="write the last batch here and leave it")
    options = parser.parse_args()
    tools = Tools(options.suture.resolve())
    folder = options.keep or pathlib.Path(tempfile.mkdtemp(prefix="random_", dir=options.suture))
    failed = []
    try:
        for first in range(options.seed, options.seed + options.headers, options.batch):
            seeds = range(first, min(first + options.batch, options.seed + options.headers))
            print(f"seeds {seeds[0]} to {seeds[-1]}", flush=True)
            failed += failing(tools, [Header(seed) for seed in seeds], folder / "headers", lambda text: print(text, flush=True))
    finally:
        if options.keep is None:
            shutil.rmtree(folder, ignore_errors=True)
    for header in failed:
        print(f"{header.name} failed; again: python3 {sys.argv[0]} --suture {options.suture} --headers 1 --seed {header.name[1:]}")
    print(f"{options.headers} headers, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
