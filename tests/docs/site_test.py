"""The site can be made, without a warning, and each of its links leads somewhere: site_test.py SOURCE SCRATCH"""

import pathlib
import sys
import tempfile
import unittest

SOURCE, SCRATCH = (pathlib.Path(argument) for argument in sys.argv[1:3])
del sys.argv[1:3]
sys.path.insert(0, str(SOURCE / "docs/site"))
import build  # noqa: E402


class Site(unittest.TestCase):
    def test_it_has_each_header_that_a_page_includes(self):
        pages = [page for folder in (".", "tutorial", "howto") for page in sorted((SOURCE / "docs" / folder).glob("*.md"))]
        text = (SOURCE / "docs/site/Doxyfile").read_text(encoding="utf-8")
        self.assertEqual(list(build.missing_headers(pages, text)), [])

    def test_nothing_is_wrong_with_it(self):
        self.assertEqual(build.build(SCRATCH), [])

    def test_a_planted_link_to_nowhere_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.html"
            page.write_text('<a href="page.html#top">here</a> <a href="https://host/none">away</a> <img src="none.png">')
            self.assertEqual(list(build.broken_links(page.parent)), ["page.html leads to none.png, which is not there"])


if __name__ == "__main__":
    unittest.main()
