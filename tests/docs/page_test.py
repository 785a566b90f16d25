"""Does what pages of docs say, block after block, as a reader would: page_test.py --package P --scratch S PAGE...

The pages are done in this order in one project, which is S/lab.
"""

import argparse
import pathlib
import sys
import time

from page import PageError, blocks_of, contains
from project import Project

PATIENCE = 60  # s; only so that a hang ends the test


class Reader:
    """Does one block after the other, and remembers what an output block behind it speaks of."""

    def __init__(self, project, patience):
        self._project = project
        self._patience = patience
        self._said = ""
        self._running = None  # the process of the start block before this one

    def do(self, block):
        block.text = self._project.with_free_ports(block.text)
        if block.directive != "shown":
            getattr(self, block.directive)(block)

    def file(self, block):
        self._project.write(block.value, block.text)

    def append(self, block):
        self._project.write(block.value, block.text, "a")

    def insert(self, block):
        self._project.insert(block.value, block.text, block.words["behind"])

    def run(self, block):
        self._running = None
        status, self._said = self._project.run(block.text)
        crashed = status is None or status < 0 or status > 128
        if crashed or (status != 0) != ("fails" in block.words):
            raise PageError(f"it ended with status {status} and said:\n{self._said}")

    def start(self, block):
        self._running = self._project.start(block.value, block.text)
        ready = self._project.with_free_ports(block.words.get("ready", ""))
        if not self._running.says(lambda said: ready in said, self._patience):
            raise PageError(f"'{block.value}' does not say '{ready}'; it said:\n{self._running.said}")

    def stop(self, block):
        self._running = None
        self._said = self._project.stop(block.value).said

    def output(self, block):
        """Compares with what was said by now, or with what a process that still runs says soon."""
        said = self._said
        process = self._project.process(block.value) if block.value else self._running
        if process:
            process.says(lambda said: contains(said, block.text), self._patience)
            said = process.said
        if not contains(said, block.text):
            raise PageError(f"the output is not as the page says; it is:\n{said}")


def problems_of(page, project, patience):
    """Returns what is wrong with the page, and leaves nothing running behind it."""
    reader = Reader(project, patience)
    problems = []
    try:
        for block in blocks_of(page):
            began = time.monotonic()
            try:
                reader.do(block)
            except PageError as problem:
                raise PageError(f"{block.where}: {problem}") from problem
            print(f"ok: {block.where} {block.directive} {block.value}, {time.monotonic() - began:.1f} s", flush=True)
    except PageError as problem:
        problems.append(str(problem))
    return problems + [f"{page.name}: {problem}" for problem in project.stop_all()]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--package", type=pathlib.Path, required=True, help="where Suture is installed")
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    parser.add_argument("--patience", type=float, default=PATIENCE, help="seconds to wait for what a process is to say")
    arguments = parser.parse_args()
    project = Project(arguments.scratch / "lab", arguments.package, arguments.patience)
    try:
        for page in arguments.pages:
            problems = problems_of(page, project, arguments.patience)
            if problems:
                sys.exit("\n".join(f"FAILED: {problem}" for problem in problems))
    finally:
        project.close()


if __name__ == "__main__":
    main()
