"""Writes the headers of edits: one folder for each edit, or all of them in one contract."""

from edit import Edit, Side

HEAD = """#pragma once
// Written by write.py.

#include <suture/annotate.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>
"""


def contract(name, side, members):
    base = f" : public {side.base}" if side.base else ""
    return f"\nclass SUTURE_INTERFACE({side.says}) {name}{base} {{\n public:\n" + (
        f"  ~{name}() override = default;\n" if base else f"  virtual ~{name}() = default;\n") + members + "};\n"


def declarations(side):
    return "".join(one.declaration() for one in side.commands + side.events)


def alone(edit: Edit, side: Side):
    """Returns the types and the contract of one edit. A command that never changes stands in front, so that no contract is empty."""
    put = "  SUTURE_COMMAND() virtual void put(const {T}& value) = 0;\n" if side.has_struct else ""
    anchor = "  SUTURE_COMMAND() virtual void stay() = 0;\n"
    if edit.inherited:
        root = contract("{T}Root", Side(), "  SUTURE_COMMAND() virtual void root() = 0;\n" + declarations(side))
        return edit.text(root + contract("{T}Contract", Side(base="{T}Root"), anchor))
    return edit.text(side.types + contract("{T}Contract", side, anchor + put + declarations(side)))


def within(space, text, includes=""):
    return f"{HEAD}{includes}\nnamespace {space} {{\n\n{text}\n}}  // namespace {space}\n"


def write_alone(folder, edit, side):
    """Each edit has a folder, so that what suturec prints names it. Returns the headers."""
    home = folder / edit.stem
    home.mkdir(parents=True, exist_ok=True)
    includes = ""
    headers = [home / "contract.h"]
    if side.elsewhere:
        headers.insert(0, home / "elsewhere.h")
        headers[0].write_text(within(side.space, edit.text(side.elsewhere)))
        includes = f'\n#include "{edit.stem}/elsewhere.h"\n'
    headers[-1].write_text(within(side.space, alone(edit, side), includes))
    return headers
