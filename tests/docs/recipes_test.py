"""Follows the recipes of docs/adding, one after the other, in a copy of the tree.

  recipes_test.py ROOT SCRATCH            makes their files, and checks that the copy keeps the tree's rules
  recipes_test.py ROOT SCRATCH --build    does what they run, too: the copy is built as far as they need it
"""

import pathlib
import shutil
import subprocess
import sys

from page import PageError, blocks_of
from page_test import PATIENCE, Reader
from project import Project

LIMIT = 1800  # s for what a block builds; only so that a hang ends the test
NOT_COPIED = (".git", "build", "__pycache__")


def copy(root, tree):
    shutil.rmtree(tree, ignore_errors=True)
    shutil.copytree(root, tree, ignore=shutil.ignore_patterns(*NOT_COPIED), symlinks=True)


def require_named(block, lines):
    """A reader of the page does not see what the block's first line says, so the line before it has the path."""
    number = int(block.where.rpartition(":")[2])
    if f"`{block.value}`" not in "".join(lines[number - 3:number - 1]):
        raise PageError(f"{block.where}: name `{block.value}` before this block")


def follow(page, project, builds):
    """Does the blocks of a recipe; those that run something only if it `builds`."""
    reader = Reader(project, PATIENCE)
    lines = page.read_text(encoding="utf-8").splitlines()
    for block in blocks_of(page):
        if block.directive in ("file", "insert"):
            require_named(block, lines)
        if block.directive in ("run", "output") and not builds:
            continue
        try:
            reader.do(block)
        except PageError as problem:
            raise PageError(f"{block.where}: {problem}") from problem
        print(f"ok: {block.where} {block.directive} {block.value}", flush=True)


def main():
    root, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    builds = "--build" in sys.argv[3:]
    tree = scratch / "tree"
    project = Project(tree, scratch / "no-package", PATIENCE, LIMIT)
    try:
        copy(root, tree)
        pages = sorted(path for path in (root / "docs/adding").glob("*.md") if path.name != "README.md")
        for page in pages:
            follow(page, project, builds)
        kept = subprocess.run([sys.executable, tree / "tests/tree/rules.py", tree], capture_output=True, text=True, check=False)
        if kept.returncode != 0:
            sys.exit(f"FAILED: the copy does not keep the rules:\n{kept.stdout}{kept.stderr}")
    except PageError as problem:
        sys.exit(f"FAILED: {problem}")
    finally:
        project.close()


if __name__ == "__main__":
    main()
