"""suturec and its page know each namespace within `suture` that installed headers declare: it hides a user's of that name."""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
CHECK = ROOT / "compiler/check/hidden_names.cpp"
PAGE = ROOT / "docs/diagnostics/hidden-namespace.md"


def inner_namespaces(text):
    """Yields the second part of each namespace below `suture`. What ends an outer namespace names it, or another begins."""
    outer = None
    for line in text.splitlines():
        begin = re.match(r"(?:inline )?namespace (\w+)(?:::(\w+)[\w:]*)? \{", line)
        if begin and (begin[1] == "suture" or not outer):
            outer = begin[1]
            if outer == "suture" and begin[2]:
                yield begin[2]
        elif begin and outer == "suture":
            yield begin[1]
        elif outer and re.match(rf"\}}  // namespace {outer}\b", line):
            outer = None


def declared():
    """Returns the namespaces that headers declare, and schemas of which capnp writes headers."""
    names = set()
    for header in (ROOT / "runtime/suture").rglob("*.h"):
        names.update(inner_namespaces(header.read_text(encoding="utf-8")))
    for schema in (ROOT / "schemas/suture").rglob("*.capnp"):
        names.update(re.findall(r'^\$Cxx\.namespace\("suture::(\w+)', schema.read_text(encoding="utf-8"), re.MULTILINE))
    return names


class HiddenNamespaces(unittest.TestCase):
    def test_of_one_text(self):
        text = ("namespace kj {\n}  // namespace kj\nnamespace suture::codec {\n}  // namespace suture::codec\n"
                "namespace suture {\nclass Task;\n}\nnamespace suture {\nnamespace loop {\n}  // namespace loop\nstruct Rate {};\n}  // namespace suture\n")
        self.assertEqual(list(inner_namespaces(text)), ["codec", "loop"])

    def test_suturec_refuses_each(self):
        listed = re.search(r"kOfRuntime\{(.*?)\};", CHECK.read_text(encoding="utf-8"), re.DOTALL)[1]
        self.assertEqual(re.findall(r'"(\w+)"', listed), sorted(declared()))

    def test_the_page_has_each(self):
        listed = re.search(r"none\s+outside may be called ([^,]*(?:,[^,]*)*?), which", PAGE.read_text(encoding="utf-8"))[1]
        self.assertEqual(re.findall(r"`(\w+)`", listed), sorted(declared()))


if __name__ == "__main__":
    sys.exit(unittest.main())
