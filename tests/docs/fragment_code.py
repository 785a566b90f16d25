"""Has the C++ blocks of pages compiled, each in what around/NAME.cpp.in puts around it.

All blocks go through one call of suturec and one of the compiler, each in a namespace of its own; `#line` has both tell of the page.
"""

import pathlib
import re
import subprocess

AROUND = pathlib.Path(__file__).resolve().parent / "around"
PARTS = ("contracts", "components", "code")
LIMIT = 120  # s; only so that a hang ends the test


class Fault(Exception):
    """Says what is wrong with a block of a page."""


def parts_of(block):
    """Returns the block with what is around it, as {"contracts": text, ...}."""
    around = AROUND / f"{block.words['in']}.cpp.in"
    if not around.exists():
        raise Fault(f"{block.where}: there is no around/{around.name}")
    page, _, line = block.where.partition(":")
    text = block.text.replace("...", ";")
    pieces = [(int(line) + 1 + text[:match.start()].count("\n"), match[0]) for match in re.finditer(r"(?:.+\n)+", text)]
    lines = around.read_text(encoding="utf-8").split("\n")
    marks = sum("// paragraph" in one for one in lines)
    if marks and marks != len(pieces):
        raise Fault(f"{block.where}: around/{around.name} is for {marks} paragraphs, and here are {len(pieces)}")
    parts = dict.fromkeys(PARTS, "")
    part = None
    for number, one in enumerate(lines, 1):
        if one.startswith("// --- "):
            part = one.removeprefix("// --- ")
            parts[part] += f'#line {number + 1} "around/{around.name}"\n'
        elif "// paragraph" in one or "// block" in one:
            first, piece = pieces.pop(0) if "// paragraph" in one else (int(line) + 1, text)
            parts[part] += f'#line {first} "{page}"\n{piece}#line {number + 1} "around/{around.name}"\n'
        else:
            parts[part] += one + "\n"
    return parts


def faults_of(blocks, root, suturec, folder):
    """Yields what suturec and the compiler say of these blocks, which it writes below `folder`."""
    prelude = (AROUND / "prelude.cpp.in").read_text(encoding="utf-8")
    headers, code = [], prelude
    for number, block in enumerate(blocks):
        try:
            parts = parts_of(block)
        except Fault as fault:
            yield str(fault)
            continue
        own = {part: f"namespace block_{number} {{\n{text}}}\n" for part, text in parts.items() if text}
        for part, above in ("contracts", "#include <suture/annotate.h>\n#include <vector>\n"), ("components", prelude):
            if part in own:
                headers.append(folder / f"{part}_{number}.h")
                contracts = f'#include "contracts_{number}.suture.h"\n' if part == "components" else ""
                headers[-1].write_text(f"#pragma once\n{above}{contracts}{own[part]}", encoding="utf-8")
                code += f'#include "{part}_{number}.suture.h"\n'
        code += own.get("code", "")
    (folder / "code.cpp").write_text(code, encoding="utf-8")
    clang = ["-std=c++20", "-I", folder, "-I", folder / "generated", "-I", root / "runtime", "-I", root / "components",
             "-I", root / "generated", "-isystem", "/usr/include/eigen3"]
    read = [suturec, "--target-name", "pages", "--project", "pages", "--base-dir", folder, "--out", folder / "generated",
            "--lock-dir", folder / "lock", "--lock-dir", root / "schemas"]
    generate = [[*read, "--update-lock", *headers, "--", *clang], [*read, *headers, "--", *clang]] if headers else []
    for call in [*generate, ["c++", "-fsyntax-only", "-w", *clang, folder / "code.cpp"]]:
        done = subprocess.run(call, capture_output=True, text=True, check=False, timeout=LIMIT)
        if done.returncode != 0:
            yield done.stdout + done.stderr
            return
