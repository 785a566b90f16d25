"""Types move between headers of several targets of one project, whose locks are updated one by one.

  moves_test.py --suturec SUTUREC --capnp CAPNP --schemas FOLDER --flags FLAGS
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

GIVEN = argparse.Namespace()

PART = "struct SUTURE_TYPE(%s) Part {\n  double x = 1;\n  Point at;\n  std::optional<double> maybe;\n};\n"
POINT = "struct SUTURE_TYPE() Point {\n  double z = 0;\n};\n"
BLOCK = "struct SUTURE_TYPE() Block {\n  Part part;\n};\n"
BEARER = "struct SUTURE_TYPE() Bearer {\n  Part part;\n  std::optional<Part> spare;\n};\n"


def header(text, *includes):
    included = "".join(f'#include "{one}"\n' for one in includes)
    return f"#pragma once\n#include <suture/annotate.h>\n\n#include <optional>\n\n{included}\nnamespace shop {{\n{text}}}\n"


class Moves(unittest.TestCase):
    """Holds base/base.h, which part/part.h includes, which user/user.h includes: a target each."""

    maxDiff = None

    def setUp(self):
        home = tempfile.TemporaryDirectory()
        self.addCleanup(home.cleanup)
        self.root = pathlib.Path(home.name)
        self.write("base", POINT)
        self.write("part", PART % "" + BLOCK, "base/base.h")
        self.write("user", BEARER, "part/part.h")
        for name in ("base", "part", "user"):
            self.update(name)
        shutil.copytree(self.root / "schemas", self.root / "old")
        self.id = self.id_in("part", "Part")

    def write(self, name, text, *includes):
        path = self.root / name / f"{name}.h"
        path.parent.mkdir(exist_ok=True)
        path.write_text(header(text, *includes))

    def lock(self, name):
        return self.root / "schemas" / name / f"{name}.capnp"

    def id_in(self, name, node):
        found = re.search(rf"^struct {node} (@0x\w+)", self.lock(name).read_text(), re.M)
        return found and found[1]

    def suturec(self, name, *options):
        command = [GIVEN.suturec, "--target-name", name, "--base-dir", ".", "--lock-dir", "schemas", *options,
                   f"{name}/{name}.h", "--", "-I.", *GIVEN.flags]
        done = subprocess.run(command, cwd=self.root, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def update(self, name):
        status, text = self.suturec(name, "--update-lock")
        self.assertEqual(status, 0, text)
        return text

    def told(self, name, *options):
        """Returns what a build of a target says, or a run with other options: each slug once, in order."""
        text = self.suturec(name, *(options or ("--out", "out")))[1]
        return sorted(set(re.findall(r"(?:error|warning): .*\[suture-([a-z-]+)\]", text))), text

    def judge_end(self, names):
        for name in names:
            self.assertEqual(self.told(name)[0], [])
        schemas = sorted(str(one) for one in (self.root / "schemas").rglob("*.capnp"))
        done = subprocess.run([GIVEN.capnp, "compile", "-o-", "-I", str(self.root / "schemas"), "-I", GIVEN.schemas, *schemas],
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        done = subprocess.run([GIVEN.suturec, "diff", "old", "schemas"], cwd=self.root, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_to_a_header_of_a_target_that_the_old_one_uses(self):
        self.write("base", POINT + PART % 'was("shop::Part")')
        self.write("part", BLOCK, "base/base.h")
        slugs, text = self.told("part", "--update-lock")  # too early
        self.assertEqual(slugs, ["lock-moved"])
        self.assertIn("schemas/base/base.capnp does not have it", text)
        self.assertEqual(self.told("base")[0], ["lock-moved", "lock-renamed"])  # its optional has another prefix
        self.update("base")
        slugs, text = self.told("user", "--update-lock")  # too early
        self.assertEqual(slugs, ["lock-moved"])
        self.assertIn("update the lock of the target of part/part.h first", text)
        self.assertEqual(self.told("part")[0], ["lock-moved"])
        self.assertIn("Part moved to /base/base.capnp", self.update("part"))
        self.assertEqual(self.told("user")[0], ["lock-moved"])
        self.update("user")
        self.assertEqual((self.id_in("base", "Part"), self.id_in("part", "Part")), (self.id, None))
        self.judge_end(["base", "part", "user"])

    def test_to_such_a_header_without_a_word(self):
        self.write("base", POINT + PART % "")
        self.write("part", BLOCK, "base/base.h")
        self.assertEqual(self.told("base")[0], ["lock-moved", "lock-new"])
        self.assertIn('say was("shop::Part") on it', self.told("base")[1])
        self.update("base")
        self.assertNotEqual(self.id_in("base", "Part"), self.id)
        slugs, text = self.told("part", "--update-lock")
        self.assertEqual(slugs, ["lock-break", "lock-moved", "wire-name-clash"])
        self.assertIn("restore schemas/base/base.capnp", text)

    def test_to_a_header_of_a_target_that_uses_the_old_one(self):
        self.write("part", "struct SUTURE_TYPE() Block {\n  double weight = 1;\n};\n", "base/base.h")
        self.write("user", PART % "" + BEARER, "part/part.h")
        self.update("part")
        slugs, text = self.told("user")
        self.assertEqual(slugs, ["lock-break", "lock-moved", "lock-new"])
        self.assertIn("declare it in a header that its old one includes", text)

    def test_from_a_header_that_is_gone(self):
        shutil.rmtree(self.root / "part")
        self.write("piece", PART % 'was("shop::Part")' + BLOCK.replace("()", '(was("shop::Block"))'), "base/base.h")
        self.write("user", BEARER, "piece/piece.h")
        self.assertEqual(self.told("piece")[0], ["lock-missing"])
        self.update("piece")
        self.lock("part").unlink()
        self.assertEqual(self.told("user")[0], ["lock-moved"])
        self.update("user")
        self.assertEqual(self.id_in("piece", "Part"), self.id)
        self.judge_end(["base", "piece", "user"])

    def test_with_its_header_and_lock(self):
        shutil.rmtree(self.root / "part")
        self.write("piece", PART % "" + BLOCK, "base/base.h")
        self.write("user", BEARER, "piece/piece.h")
        self.lock("piece").parent.mkdir()
        self.lock("part").rename(self.lock("piece"))
        self.assertEqual(self.told("piece")[0], ["lock-renamed"])
        self.update("piece")
        self.assertEqual(self.told("user")[0], ["lock-moved"])
        self.update("user")
        self.assertEqual(self.id_in("piece", "Part"), self.id)
        self.judge_end(["base", "piece", "user"])


def main():
    parser = argparse.ArgumentParser()
    for name in ("suturec", "capnp", "schemas", "flags"):
        parser.add_argument(f"--{name}", required=True)
    _, rest = parser.parse_known_args(namespace=GIVEN)
    GIVEN.flags = GIVEN.flags.split(";")
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
