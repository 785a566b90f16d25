"""Each fenced block of a page that no reader's project runs is judged: fragments_test.py ROOT BUILD SCRATCH

The word behind its language says how; README.md has them. Each block in planted_fragments/ has a fault, which has to be reported in the
words that stand above the block.
"""

import dataclasses
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import fragment_code
import fragment_words
import page
from fragment_code import AROUND, Fault
from fragment_commands import Commands

ROOT, BUILD, SCRATCH = (pathlib.Path(one).resolve() for one in sys.argv[1:4])
PLANTED = pathlib.Path(__file__).resolve().parent / "planted_fragments"
WORDS = {"cpp": ("in",), "json": ("in",), "sh": ("checked",), "console": ("checked",), "cmake": ("checked",), "text": ("told", "shown")}
# Other tests run, make or plant these.
ELSEWHERE = ("docs/tutorial/", "docs/howto/", "docs/adding/", "docs/diagnostics/", "generated/", "tests/docs/planted")
LIMIT = 60  # s; only so that a hang ends the test


def pages():
    folders = [folder for folder in ROOT.iterdir() if folder.is_dir() and folder.name != "build" and not folder.name.startswith(".")]
    for file in sorted([*ROOT.glob("*.md"), *(file for folder in folders for file in folder.rglob("*.md"))]):
        if not str(file.relative_to(ROOT)).startswith(ELSEWHERE) and not file.name.endswith(".suture.md"):
            yield file


def blocks_of(files):
    """Returns the blocks of these pages, which are known by their paths."""
    blocks = []
    for file in files:
        for block in page.read(file):
            blocks.append(dataclasses.replace(block, where=f"{file.relative_to(ROOT)}:{block.where.rpartition(':')[2]}"))
    return blocks


def is_known(block):
    return len(block.words) == 1 and next(iter(block.words)) in WORDS.get(block.language, ())


class Judge:
    def __init__(self, scratch):
        shutil.rmtree(scratch, ignore_errors=True)
        (scratch / "faults").mkdir(parents=True)  # a black box writes there
        self._scratch = scratch
        self._commands = Commands(ROOT, BUILD, scratch)
        self._known = None

    def faults(self, files):
        """Returns what is wrong with the blocks of these pages."""
        blocks = blocks_of(files)
        faults = []
        for block in blocks:
            try:
                self._judge(block)
            except Fault as fault:
                faults.append(f"{block.where}: {fault}")
        code = [block for block in blocks if is_known(block) and block.language == "cpp"]
        if code:
            faults.extend(fragment_code.faults_of(code, ROOT, BUILD / "bin/suturec", self._scratch))
        return faults

    def _judge(self, block):
        if not is_known(block):
            raise Fault(f"nothing judges this block; after the language say one of {WORDS.get(block.language, WORDS)}")
        if block.language == "json":
            self._read(block)
        elif block.language == "sh":
            self._commands.judge(block.text)
        elif block.language == "console":
            for line in re.findall(r"^\$ (.*)", block.text, re.M):
                self._commands.judge(line)
        elif block.language == "cmake":
            self._commands.judge_cmake_file(block.text)
        elif "told" in block.words:
            self._known = self._known or fragment_words.told_by(ROOT)
            if line := fragment_words.untold(block.text, self._known):
                raise Fault(f"no text of the sources says: {line.strip()}")
        elif "shown" in block.words and block.text.count("\n") > page.MOST_SHOWN:
            raise Fault(f"only {page.MOST_SHOWN} lines may be shown that nothing judges")

    def _read(self, block):
        """Has the reader of deployments read the block in what around/NAME.json.in puts around it."""
        around = AROUND / f"{block.words['in']}.json.in"
        if not around.exists():
            raise Fault(f"there is no around/{around.name}")
        if not (self._scratch / "keys").exists():
            subprocess.run([BUILD / "bin/suture", "keys", "--process", "robot", "--out", self._scratch / "keys"],
                           capture_output=True, check=True, timeout=LIMIT)
        text = re.sub(r",\s*\.\.\.", "", block.text)
        (self._scratch / "block.json").write_text(text, encoding="utf-8")
        whole = self._scratch / "whole.json"
        whole.write_text(around.read_text(encoding="utf-8").replace("@BLOCK@", text.rstrip("\n")), encoding="utf-8")
        done = subprocess.run([BUILD / "bin/suture-workstation", "--deployment", whole, "--check"], capture_output=True, text=True,
                              check=False, timeout=LIMIT, cwd=self._scratch)
        if done.returncode != 0:
            raise Fault(done.stderr.strip())


class Fragments(unittest.TestCase):
    maxDiff = None

    def test_each_block_is_as_the_sources_have_it(self):
        self.assertEqual("\n".join(Judge(SCRATCH / "pages").faults(pages())), "")

    def test_what_stands_around_is_used(self):
        used = {f"{block.words['in']}.{block.language}.in" for block in blocks_of(pages()) if "in" in block.words}
        self.assertEqual({file.name for file in AROUND.glob("*.in")}, used | {"prelude.cpp.in"})

    def test_each_planted_fault_is_reported(self):
        planted = sorted(PLANTED.glob("*.md"))
        self.assertGreater(len(planted), 5)
        for file in planted:
            faults = "\n".join(Judge(SCRATCH / file.stem).faults([file]))
            for words, _ in re.findall(r"^(.+)\n\n```(.+)$", file.read_text(encoding="utf-8"), re.M):
                with self.subTest(file.name, words=words):
                    self.assertIn(words, re.sub("[\u2018\u2019]", "'", faults))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
