"""Finds where the sources make a message that a user can meet while a system is set up.

A site is a call that makes a SetupError or UsageError, one of a helper that does (refuse, report, locate), or a Refusal that
a process sends another; in the driver of suturec, one that makes an exception. Its words are those of the message, `...` standing for what differs each time.
"""

import re
import typing

MAKERS = re.compile(r"\b(SetupError|UsageError|DocumentError|refuse|report|locate|failure|disconnected|problems_?\.push_back)\s*\(|\{\s*(?=Kind::)")
MAKERS_OF_DRIVER = re.compile(r"\b(runtime_error|ValidationError)\s*\(")
PRINTERS = re.compile(r"\bfprintf\s*\(\s*(?=stderr\b)|\bprintUnlessFull\s*\(")
FOLDERS = {"runtime": MAKERS, "components": MAKERS, "examples": MAKERS, "compiler/driver": MAKERS_OF_DRIVER}
OF_ANOTHER = re.compile(r"\.what\(\)|\blocate\(|\bwarn\(")  # what is made around another message has no row of its own
BEFORE_ANOTHER = re.compile(r"[\w ./-]*: \.\.\.$")  # puts the name of a program before a message that has its own row
LEAST = 9  # letters, a space among them, that tell one message from another
ANY = "..."
OTHERWISE = "\0"  # stands between the texts of `condition ? one : other`


def without_comments(text):
    """Returns the text with its comments blanked, so that lines keep their numbers."""
    token = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'|//[^\n]*|/\*.*?\*/', re.S)
    return token.sub(lambda m: m[0] if m[0][0] in "\"'" else re.sub(r"[^\n]", " ", m[0]), text)


def arguments(text, opening):
    """Returns the arguments of the call whose parenthesis is at `opening`."""
    found, begin, depth = [], opening + 1, 0
    for token in re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'|[][(){},]').finditer(text, opening):
        if token[0] in "([{":
            depth += 1
        elif token[0] in ")]}":
            depth -= 1
        if depth == 0 or (token[0] == "," and depth == 1):
            found.append(text[begin:token.start()].strip())
            begin = token.end()
        if depth == 0:
            break
    return found


def words(expression):
    """Returns the texts in a C++ expression: `...` is what is computed between them."""
    out = ""
    for literal, other in re.findall(r'"((?:[^"\\]|\\.)*)"|([^"]+)', expression):
        if re.search(r"\w", other):
            out += ANY
        elif ":" in other:
            out += OTHERWISE
        out += re.sub(r"\\(.)", lambda m: " " if m[1] == "n" else m[1], literal)
    return out


def is_telling(text):
    return any(len(part) >= LEAST and " " in part for part in text.split(ANY))


class Site(typing.NamedTuple):
    file: str
    line: int
    words: str  # those of its `found`, if that has any of its own
    whole: str  # these, and what to do


def told(maker, given):
    """Returns the words of a site, and these with what to do."""
    texts = [words(one) for one in given]
    if len(texts) == 3 and maker in ("SetupError", "UsageError"):
        whole = f"{texts[0]}: {texts[1]}. {texts[2]}"
        return (texts[1], f"{texts[1]}{ANY}{texts[2]}") if is_telling(texts[1]) else (whole, whole)
    if len(texts) == 3 and maker == "refuse":
        texts.append(f"{texts[1]}. {texts[2]}")
    return texts[-1], texts[-1]


def alternatives(text):
    """Yields each text of a choice between whole messages, or one text with `...` for a choice of words in it."""
    each = text.split(OTHERWISE)
    yield from each if all(map(is_telling, each)) else [ANY.join(each)]


def has_parts(words_of_site, pattern):
    """Tells if the parts of `it is still ...` are in the words, one behind the other."""
    at = 0
    for part in pattern.split(ANY):
        found = words_of_site.find(part, at)
        if found < 0:
            return False
        at = found + len(part)
    return True


def patterns(page):
    """Returns what the rows of a page explain: a row has one message in its first cell, or several, joined by `or`."""
    return [one for cell in re.findall(r"^\| `(.*?)` \|", page, re.M) for one in cell.split("` or `")]


def sites(root):
    """Yields each Site of a tree."""
    for folder, makers in FOLDERS.items():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            text = without_comments(path.read_text(encoding="utf-8"))
            for match in makers.finditer(text):
                given = arguments(text, max(text.rfind(one, 0, match.end()) for one in "({"))
                helper = given[-1] == "remedy" or (match[1] != "SetupError" and OF_ANOTHER.search(given[-1]))
                if helper:
                    continue
                found, whole = told(match[1], given)
                for one in alternatives(found):
                    if is_telling(one):
                        yield Site(path.relative_to(root).as_posix(), text.count("\n", 0, match.start()) + 1, one,
                                   one if OTHERWISE in found else whole)


def printed(root):
    """Yields a Site for each line that a program but `suture` prints on standard error with words of its own."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix not in (".cpp", ".h") or name.startswith(("runtime/cli/", "compiler/")):
                continue
            text = without_comments(path.read_text(encoding="utf-8"))
            for match in PRINTERS.finditer(text):
                given = arguments(text, text.rfind("(", 0, match.end()))
                line = re.sub(r"%\w", ANY, words(given[1] if given[0] == "stderr" else given[0])).strip()
                if is_telling(line) and not BEFORE_ANOTHER.match(line):
                    yield Site(name, text.count("\n", 0, match.start()) + 1, line, line)
