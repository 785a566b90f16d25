"""An editor that asks clangd about annotated headers is told what is wrong with them, and what they say of themselves.

  clangd_test.py --clangd PROGRAM --suture BUILD --scratch S
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from language_server import LanguageServer

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[2] / "docs/howto/editor.md"
parser = argparse.ArgumentParser()
parser.add_argument("--clangd", required=True)
parser.add_argument("--suture", type=pathlib.Path, required=True)
parser.add_argument("--scratch", type=pathlib.Path, required=True)
OPTIONS = parser.parse_args()


def setUpModule():
    """Makes the project as its first build does, up to suturec: what is compiled behind that tells an editor nothing."""
    shutil.rmtree(OPTIONS.scratch, ignore_errors=True)
    shutil.copytree(HERE / "project", OPTIONS.scratch)
    shown = re.search(r"```yaml shown\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    (OPTIONS.scratch / ".clangd").write_text(shown[1], encoding="utf-8")
    build = OPTIONS.scratch / "build"
    for command in (["cmake", "-S", OPTIONS.scratch, "-B", build, "-G", "Ninja", f"-DSuture_DIR={OPTIONS.suture}"],
                    ["cmake", "--build", build, "--target", "update-lock"], ["cmake", "--build", build, "--target", "hand_suture"]):
        subprocess.run([str(part) for part in command], check=True)


class Editor(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clangd = LanguageServer(OPTIONS.clangd, OPTIONS.scratch / "build", OPTIONS.scratch / "clangd.log")
        cls.addClassCleanup(cls.clangd.end)

    def opened(self, name, sound="", faulty=""):
        """Opens a header, with a fault in it where one is given. Returns its path, the fault's line and the diagnostics."""
        file = OPTIONS.scratch / name
        text = file.read_text(encoding="utf-8")
        self.assertIn(sound, text)
        found = self.clangd.diagnostics(file, text.replace(sound, faulty) if sound else text)
        self.addCleanup(self.clangd.close, file)
        return file, text.partition(sound)[0].count("\n") + 1 if sound else 0, found

    def test_a_sound_contract_has_no_diagnostics_and_shows_its_comments_and_types(self):
        file, _, found = self.opened("gripper.h")
        self.assertEqual([], found)
        shown = self.clangd.hover(file, "move(")
        self.assertIn("Moves the fingers there.", shown)
        self.assertIn("virtual void move(const Opening& goal) = 0", shown)
        self.assertIn("How far the fingers are apart.", self.clangd.hover(file, "Opening& goal"))

    def test_a_sound_component_has_no_diagnostics(self):
        file, _, found = self.opened("hand.h")
        self.assertEqual([], found)
        self.assertIn("provided by \"gripper.h\"", self.clangd.hover(file, "Gripper {"))

    def test_a_fault_of_the_code_is_told_where_it_stands(self):
        _, line, found = self.opened("hand.h", "void move(const Opening& goal) override", "void move(Opening goal) override")
        self.assertTrue(any(at == line and "override" in message for at, message in found), found)

    def test_a_fault_of_an_annotation_is_told_where_it_stands(self):
        _, line, found = self.opened("gripper.h", "range(0, 0.1)", "rang(0, 0.1)")
        self.assertEqual([line], [at for at, _ in found], found)
        self.assertIn("did you mean 'range'", found[0][1])



if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
