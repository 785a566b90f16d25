"""Reads a page as its fenced blocks: what each one says in its info string is to be done with it."""

import dataclasses
import pathlib
import re
import shlex

FENCE = re.compile(r"^( *)(`{3,})(.*)$")
DIRECTIVES = ("file", "append", "insert", "run", "start", "stop", "output", "shown")
OPTIONS = {"start": "ready", "run": "fails", "insert": "behind"}
MOST_SHOWN = 12  # lines


class PageError(Exception):
    """Says what is wrong with a page, and in which line."""


@dataclasses.dataclass
class Block:
    where: str  # "page.md:12"
    language: str
    words: dict  # {"start": "gripper", "ready": "at work"}
    text: str

    @property
    def directive(self):
        return next((word for word in self.words if word in DIRECTIVES), None)

    @property
    def value(self):
        return self.words[self.directive]


def blocks_of(page):
    """Returns the blocks of a page, sound as far as can be told without running them."""
    blocks = list(read(page))
    problems = [problem for before, block in zip([None, *blocks], blocks) for problem in judge(block, before)]
    for block, after in zip(blocks, [*blocks[1:], None]):
        if block.directive == "start" and "ready" not in block.words and (after is None or after.directive != "output"):
            problems.append(f"{block.where}: nobody knows when '{block.value}' is ready; add ready=TEXT, or an output block")
    if problems:
        raise PageError("\n".join(problems))
    return blocks


def read(page):
    lines = iter(enumerate(page.read_text(encoding="utf-8").split("\n"), 1))
    for number, line in lines:
        opening = FENCE.match(line)
        if not opening:
            continue
        indent, fence, info = opening.groups()
        text = []
        for _, inner in lines:
            if inner.strip() == fence:
                break
            text.append(inner.removeprefix(indent) + "\n")
        else:
            raise PageError(f"{page.name}:{number}: this block has no end")
        language, *words = shlex.split(info) or [""]
        yield Block(f"{page.name}:{number}", language, {w.partition("=")[0]: w.partition("=")[2] for w in words}, "".join(text))


def judge(block, before):
    """Says what is wrong with a block that stands behind the other."""
    directives = [word for word in block.words if word in DIRECTIVES]
    if len(directives) != 1:
        yield f"{block.where}: this block has to say one of {', '.join(DIRECTIVES)}"
        return
    directive = directives[0]
    for word in block.words.keys() - {directive, OPTIONS.get(directive)}:
        yield f"{block.where}: '{word}' means nothing beside '{directive}'"
    if directive in ("file", "append", "insert", "start", "stop") and not block.value:
        yield f"{block.where}: write {directive}=NAME"
    if directive == "insert" and not block.words.get("behind"):
        yield f"{block.where}: say behind which line, behind=TEXT"
    if directive in ("file", "append", "insert") and not is_inside(block.value):
        yield f"{block.where}: '{block.value}' lies outside of the project"
    if directive in ("run", "start", "stop") and block.language != "sh":
        yield f"{block.where}: only sh can {directive}"
    if directive == "output" and not block.value and (before is None or before.directive not in ("run", "start", "stop")):
        yield f"{block.where}: nothing runs directly before this output"
    if directive == "shown" and (block.text.count("\n") > MOST_SHOWN or "#include" in block.text):
        yield f"{block.where}: only a fragment may be shown without running it: {MOST_SHOWN} lines, no #include"


def is_inside(file):
    path = pathlib.PurePosixPath(file)
    return not path.is_absolute() and ".." not in path.parts


def contains(said, expected):
    """Returns true if these lines were said, one directly after the other; "..." stands for anything in a line, or for any lines."""
    pattern = "^"
    for line in expected.rstrip("\n").split("\n"):
        if line.strip() == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += ".*".join(re.escape(part) for part in line.rstrip().split("...")) + r"[ \r]*\n"
    return re.search(pattern, said if said.endswith("\n") else said + "\n", re.M) is not None
