"""Builds the site: build.py OUT. Fails if doxygen warns of something, or if a link of a page leads nowhere.

The documents are those of this tree; what a user's code includes is there with the comments of its headers.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

# The menus above each page: what a menu itself leads to, and the pages in it.
MENUS = {
    "Tutorial": ["docs/tutorial/README.md", "docs/tutorial/[0-9]*.md"],
    "How to": ["docs/howto/README.md", "docs/howto/[a-z]*.md"],
    "Examples": ["examples/README.md", "examples/*/README.md"],
    "Subjects": ["docs/README.md", "docs/[a-z]*.md"],
    "Errors of calls": ["docs/errors/README.md", "docs/errors/[a-z]*.md"],
    "Messages of suturec": ["docs/diagnostics/README.md", "docs/diagnostics/[a-z]*.md"],
    "Adding": ["docs/adding/README.md", "docs/adding/[a-z]*.md"],
    "Decisions": ["docs/adr/README.md", "docs/adr/[0-9]*.md"],
}


def tab(page):
    """Returns the entry of a page: doxygen names it after its path."""
    path = page.relative_to(ROOT).with_suffix("")
    name = "md_" + re.sub(r"[^A-Za-z0-9]", "_", str(path))
    title = page.read_text(encoding="utf-8").split("\n")[0].removeprefix("# ")
    return f"<tab type=\"user\" url=\"@ref {name}\" title={quoteattr(title)}/>"


def layout():
    lines = ["<doxygenlayout version=\"1.0\">", "<navindex>", "<tab type=\"mainpage\" title=\"Suture\"/>"]
    for menu, patterns in MENUS.items():
        pages = [page for pattern in patterns for page in sorted(ROOT.glob(pattern))]
        first = re.search(r'url="[^"]*"', tab(pages[0]))[0]
        lines += [f"<tab type=\"usergroup\" {first} title={quoteattr(menu)}>", *map(tab, pages[1:]), "</tab>"]
    lines += ["<tab type=\"usergroup\" title=\"Programming interface\">", "<tab type=\"classlist\" title=\"Classes\"/>",
              "<tab type=\"filelist\" title=\"Headers\"/>", "</tab>", "</navindex>", "</doxygenlayout>"]
    return "\n".join(lines) + "\n"


def configuration(out):
    text = (HERE / "Doxyfile").read_text(encoding="utf-8")
    return (f"{text}\nUSE_MDFILE_AS_MAINPAGE = {ROOT}/README.md\nSTRIP_FROM_PATH = {ROOT}\nSTRIP_FROM_INC_PATH = {ROOT}/runtime\n"
            f"LAYOUT_FILE = {out}/layout.xml\nOUTPUT_DIRECTORY = {out}\n")


def missing_headers(pages, configured):
    """Yields the headers of the runtime that pages name and the site leaves out: neither a file nor a folder of INPUT."""
    has = re.search(r"^INPUT = ((?:.*\\\n)*.*)$", configured, re.M)[1].replace("\\", " ").split()
    for page in pages:
        for header in sorted(set(re.findall(r"suture/[\w/]+\.h\b", page.read_text(encoding="utf-8")))):
            if not any(f"runtime/{header}".startswith(one) for one in has):
                yield f"{page.name} names {header}, which INPUT in Doxyfile leaves out"


def broken_links(folder):
    for page in sorted(folder.glob("*.html")):
        text = page.read_text(encoding="utf-8", errors="replace")
        for link in set(re.findall(r'(?:href|src|data)="([^"#?]+)', text)):
            if not re.match(r"[a-z]+:", link) and not (folder / urllib.parse.unquote(link)).exists():
                yield f"{page.name} leads to {link}, which is not there"


def build(out):
    """Returns what is wrong, a line each."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "layout.xml").write_text(layout(), encoding="utf-8")
    done = subprocess.run(["doxygen", "-"], input=configuration(out), cwd=ROOT, capture_output=True, text=True)
    problems = done.stderr.splitlines() + list(broken_links(out / "html"))
    if done.returncode != 0 and not problems:
        problems = [f"doxygen ended with status {done.returncode} and said nothing"]
    return problems


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: build.py OUT")
    if shutil.which("doxygen") is None:
        sys.exit("make the site: there is no doxygen. Install it: apt-get install --no-install-recommends doxygen")
    out = pathlib.Path(sys.argv[1]).resolve()
    problems = build(out)
    if problems:
        sys.exit("\n".join(problems))
    print(f"{out}/html/index.html")


if __name__ == "__main__":
    main()
