"""The examples on the pages of docs/diagnostics are true: suturec refuses the first of a page with the page's slug and
no other, and takes the one behind "Instead:" without a finding.

  pages_test.py SUTUREC --flags FLAGS          all pages; FLAGS, separated by semicolons, are for parsing
  pages_test.py SUTUREC --flags FLAGS 1/2      every second of them, from the first; 2/2 the others
  pages_test.py SUTUREC --flags FLAGS SLUG...  those

A fragment is put where it belongs: commands into a contract, fields into a type, interfaces into a component. What it
names but does not declare is in examples/example/names.h.
"""

import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PAGES = HERE.parents[2] / "docs" / "diagnostics"
TIME_LIMIT = 120  # seconds; a hang must end the test, the machine may be slow

# The committed lock says this where a page speaks of a lock.
BEFORE = {
    "lock-break": 'struct SUTURE_TYPE() Fragment { SUTURE_FIELD(unit("m")) double x = 0; };',
    "lock-range": "struct SUTURE_TYPE() Grip { SUTURE_FIELD(range(0, 40)) double force = 0; };",
    "lock-removed": "struct SUTURE_TYPE() Goal { double velocity = 0; };",
    "lock-stale": 'SUTURE_COMMAND(queue(8)) virtual void append(SUTURE_FIELD(unit("m")) double position) = 0;',
}

# These pages show what to run or to include instead of what to write.
WITHOUT_EXAMPLE = {"contract-size", "enum-size", "forgotten-include", "lock-conflict", "lock-duplicate-id", "lock-missing", "lock-moved", "lock-new",
                   "lock-newer", "lock-renamed", "lock-syntax", "nesting", "own-generated-include", "slot-size"}

STANDARD = {"array": "array", "optional": "optional", "vector": "vector", "string": "string", "map": "map", "deque": "deque",
            "variant": "variant", "unique_ptr": "memory", "function": "functional", "string_view": "string_view",
            "chrono": "chrono", "size_t": "cstddef"}


def includes_of(text, slug):
    wanted = {f"<{header}>" for name, header in STANDARD.items() if re.search(rf"\bstd::{name}\b", text)}
    if "Eigen::" in text:
        wanted |= {"<Eigen/Core>", "<Eigen/Geometry>"}
    if slug.startswith("crtk-"):
        wanted.add("<example/crtk.h>")
    return sorted(wanted | {"<cstdint>", "<suture/annotate.h>", "<example/names.suture.h>"})


def placed(text, slug):
    """Returns the fragment as a piece of a header."""
    first = next(line for line in text.splitlines() if line.strip() and not line.startswith("//"))
    commands = "crtk()" if slug.startswith("crtk-") else ""
    if re.match(r"(template <class T>\n)?SUTURE_(COMMAND|EVENT)|private:|public:", text[text.index(first):]):
        return f"class SUTURE_INTERFACE({commands}) Fragment {{\n public:\n  virtual ~Fragment() = default;\n{text}}};\n"
    if re.match(r"SUTURE_REQUIRED|suture::(Provided|Required)", first):
        return ("class SUTURE_COMPONENT() Fragment final : public suture::EventTask, public Arm {\n public:\n"
                f"  void enable() override;\n private:\n{text}}};\n")
    if re.match(r"SUTURE_FIELD|std::", first):
        return f"struct SUTURE_TYPE() Fragment {{\n{text}}};\n"
    return text


def stands_outside(text):
    """Returns True if the example says itself in which namespace it is."""
    return re.search(r"^namespace ", text, re.M) or "suture::Wire<" in text


def header_of(text, slug, namespace="demo"):
    """Returns a whole header; what stands outside of namespaces on the page does so here."""
    own = [line for line in text.splitlines() if line.startswith("#include")]
    rest = "".join(line + "\n" for line in text.splitlines() if not line.startswith("#include"))
    body = rest if stands_outside(rest) else f"namespace {namespace} {{\n{placed(rest, slug)}}}\n"
    lines = [f"#include {name}" for name in includes_of(text, slug)] + own
    return "#pragma once\n" + "\n".join(lines) + "\n" + body


class Folder:
    def __init__(self, suturec, flags, folder):
        self.suturec, self.flags, self.root = suturec, flags, pathlib.Path(folder)

    def run(self, text, *options):
        return self.run_all({"page": text}, *options)

    def run_all(self, texts, *options):
        """Runs suturec once on headers by their names."""
        for name, text in texts.items():
            (self.root / f"{name}.h").write_text(text, encoding="utf-8")
        command = [self.suturec, "--base-dir", ".", "--lock-dir", "schemas", *options, *(f"{name}.h" for name in texts), "--",
                   f"-I{HERE}/include", f"-I{HERE}/examples", *self.flags]
        done = subprocess.run(command, cwd=self.root, capture_output=True, text=True, timeout=TIME_LIMIT)
        return done.returncode, done.stdout + done.stderr


def check_wrong(folder, slug, text):
    if slug in BEFORE:
        folder.run(header_of(BEFORE[slug], slug), "--update-lock")
        status, printed = folder.run(header_of(text, slug), "--out", "out")
    else:
        status, printed = folder.run(header_of(text, slug), "--update-lock")
    slugs = set(re.findall(r"\[suture-([a-z-]+)\]", printed))
    others = [line for line in re.findall(r".*error: .*", printed) if "[suture-" not in line]
    warns = "warning:" in printed
    if slugs == {slug} and not others and status == (0 if warns else 1):
        return []
    return [f"{slug}.md: the first example gives {sorted(slugs)}, status {status}:\n{header_of(text, slug)}{printed}"]


def check_right(suturec, flags, texts):
    """`texts`: headers by the names of their pages."""
    with tempfile.TemporaryDirectory() as folder:
        status, printed = Folder(suturec, flags, folder).run_all(texts, "--update-lock")
    if status == 0 and "[suture-" not in printed:
        return []
    refused = {name: text for name, text in texts.items() if f"{name}.h:" in printed} or texts
    return [f"what these pages show instead is refused:\n{''.join(refused.values())}{printed}"]


def right_runs(pages):
    """The right examples, for as few runs as they can share: most are in one, each in a namespace of its own."""
    shared, own = {}, []
    for page in pages:
        for number, text in enumerate(examples_of(page)[1]):
            name = f"{page.stem.replace('-', '_')}_{number}"
            if stands_outside(text):
                own.append({name: header_of(text, page.stem)})
            else:
                shared[name] = header_of(text, page.stem, f"demo::{name}")
    return [shared, *own] if shared else own


def examples_of(page):
    """The wrong ones and the right ones: each block belongs to the paragraph before it."""
    text = page.read_text(encoding="utf-8")
    blocks = [(m.start(), m.group(1)) for m in re.finditer(r"```cpp\n(.*?)```", text, re.S)]
    turn = re.search(r"^(Instead|Give the instance one|Right):?", text, re.M)
    at = turn.start() if turn else len(text)
    return [b for place, b in blocks if place < at], [b for place, b in blocks if place > at]


def check_page(suturec, flags, page):
    slug = page.stem
    wrong, _ = examples_of(page)
    if not wrong:
        return [f"{slug}.md shows no example"]
    problems = []
    for example in wrong:
        with tempfile.TemporaryDirectory() as folder:
            problems += check_wrong(Folder(suturec, flags, folder), slug, example)
    return problems


def choose(pages, wanted):
    """Returns all pages, those named, or with "1/2" every second."""
    share = re.fullmatch(r"(\d+)/(\d+)", wanted[0]) if wanted else None
    if share:
        return pages[int(share[1]) - 1::int(share[2])]
    return [page for page in pages if not wanted or page.stem in wanted]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("suturec")
    parser.add_argument("--flags", required=True, type=lambda flags: flags.split(";"))
    parser.add_argument("wanted", nargs="*")
    options = parser.parse_intermixed_args()
    pages = sorted(page for page in PAGES.glob("*.md") if page.stem != "README")
    known = {page.stem for page in pages}
    problems = [f"WITHOUT_EXAMPLE names {slug}, which has no page" for slug in sorted(WITHOUT_EXAMPLE - known)]
    chosen = [page for page in choose(pages, options.wanted) if page.stem not in WITHOUT_EXAMPLE]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(check_page, options.suturec, options.flags, page) for page in chosen]
        jobs += [pool.submit(check_right, options.suturec, options.flags, texts) for texts in right_runs(chosen)]
        problems += [problem for job in jobs for problem in job.result()]
    print("\n".join(problems) or f"the examples of {len(chosen)} pages are true")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
