"""Each tool says of each edit of the table what the table says.

  verdicts_test.py --suturec SUTUREC --capnp CAPNP --schemas FOLDER --page EVOLUTION_MD --flags FLAGS

All edits are judged in a few runs, each in headers of its own: what suturec prints names the folder of its edit.
"""

import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from breaking import BREAKING, GONE, IMPOSSIBLE
from compatible import COMPATIBLE
from edit import BREAKS, FINE, NOTHING, REFUSES
from write import write_alone

BROKEN = BREAKING + GONE
POSSIBLE = COMPATIBLE + BROKEN
EDITS = POSSIBLE + IMPOSSIBLE
GIVEN = argparse.Namespace()

LABELS = {"fine:": FINE, "refuses:": REFUSES, "breaks:": BREAKS}
ORDER = [NOTHING, FINE, REFUSES, BREAKS]


def suturec(folder, headers, *options):
    names = [str(one.relative_to(folder)) for one in headers]
    command = [GIVEN.suturec, "--target-name", "edits", "--base-dir", ".", "--lock-dir", "schemas", *options, *names, "--",
               "-I.", "-ferror-limit=0", *GIVEN.flags]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def slugs(text):
    """Returns for each edit the slugs that suturec printed for its headers or its lock."""
    found = collections.defaultdict(set)
    for place, slug in re.findall(r"^(?:error: )?(?:schemas/)?(\w+)/\w+\.\w+[:\d]*: .*\[suture-([a-z-]+)\]$", text, re.M):
        found[place].add(slug)
    return found


def told(text):
    """Returns for each file the lines that suturec printed below its name, none for a file without lines."""
    found, lines = collections.defaultdict(list), []
    for line in text.splitlines():
        if line.startswith("  "):
            lines.append(line.removeprefix("  "))
        else:
            lines = found[line.removeprefix("updated schemas/")]
    return {name: lines for name, lines in found.items() if lines}


def write_all(folder, edits, version):
    return [header for edit in edits for header in write_alone(folder, edit, getattr(edit, version))]


class Versions:
    """Holds the old locks of all edits, and their new headers beside them."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.lock(write_all(self.folder, EDITS, "old"))
        shutil.copytree(self.folder / "schemas", self.folder / "old")
        between = [edit for edit in EDITS if edit.between]
        self.lock(write_all(self.folder, between, "between"))
        self.headers = {edit.stem: write_alone(self.folder, edit, edit.new) for edit in EDITS}

    def lock(self, headers):
        status, text = suturec(self.folder, headers, "--update-lock")
        assert status == 0, text

    def of(self, edits):
        return [header for edit in edits for header in self.headers[edit.stem]]


class Verdicts(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.versions = Versions(cls.home.name)
        cls.folder = cls.versions.folder
        cls.built = cls.slugs_of(POSSIBLE, "--out", "out")
        cls.updated = cls.slugs_of(BROKEN, "--update-lock")
        cls.refused = collections.defaultdict(set)
        for edit in IMPOSSIBLE:  # each alone, since some of them end a run before the locks are looked at
            cls.built |= cls.slugs_of([edit], "--out", "out")
            cls.updated |= cls.slugs_of([edit], "--update-lock")
            cls.refused |= cls.slugs_of([edit], "--update-lock", "--accept-break")
        cls.taken = cls.run_suturec(COMPATIBLE, "--update-lock")
        cls.accepted = cls.run_suturec(BROKEN, "--update-lock", "--accept-break")
        cls.after = cls.run_suturec(POSSIBLE, "--out", "out")

    @classmethod
    def run_suturec(cls, edits, *options):
        return suturec(cls.folder, cls.versions.of(edits), *options)

    @classmethod
    def slugs_of(cls, edits, *options):
        return slugs(cls.run_suturec(edits, *options)[1])

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    def each(self, judge):
        for edit in EDITS:
            with self.subTest(edit.name):
                judge(edit)

    def test_a_plain_build(self):
        self.each(lambda edit: self.assertEqual(self.built[edit.stem], set(edit.build.split())))

    def test_an_update_of_the_lock(self):
        self.assertEqual(self.taken[0], 0, self.taken[1])
        self.each(lambda edit: self.assertEqual(self.updated[edit.stem], set(edit.update.split())))

    def test_an_update_that_accepts_breaks(self):
        self.assertEqual(self.accepted[0], 0, self.accepted[1])
        self.each(lambda edit: self.assertEqual(self.refused[edit.stem], set(edit.accept.split())))

    def test_written_locks_have_no_fault(self):
        self.assertEqual((self.after[0], slugs(self.after[1])), (0, {}), self.after[1])

    def test_written_locks_are_schemas(self):
        schemas = sorted(str(one) for one in (self.folder / "schemas").rglob("*.capnp"))
        done = subprocess.run([GIVEN.capnp, "compile", "-o-", "-I", str(self.folder / "schemas"), "-I", GIVEN.schemas, *schemas],
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr.decode())

    def diff(self, name):
        """Returns what diff says of two files or folders."""
        done = subprocess.run([GIVEN.suturec, "diff", f"old/{name}", f"schemas/{name}"], cwd=self.folder,
                              capture_output=True, text=True)
        return done.stdout

    def diffs(self):
        """Returns what diff says of the two folders: the lines of each file of an edit, by the edit's folder."""
        found = collections.defaultdict(dict)
        for path, lines in told(self.diff("")).items():
            stem, name = path.split("/")
            found[stem][name] = lines
        return found

    def test_what_diff_says_of_folders(self):
        found = self.diffs()
        self.each(lambda edit: self.judge_diff(edit, [line for lines in found[edit.stem].values() for line in lines]))

    def test_what_diff_says_of_files(self):
        for edit in EDITS:
            if edit.old.elsewhere or edit.new.elsewhere:  # a file does not say what moved into it
                continue
            with self.subTest(edit.name):
                self.judge_diff(edit, self.diff(f"{edit.stem}/contract.capnp").splitlines())

    def judge_diff(self, edit, lines):
        said = [LABELS[line.split()[0]] for line in lines if line.split()[0] in LABELS]
        self.assertEqual(max(said, key=ORDER.index, default=NOTHING), edit.diff, lines)

    def test_an_update_prints_what_diff_says(self):
        printed, found = told(self.taken[1]) | told(self.accepted[1]), self.diffs()
        for edit in POSSIBLE:
            if edit.between:  # two updates in one diff
                continue
            with self.subTest(edit.name):
                lines = {path.split("/")[1]: lines for path, lines in printed.items() if path.split("/")[0] == edit.stem}
                self.assertEqual(lines, found[edit.stem])

    def test_the_page_has_a_row_for_each(self):
        rows = re.findall(r"^\| ([^|]+) \|", pathlib.Path(GIVEN.page).read_text(encoding="utf-8"), re.M)
        self.each(lambda edit: self.assertIn(edit.page, rows))


def main():
    parser = argparse.ArgumentParser()
    for name in ("suturec", "capnp", "schemas", "page", "flags"):
        parser.add_argument(f"--{name}", required=True)
    _, rest = parser.parse_known_args(namespace=GIVEN)
    GIVEN.flags = GIVEN.flags.split(";")
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
