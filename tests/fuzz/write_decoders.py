"""Lists the converters that suturec has written, for a fuzzer.

  write_decoders.py OUT.cpp ROOT STEM...    ROOT/STEM.wire.cpp, without those that convert nothing

The list is taken from the generated files, so that a new type is fuzzed from its first day.
"""

import pathlib
import re
import sys

DECODER = re.compile(r"^suture::Errc fromWire\((wire::\w+)::Reader(?: in)?,\s+(\w+)&(?: slot)?,"
                     r"\s+suture::Duration(?: shift)?\) {$", re.MULTILINE)
STORE = re.compile(r"^bool store\(const ([^&]+)& value,\s+(\w+)& slot\)", re.MULTILINE)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$", re.MULTILINE)


def decoders(source):
    """Returns (namespace, type, slot, message) of each struct of one generated file."""
    text = source.read_text(encoding="utf-8")
    header = source.with_name(source.name.replace(".wire.cpp", ".suture.h")).read_text(encoding="utf-8")
    types = {slot: value for value, slot in STORE.findall(header)}
    spaces = [(found.start(), found[1]) for found in NAMESPACE.finditer(text)]
    for found in DECODER.finditer(text):
        space = [name for start, name in spaces if start < found.start()][-1]
        yield space, types[found[2]], found[2], found[1]


def main():
    out, root, *stems = sys.argv[1:]
    includes, definitions, names = [], [], []
    for stem in stems:
        found = list(decoders(pathlib.Path(root) / f"{stem}.wire.cpp"))
        if found:
            includes.append(f'#include "{stem}.suture.cpp"\n#include "{stem}.wire.cpp"\n')
        for space, value, slot, message in found:
            name = f"{space}::k{slot}Decoder"
            definitions.append(f"namespace {space} {{\nstatic const auto k{slot}Decoder =\n"
                               f'    suture::fuzz::decoder<{value}, {slot}, {message}>("{space}::{slot}");\n}}\n')
            names.append(name)
    listed = "".join(f"      {name},\n" for name in names)
    text = (f'#include "tests/fuzz/decoder.h"\n\n{"".join(includes)}\n{"".join(definitions)}\n'
            "std::span<const suture::fuzz::Decoder> suture::fuzz::decoders() {\n"
            f"  static const Decoder all[] = {{\n{listed}  }};\n  return all;\n}}\n")
    pathlib.Path(out).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
