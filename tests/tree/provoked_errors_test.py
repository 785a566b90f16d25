"""Each message of set-up that the sources make, and each line that docs/errors/running.md explains, is provoked by a test, which has words
of it; or it is below, with the reason.

  provoked_errors_test.py ROOT      checks that tree, and that a message without a test is found in a small one
"""

import pathlib
import re
import sys
import tempfile
import unittest

import error_sites

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
RUN = 4  # words in a row, or fewer of so many letters, tell one message from another
LEAST = 12

# What no test can provoke, by words of the message.
NOT_PROVOKED = {
    "OpenSSL refuses": "an OpenSSL that works hashes any file",
    "' has failed": "`ip` and `bridge` do what they are told where namespaces can be made at all",
    "the deployment has no such component": "the deployment itself refuses the name first",
    "Check the installation of OpenSSL 3": "an OpenSSL that works does not fail here",
    "get random bytes for a connection": "the kernel has them soon after it has booted",
    "it has link-local numbers only": "a name service that knows such a host needs root and a network with such a number",
    "the two clocks can be compared to": "a link that is slower than a ttl would have the test wait for seconds",
    "Mesa ": "the Mesa that tests run with can draw",
    "drawing an image without a screen": "it is told around what Mesa cannot do",
}


def code_of(path):
    text = path.read_text(encoding="utf-8")
    return text if path.suffix == ".py" else error_sites.without_comments(text)


def texts_of_tests(root):
    """Returns the texts of all tests but those of the tree, those of a literal in parts put together."""
    files = (path for path in sorted((root / "tests").rglob("*"))
             if path.suffix in (".cpp", ".h", ".py") and path.parent.name not in ("tree", "fuzz"))
    text = "\n".join(code_of(path) for path in files)
    return re.sub(r"([\"'])\s*\n\s*f?\1", "", text).replace('\\"', '"')


def is_in(site, text):
    """Tells if the words of what was found are in the text with others between them, or a run of them is: many errors share a remedy."""
    parts = [re.escape(part) for part in site.words.split(error_sites.ANY)]
    if sum(map(len, parts)) >= error_sites.LEAST and re.search(".{0,60}?".join(filter(None, parts)), text):
        return True
    for part in site.words.split(error_sites.ANY):
        words = part.strip(" .:;,'\"").split()
        runs = (" ".join(words[at:at + RUN]).strip(".:;,") for at in range(max(1, len(words) - RUN + 1)))
        if any(len(run) >= LEAST and run in text for run in runs):
            return True
    return False


def running(root):
    """Yields what the rows of docs/errors/running.md explain, each as a Site."""
    page = root / "docs/errors/running.md"
    for pattern in error_sites.patterns(page.read_text(encoding="utf-8")) if page.exists() else ():
        yield error_sites.Site("docs/errors/running.md", 0, pattern, pattern)


def violations(root, not_provoked):
    text = texts_of_tests(root)
    left = set(not_provoked)
    for site in error_sites.sites(root):
        reasons = {words for words in not_provoked if words in site.whole}
        left -= reasons
        provoked = is_in(site, text)
        if provoked and reasons:
            yield f"{site.file}:{site.line}: a test provokes '{site.words}': remove it from the list"
        elif not provoked and not reasons:
            yield f"{site.file}:{site.line}: no test provokes '{site.words}'"
    for site in running(root):
        if not is_in(site, text):
            yield f"{site.file}: no test provokes '{site.words}'"
    for words in sorted(left):
        yield f"no source says '{words}': remove it from the list"


class Tree(unittest.TestCase):
    def test_each_message_is_provoked(self):
        self.assertEqual([], list(violations(ROOT, NOT_PROVOKED)))


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("runtime/a.cpp", 'throw SetupError("use " + name, "it has " + count + " wheels too few for a cart", "Add some");\n')

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def test_a_message_that_a_test_has(self):
        self.write("tests/unit/a_test.cpp", 'EXPECT_TRUE(contains(error, "3 wheels too "\n    "few for"));\n')
        self.assertEqual([], list(violations(self.root, {})))

    def test_a_message_without_a_test(self):
        self.write("tests/unit/a_test.cpp", 'EXPECT_TRUE(contains(error, "wheels too many"));\n')
        (found,) = violations(self.root, {})
        self.assertIn("runtime/a.cpp:1: no test provokes", found)

    def test_a_row_of_a_running_process_without_a_test(self):
        self.write("tests/unit/a_test.cpp", 'EXPECT_TRUE(contains(error, "3 wheels too few for"));\n')
        self.write("docs/errors/running.md", "| `the cart has ...lost a wheel: ` | x | y |\n")
        (found,) = violations(self.root, {})
        self.assertEqual(found, "docs/errors/running.md: no test provokes 'the cart has ...lost a wheel: '")

    def test_a_remedy_is_not_enough(self):
        self.write("runtime/a.cpp", 'throw SetupError("use it", "it has " + count + " wheels too few", "Add some wheels of that size");\n')
        self.write("tests/unit/a_test.cpp", 'EXPECT_TRUE(contains(error, "Add some wheels of that size"));\n')
        (found,) = violations(self.root, {})
        self.assertIn("no test provokes 'it has ... wheels too few'", found)

    def test_a_list_that_is_too_long(self):
        self.write("tests/unit/a_test.py", 'self.assertIn("wheels too few for", error)\n')
        self.assertEqual(2, len(list(violations(self.root, {"wheels too few": "a cart has four", "no horse": "it has none"}))))


if __name__ == "__main__":
    unittest.main()
