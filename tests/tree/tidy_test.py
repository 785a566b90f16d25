"""A changed header is examined by a source that includes it."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import tidy


class Including(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, path, *includes):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join(f"#include {one}\n" for one in includes), encoding="utf-8")
        return str(file)

    def test_the_source_of_its_own_comes_first(self):
        header = self.write("suture/rt/ring.h")
        other, own = self.write("suture/rt/a.cpp", "<suture/rt/ring.h>"), self.write("suture/rt/ring.cpp", "<suture/rt/ring.h>")
        self.assertEqual(tidy.including(header, [other, own]), own)

    def test_a_source_that_is_examined_anyway_comes_before(self):
        header = self.write("suture/rt/ring.h")
        other, own = self.write("suture/rt/a.cpp", "<suture/rt/ring.h>"), self.write("suture/rt/ring.cpp", "<suture/rt/ring.h>")
        self.assertEqual(tidy.including(header, [other, own], {other}), other)

    def test_a_header_may_lie_between(self):
        header = self.write("suture/rt/ring.h")
        self.write("suture/lane/lane.h", "<suture/rt/ring.h>")
        source = self.write("suture/lane/lane.cpp", "<vector>", "<suture/lane/lane.h>")
        unrelated = self.write("suture/base/string.cpp", '"ring.hpp"')
        self.assertEqual(tidy.including(header, [unrelated, source]), source)

    def test_a_header_that_nothing_includes_has_none(self):
        header = self.write("suture/rt/ring.h")
        self.assertIsNone(tidy.including(header, [self.write("suture/rt/a.cpp", "<suture/rt/string.h>")]))


if __name__ == "__main__":
    unittest.main()
