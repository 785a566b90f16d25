"""docs/errors has what a user can meet: for each enumerator of suture::Errc one page, and one row in the README's table,
both with the text of toString(). Its pages on set-up have a row for each message that the sources make, and no other. Each
line that a source prints on standard error has a row there or on the page on what a running process says, which has no row for
a line that no source has.

  error_pages_test.py ROOT      checks that tree, and that violations planted in a small one are found
"""

import pathlib
import re
import sys
import tempfile
import unittest

import error_sites

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
MAX_LINES = 40
SET_UP = "set-up"  # the names of those pages begin so
RUNNING = "running.md"


def enumerators(root):
    header = (root / "runtime/suture/base/errors.h").read_text(encoding="utf-8")
    body = re.search(r"enum class Errc\b[^{]*\{(.*?)\};", header, re.S)[1]
    return re.findall(r"^\s*(\w+)(?:\s*=\s*\d+)?,", re.sub(r"//.*", "", body), re.M)


def texts(root):
    source = (root / "runtime/suture/base/errors.cpp").read_text(encoding="utf-8")
    return dict(re.findall(r'case Errc::(\w+):\s*return "([^"]*)";', source))


def page_of(name):
    """Returns "too-many-calls.md" for TooManyCalls."""
    return re.sub(r"(?<!^)(?=[A-Z])", "-", name).lower() + ".md"


def rows(readme):
    """Returns each row of the table: the enumerator, its page and the text."""
    return re.findall(r"^\| \[(\w+)\]\(([^)]*)\) \| (.*?) \|", readme, re.M)


def unknown_messages(root, pages):
    """Yields each row's message, `...` standing for anything, that is in no source."""
    sources = (path.read_text(encoding="utf-8")
               for folder in error_sites.FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".cpp", ".h"))
    text = re.sub(r'"\s*"', "", "".join(sources)).replace('\\"', '"')
    for name, page in pages:
        for pattern in error_sites.patterns(page):
            if max(map(len, pattern.split("..."))) < error_sites.LEAST:
                yield f"docs/errors/{name}: too many messages have '{pattern}'"
            if not all(part.strip(" :.") in text for part in pattern.split("...")):
                yield f"docs/errors/{name}: no source says '{pattern}'"


def missing_messages(root, pages):
    """Yields each place that makes a message which no row explains."""
    patterns = [pattern for _, page in pages for pattern in error_sites.patterns(page)]
    for site in error_sites.sites(root):
        if not any(error_sites.has_parts(site.words, pattern) for pattern in patterns):
            yield f"{site.file}:{site.line}: no row of docs/errors/{SET_UP}-*.md explains '{site.words}'"


def missing_lines(root, pages):
    """Yields each place that prints a line on standard error which no row explains."""
    patterns = [pattern for _, page in pages for pattern in error_sites.patterns(page)]
    for site in error_sites.printed(root):
        if not any(error_sites.has_parts(site.words, pattern) for pattern in patterns):
            yield f"{site.file}:{site.line}: no row of docs/errors/{RUNNING} or {SET_UP}-*.md explains '{site.words}'"


def violations(root):
    folder = root / "docs/errors"
    names, text_of = enumerators(root), texts(root)
    if not names:
        yield "errors.h: no enumerators found"
    pages = {page.name: page.read_text(encoding="utf-8") for page in folder.glob("*.md")}
    readme = pages.get("README.md", "")
    for name in names:
        title = f"# {text_of.get(name)}: `Errc::{name}`"
        page = page_of(name)
        if name not in text_of:
            yield f"errors.cpp: toString() has no text for {name}"
        elif page not in pages:
            yield f"docs/errors/{page} is missing: explain Errc::{name}"
        elif pages[page].split("\n")[0] != title:
            yield f"docs/errors/{page}: the first line has to be {title}"
        found = [row for row in rows(readme) if row[0] == name]
        if found != [(name, page, text_of.get(name))]:
            yield f"docs/errors/README.md: one row has to begin with | [{name}]({page}) | {text_of.get(name)} |, found {found}"
    set_up = sorted((name, page) for name, page in pages.items() if name.startswith(SET_UP))
    for page in sorted(pages.keys() - {page_of(name) for name in names} - {"README.md", RUNNING} - {name for name, _ in set_up}):
        yield f"docs/errors/{page} explains what no enumerator is"
    for name, _, _ in rows(readme):
        if name not in names:
            yield f"docs/errors/README.md has a row for {name}, which no enumerator is"
    yield from unknown_messages(root, [*set_up, (RUNNING, pages.get(RUNNING, ""))])
    yield from missing_messages(root, set_up)
    yield from missing_lines(root, [*set_up, (RUNNING, pages.get(RUNNING, ""))])
    for page, text in sorted(pages.items()):
        if not page.startswith(SET_UP) and text.count("\n") > MAX_LINES:
            yield f"docs/errors/{page}: more than {MAX_LINES} lines"


class Tree(unittest.TestCase):
    def test_it_explains_each_error(self):
        self.assertEqual([], list(violations(ROOT)))


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("runtime/suture/base/errors.h", "enum class Errc : int {\n  Lost = 1,  ///< gone, for now\n  TooOld,  ///< not kept,\n"
                                            "           ///< however large, it is\n};\n")
        self.write("runtime/suture/base/errors.cpp", 'case Errc::Lost: return "connection lost";\ncase Errc::TooOld:\n  return "too old";\n')
        self.write("docs/errors/lost.md", "# connection lost: `Errc::Lost`\n\nNothing was sent.\n")
        self.write("docs/errors/too-old.md", "# too old: `Errc::TooOld`\n")
        self.write("docs/errors/README.md", "| [Lost](lost.md) | connection lost | no |\n| [TooOld](too-old.md) | too old | no |\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def edit(self, path, old, new):
        text = (self.root / path).read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.write(path, text.replace(old, new))

    def expect(self, *words):
        found = list(violations(self.root))
        self.assertEqual(len(words), len(found), found)
        for one, text in zip(words, found):
            self.assertIn(one, text)

    def test_a_tree_without_violations(self):
        self.expect()

    def test_a_printed_line_without_a_row(self):
        self.write("runtime/a.cpp", 'std::fprintf(stderr, "cart: %s\\n", text);\nstd::fprintf(stderr, "%s has lost a wheel\\n", name);\n')
        self.expect("runtime/a.cpp:2: no row of docs/errors/running.md or set-up-*.md explains '... has lost a wheel'")

    def test_an_enumerator_without_an_explanation(self):
        self.edit("runtime/suture/base/errors.h", "TooOld,", "TooOld,\n  CannotWait,")
        self.edit("runtime/suture/base/errors.cpp", "case Errc::Lost", 'case Errc::CannotWait: return "it cannot";\ncase Errc::Lost')
        self.expect("cannot-wait.md is missing", "| [CannotWait](cannot-wait.md) | it cannot |, found []")

    def test_an_enumerator_without_text(self):
        self.edit("runtime/suture/base/errors.cpp", "Errc::TooOld", "Errc::Other")
        self.expect("no text for TooOld", "README.md: one row")

    def test_a_text_that_has_changed(self):
        self.edit("runtime/suture/base/errors.cpp", "too old", "no longer kept")
        self.expect("too-old.md: the first line has to be # no longer kept", "| no longer kept |, found [('TooOld'")

    def test_a_page_that_is_left_over(self):
        self.write("docs/errors/too-new.md", "# too new: `Errc::TooNew`\n")
        self.expect("too-new.md explains what no enumerator is")

    def test_a_message_that_no_source_has(self):
        self.write("runtime/suture/net/address.cpp", 'refuse(text, "it has "\n    "no path", "Write one");\n')
        self.write("docs/errors/set-up-net.md", "| `it has no path` | so | do |\n| `it has ... no port at all` or `it has` | so | do |\n")
        self.expect("no source says 'it has ... no port at all'", "too many messages have 'it has'")

    def test_a_line_of_a_running_process_that_no_source_has(self):
        self.write("runtime/suture/deploy/host.cpp", 'tell(name + " is lost, " + why);\n')
        self.write("docs/errors/running.md", "| `is lost, ...` | so | do |\n| `is found again` | so | do |\n")
        self.expect("running.md: no source says 'is found again'")

    def test_a_message_without_a_row(self):
        self.write("docs/errors/set-up.md", "| `it has more ... of ...` or `there are no` | so | do |\n")
        self.write("runtime/a.cpp", 'throw SetupError("use " + name,\n  "it has more " + count + " of " + most,  // "not this"\n  "Give less");\n'
                                    'throw SetupError("use " + name, "there are too many: " + count, "Give less");\n'
                                    'throw SetupError("there are no " + name, std::strerror(errno), "Raise it");\n'
                                    'throw SetupError(failure.what());\n')
        self.write("components/b.h", 'throw SetupError("open", isFile ? "there are no folders" : "it is a folder", "Close it");\n'
                                     'refuse(place, "it has a place", "Mend it");\nreturn {Kind::LIMIT_REACHED, "it is full; stop some"};\n')
        self.expect("runtime/a.cpp:4: no row of docs/errors/set-up-*.md explains 'there are too many: ...'",
                    "components/b.h:1: no row of docs/errors/set-up-*.md explains 'it is a folder'",
                    "components/b.h:2: no row of docs/errors/set-up-*.md explains 'it has a place. Mend it'",
                    "components/b.h:3: no row of docs/errors/set-up-*.md explains 'it is full; stop some'")

    def test_a_row_that_is_left_over(self):
        self.edit("docs/errors/README.md", "| [TooOld]", "| [TooNew](too-new.md) | too new | no |\n| [TooOld]")
        self.expect("a row for TooNew")

    def test_a_row_that_is_missing(self):
        self.edit("docs/errors/README.md", "| [Lost](lost.md) | connection lost | no |\n", "")
        self.expect("| [Lost](lost.md) | connection lost |, found []")

    def test_two_rows_for_one(self):
        self.edit("docs/errors/README.md", "| [TooOld]", "| [Lost](lost.md) | connection lost | no |\n| [TooOld]")
        self.expect("README.md: one row has to begin with | [Lost]")

    def test_a_page_that_is_too_long(self):
        self.write("docs/errors/lost.md", "# connection lost: `Errc::Lost`\n" + "\n" * 40)
        self.expect("lost.md: more than 40 lines")

    def test_a_header_in_another_form(self):
        self.edit("runtime/suture/base/errors.h", "Lost = 1,", "")
        self.edit("runtime/suture/base/errors.h", "TooOld,", "")
        self.expect("no enumerators found", "lost.md explains", "too-old.md explains", "a row for Lost", "a row for TooOld")


if __name__ == "__main__":
    unittest.main()
