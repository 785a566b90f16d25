"""Writes all edits into two versions of a few headers, for two programs that talk to each other.

  batch.py --suturec SUTUREC --out FOLDER -- FLAGS...

FOLDER/v1 and FOLDER/v2 get edits.h, one contract with every compatible edit, and breaks.h, a contract for each that breaks. What
edits have in another header is in parts.h and elsewhere.h. Beside the headers are their locks, what suturec writes from them, and
versioned.h: what the peers of this version do otherwise than those of the other.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

from breaking import BREAKING, LAST
from compatible import COMPATIBLE
from edit import Command, Side
from write import alone, contract, declarations, within

PATHS = """  SUTURE_COMMAND() virtual void put(const Record& record) = 0;
  SUTURE_COMMAND() virtual Record exchange(const Record& record) = 0;
  SUTURE_COMMAND() virtual const Record& last() const = 0;
  SUTURE_EVENT() suture::EventOf<Record> told;
  SUTURE_EVENT() suture::EventOf<bool> end;
"""

ROOT = """  SUTURE_COMMAND() virtual void root() = 0;
  SUTURE_COMMAND() virtual double depth() const = 0;
  SUTURE_EVENT(latched()) suture::EventOf<double> rooted;
"""

VERSIONED = """#pragma once
// Written by batch.py.

#include <suture/component/task/event_task.h>

#include "edits/breaks.suture.h"
#include "edits/edits.suture.h"
#include "tests/compiler/evolution/edits/printed.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace edits {

inline Record example() {
  Record record;
%(sends)s  return record;
}

template <class Print>
void forEachMember(const Record& record, const Print& print) {
%(members)s}

/// Prints what the commands of the edits bring.
class Receiver : public Edits {
 public:
%(handlers)s};

inline void call(suture::Required<Edits>& edits) {
%(calls)s}

inline void listen(suture::Required<Edits>& edits) {
%(listens)s}

template <class Emit>
void emitAll(Emit& emit) {
%(emits)s}

%(kept)s
struct Kept {
  explicit Kept(suture::Component& owner) : owner_(owner) {}
  suture::Component& owner_;
%(provided)s};

struct Asked {
  explicit Asked(suture::Component& owner) : owner_(owner) {}
  suture::Component& owner_;
%(required)s};

constexpr const char* kBreaks[] = {%(breaks)s};

}  // namespace edits
"""


def rows(edits, version):
    """Returns each edit and what it has in that version; most have nothing on the way."""
    return [(edit, getattr(edit, version) or edit.old) for edit in edits]


def beside(path, chosen):
    """Returns the header with the types of these edits that stand elsewhere, and the line that includes it."""
    elsewhere = "".join(edit.text(side.elsewhere) for edit, side in chosen)
    return {path: within("edits", elsewhere)} if elsewhere else {}, f'\n#include "{path}"\n' if elsewhere else ""


def edits_headers(version):
    chosen = rows(COMPATIBLE, version)
    headers, include = beside("edits/parts.h", chosen)
    carried = [edit for edit, side in chosen if side.has_struct]
    record = "struct SUTURE_TYPE() Record {\n" + "".join(f"  {edit.title} {member(edit)};\n" for edit in carried) + "};\n"
    types = "".join(edit.text(side.types) for edit, side in chosen)
    root = contract("Root", Side(), ROOT + members(chosen, inherited=True))
    whole = contract("Edits", Side(base="Root"), PATHS + members(chosen, inherited=False))
    return {"edits/edits.h": within("edits", types + record + root + whole, include), **headers}


def members(chosen, inherited):
    return "".join(edit.text(declarations(side)) for edit, side in chosen if edit.inherited == inherited)


def member(edit):
    return edit.title[0].lower() + edit.title[1:]


def breaks_headers(version):
    chosen = rows(BREAKING, version)
    headers, include = beside("edits/elsewhere.h", chosen)
    text = "".join(alone(edit, side) for edit, side in chosen)
    return {"edits/breaks.h": within("edits", text, include), **headers}


def handler(edit, command: Command, told):
    told = told and not command.is_const  # a row asks for it at any time
    printed = "".join(f' << " {name}=" << text({name})' for name in command.parameters) if told else ""
    body = f' std::cout << "heard {command.name}"{printed} << std::endl;' if told else ""
    gives = f" return {command.gives};" if command.gives else ""
    return edit.text(f"  {command.implemented} final {{{body}{gives} }}\n")


def caller(command: Command, call):
    """Lets the provider take a flood before the call, since its own queue may be shorter than the client's."""
    flood = ""
    if call.flood:
        flood = (f'  flood("{command.name}", [&] {{ return edits.{command.name}({call.flood}); }});\n'
                 '  (void)edits.exchange.start(example()).within(std::chrono::seconds(10));\n')
    return flood + f'  tell("{command.name}", edits.{command.name}.start({call.arguments}));\n'


def kept(edit, side):
    """Returns what provides the contract of a breaking edit: no client ever reaches it."""
    all_commands = [Command("void stay()"), *side.commands, *([LAST] if side.base else [])]
    if side.has_struct:
        all_commands.append(Command("void put(const {T}&)"))
    return edit.text("struct {T}Kept final : {T}Contract {\n") + "".join(
        handler(edit, one, False) for one in all_commands) + "};\n"


def versioned(version):
    chosen, broken = rows(COMPATIBLE, version), rows(BREAKING, version)
    commands = [(edit, one) for edit, side in chosen for one in side.commands]
    events = [(edit, one) for edit, side in chosen for one in side.events]
    return VERSIONED % {
        "sends": "".join(edit.text(f"  record.{member(edit)}.{name} = {value};\n")
                         for edit, side in chosen for name, value in side.sends.items()),
        "members": "".join(f'  print("{edit.stem}.{name}", record.{member(edit)}.{name});\n'
                           for edit, side in chosen for name in side.sees),
        "handlers": "".join(handler(edit, one, True) for edit, one in commands),
        "calls": "".join(edit.text(caller(one, call)) for edit, one in commands for call in one.calls),
        "listens": "".join(f'  hear("{one.name}", edits.on().{one.name}([](const auto&... values) {{ printEvent("{one.name}", values...); }}));\n'
                           for _, one in events),
        "emits": "".join(edit.text(f"  emit.{one.name}({one.emits});\n") for edit, one in events),
        "kept": "".join(kept(edit, side) for edit, side in broken),
        "provided": "".join(edit.text('  {T}Kept m{T};\n  suture::Provided<{T}Contract> p{T}{owner_, "{T}", m{T}};\n')
                            for edit, _ in broken),
        "required": "".join(edit.text('  suture::Required<{T}Contract> r{T}{owner_, "{T}"};\n') for edit, _ in broken),
        "breaks": ", ".join(edit.text('"{T}"') for edit, _ in broken),
    }


def write(folder, version):
    files = {**edits_headers(version), **breaks_headers(version)}
    (folder / "edits").mkdir(parents=True, exist_ok=True)
    for path, text in files.items():
        (folder / path).write_text(text)
    (folder / "versioned.h").write_text(versioned(version))
    return list(files)


def run(suturec, folder, headers, flags, *more):
    command = [suturec, "--target-name", "edits", "--base-dir", str(folder), "--out", str(folder), "--lock-dir",
               str(folder / "schemas"), *more, *(str(folder / one) for one in headers), "--", f"-I{folder}", *flags]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suturec", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    arguments, flags = parser.parse_known_args()
    first, second = arguments.out / "v1", arguments.out / "v2"
    for folder in (first, second):
        shutil.rmtree(folder, ignore_errors=True)
    headers = write(first, "old")
    run(arguments.suturec, first, headers, flags[1:], "--update-lock")
    run(arguments.suturec, first, headers, flags[1:])
    shutil.copytree(first / "schemas", second / "schemas")
    run(arguments.suturec, second, write(second, "between"), flags[1:], "--update-lock")
    newest = write(second, "new")
    fine = [one for one in newest if one in ("edits/edits.h", "edits/parts.h")]
    run(arguments.suturec, second, fine, flags[1:], "--update-lock")
    run(arguments.suturec, second, newest, flags[1:], "--update-lock", "--accept-break")
    run(arguments.suturec, second, newest, flags[1:])


if __name__ == "__main__":
    main()
