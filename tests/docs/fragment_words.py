"""Tells if a program can print a line that a page shows: most pairs of neighbouring words have to stand in a text of the sources."""

import itertools
import re

FOLDERS = ("runtime", "compiler", "components", "examples")
TEXT = re.compile(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+')
DIVIDES = re.compile(r"'[^']*[/:_A-Z]\S*'|\d\S*|[.:;,!?/]+|%\S+|\\n")


def pairs(text):
    """Returns each two words that no number, name in quotes or sign stands between."""
    words = [re.findall(r"[A-Za-z][a-z']*", part) for part in DIVIDES.split(text)]
    return {pair for part in words for pair in itertools.pairwise(part)}


def told_by(root):
    """Returns the pairs of words in all texts of the sources."""
    found = set()
    for folder in FOLDERS:
        for file in (root / folder).rglob("*.*"):
            if file.suffix in (".h", ".cpp"):
                for text in TEXT.findall(file.read_text(encoding="utf-8")):
                    found |= pairs("".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', text)))
    return found


def untold(text, known):
    """Returns the first line most of whose pairs of words are not known; None if there is none."""
    return next((line for line in text.split("\n") if 2 * len(pairs(line) - known) > len(pairs(line))), None)
