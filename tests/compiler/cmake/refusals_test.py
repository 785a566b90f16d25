"""Tests what suture_generate() refuses, each with the words that tell what to do: refusals_test.py --scratch S."""

import argparse
import pathlib
import re

from scratch import HERE, TREE, empty, expect, run

REFUSALS = [
    ("suture_generate(TARGET code HEADER a.h)", r"unknown argument 'HEADER.*it takes TARGET, HEADERS"),
    ("suture_generate(TARGET code HEADERS)", r"no HEADERS|'HEADERS' has no value"),
    ("suture_generate(HEADERS a.h)", r"no TARGET; name the library"),
    ("suture_generate(TARGET missing HEADERS a.h)", r"no target 'missing'; call it after add_library"),
    ("suture_generate(TARGET code::alias HEADERS a.h)", r"an alias; use the target itself, 'code'"),
    ("suture_generate(TARGET imported HEADERS a.h)", r"imported; its own project generates"),
    ("suture_generate(TARGET interface HEADERS a.h)", r"compiles nothing"),
    ("suture_generate(TARGET elsewhere HEADERS a.h)", r"belongs to .*below; call it there"),
    ("suture_generate(TARGET code HEADERS missing.h)", r"there is no header .*missing\.h"),
    ("suture_generate(TARGET code HEADERS a.h INSTALL_DIR /usr/include)", r"INSTALL_DIR '/usr/include' is absolute; give"),
    ("suture_generate(TARGET code LOADABLE HEADERS a.h)", r"LOADABLE and STATIC_LIBRARY; .* add_library\(code SHARED \.\.\.\)"),
    ("suture_generate(TARGET code HEADERS a.h a.h)", r"a\.h is in HEADERS twice; list it once"),
    ("suture_generate(TARGET code HEADERS a.h LOCK_PATH /nowhere)", r"no folder '/nowhere' of LOCK_PATH; give"),
    ("suture_generate(TARGET code HEADERS b.hpp)", r"b\.hpp does not end with \.h"),
    ("suture_generate(TARGET code HEADERS a.h BASE_DIR below)", r"not below BASE_DIR"),
    ("set(SUTUREC_EXECUTABLE /nowhere/suturec)\nsuture_generate(TARGET code HEADERS a.h)",
     r"SUTUREC_EXECUTABLE '/nowhere/suturec' does not exist; give the path"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET code HEADERS a.h)",
     r"called twice for 'code'; give all HEADERS"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET other HEADERS a.h)",
     r"belongs to target 'code' already; link to that"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET other BASE_DIR below HEADERS below/a.h)",
     r"below/a\.h and .*refusals/a\.h of target 'code' would both be known as a\.h; give both .* BASE_DIR \$\{PROJECT_SOURCE_DIR\}"),
    ("file(CREATE_LINK ${CMAKE_SOURCE_DIR}/a.h ${CMAKE_BINARY_DIR}/linked.h SYMBOLIC)\n"
     "suture_generate(TARGET code BASE_DIR ${CMAKE_BINARY_DIR} HEADERS ${CMAKE_BINARY_DIR}/linked.h)",
     r"linked\.h is a link to .*refusals/a\.h; give that file"),
]


def refuses(folder, call, words):
    case = folder / "case.cmake"
    case.write_text(call + "\n", encoding="utf-8")
    status, text = run(["cmake", "-S", HERE / "refusals", "-B", folder / "build", "-G", "Ninja",
                        f"-DSUTURE_CMAKE={TREE / 'compiler' / 'cmake'}", f"-DCASE={case}"])
    found = re.search(words, re.sub(r"\s+", " ", text))
    expect(status != 0 and found, "refuses " + call.replace("\n", " and "), text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    folder = empty(parser.parse_args().scratch / "refusals")
    for call, words in REFUSALS:
        refuses(folder, call, words)


if __name__ == "__main__":
    main()
