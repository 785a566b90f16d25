"""Random nested types with the names of others, every row of the mapping table: generated and compiled in one batch, by
two compilers, and values taken through them.

  random_types_test.py --suture BUILD [--seed N] [--keep DIR]
"""

import os
import pathlib
import shutil
import sys

import random_contract
import random_types

COUNT = 12  # structs


def declarations(types, name):
    wire, slot = types.wire(name), types.slot(name)
    return (f"void toWire(const {slot}&, wire::{wire}::Builder);\n"
            f"suture::Errc fromWire(wire::{wire}::Reader, {slot}&, suture::Duration);\n"
            f"bool isValid(const {slot}&, suture::FieldPath* = nullptr);\n")


def check(types, name):
    """Returns the lines that check one struct, and each of its members that has a bound with one element too many."""
    lines = ["  {", f'    RoundTrip<{name}, {types.slot(name)}, wire::{types.wire(name)}> trip("{name}");',
             f"    checkAll(trip, random, {name}());"]
    for field in types.structs[name]:
        if field.bounds:
            bounds = ", ".join(map(str, field.bounds))
            lines += [f"    trip.checkBeyond(random, []({name}& value, Random& source) {{",
                      f"      constexpr unsigned all[] = {{{bounds}}};", "      Bounds bounds = all;",
                      f"      fill(value.{field.name}, source, bounds);", "    });"]
    return lines + ["    beyond += trip.beyond();", "  }"]


def program(types, seed):
    # The functions of types in other namespaces are found where they are declared, which is before they are called.
    lines = ['#include "invented.suture.h"', '#include "invented_values.h"', '#include "round_trip.h"',
             '#include "invented.capnp.h"', "", "namespace invented {", "",
             *(declarations(types, name) for name in types.structs), "}  // namespace invented", "", "int main() {",
             "  using namespace invented;", f"  Random random({seed});", "  int beyond = 0;"]
    for name in types.structs:
        lines += check(types, name)
    lines += [f'  std::printf("{COUNT} types, %d members refused one too many\\n", beyond);',
              "  return beyond > 0 ? 0 : 1;", "}", ""]
    return "\n".join(lines)


def main():
    with random_contract.project() as (options, folder):
        types = random_types.Types(options.seed, COUNT, data_only=True)
        for name in ("values.h", "round_trip.h"):
            shutil.copy(pathlib.Path(__file__).with_name(name), folder)
        (folder / "CMakeLists.txt").write_text(random_contract.CMAKE)
        (folder / "main.cpp").write_text(program(types, options.seed))
        (folder / "invented.h").write_text(types.header())
        (folder / "invented_values.h").write_text(types.values())
        # The second compiler finds the lock as the first has left it.
        for compiler in ("g++", "clang++-19"):
            random_contract.build(folder, options.suture.resolve(), compiler)
            random_contract.run([folder / "build" / "invented"], timeout=300)
            shutil.rmtree(folder / "build")


if __name__ == "__main__":
    os.environ.pop("CXXFLAGS", None)
    sys.exit(main())
