"""Tests what suture_generate() refuses, each with the words that tell what to do: refusals_test.py --scratch S."""

import argparse
import pathlib
import re

from scratch import HERE, TREE, empty, expect, run

REFUSALS = [
    ("suture_generate(TARGET code HEADER a.h)", r"suture_generate\(\) has no argument 'HEADER;a\.h'; it takes TARGET, HEADERS"),
    ("suture_generate(TARGET code HEADERS)", r"'HEADERS' has no value; give it one, or leave it out"),
    ("suture_generate(TARGET code)", r"TARGET code\): the call has no HEADERS; list the annotated headers of the target"),
    ("suture_generate(HEADERS a.h)", r"suture_generate\(\) was given no TARGET; write TARGET and the name of the library or executable that owns the headers"),
    ("suture_generate(TARGET missing HEADERS a.h)", r"TARGET is 'missing', but no target has this name yet; call suture_generate\(\) behind its add_library\(\)"),
    ("suture_generate(TARGET code::alias HEADERS a.h)", r"TARGET is 'code::alias', which is an alias; write the name of the target itself, 'code'"),
    ("suture_generate(TARGET imported HEADERS a.h)", r"TARGET is 'imported', which is imported; its own project generates its code, so only link to it"),
    ("suture_generate(TARGET interface HEADERS a.h)", r"TARGET is 'interface', an INTERFACE_LIBRARY, which compiles nothing; give a static"),
    ("suture_generate(TARGET elsewhere HEADERS a.h)", r"TARGET is 'elsewhere', which belongs to .*below; call suture_generate\(\) in the CMakeLists.txt of that folder"),
    ("suture_generate(TARGET code HEADERS missing.h)", r"HEADERS has missing\.h, but there is no file .*missing\.h; correct"),
    ("suture_generate(TARGET code HEADERS a.h INSTALL_DIR /usr/include)", r"INSTALL_DIR is '/usr/include', an absolute path; give one below the install prefix"),
    ("suture_generate(TARGET code LOADABLE HEADERS a.h)", r"TARGET code is to be LOADABLE, but it is a STATIC_LIBRARY; .* write add_library\(code SHARED \.\.\.\)"),
    ("suture_generate(TARGET code HEADERS a.h a.h)", r"HEADERS has a\.h twice; list it once"),
    ("suture_generate(TARGET code HEADERS a.h LOCK_PATH /nowhere)", r"LOCK_PATH names '/nowhere', where there is no folder; give"),
    ("suture_generate(TARGET code HEADERS b.hpp)", r"HEADERS has b\.hpp, which does not end with \.h.*; rename it"),
    ("suture_generate(TARGET code HEADERS a.h BASE_DIR below)", r"HEADERS has .*a\.h, which is not below BASE_DIR .*below; give a BASE_DIR above it"),
    ("set(SUTUREC_EXECUTABLE /nowhere/suturec)\nsuture_generate(TARGET code HEADERS a.h)",
     r"SUTUREC_EXECUTABLE is '/nowhere/suturec', where there is no program; give the path"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET code HEADERS a.h)",
     r"was called for TARGET 'code' before; give all its HEADERS in one call"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET other HEADERS a.h)",
     r"HEADERS has a\.h, which belongs to target 'code'; leave it out, and link to that target"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET other BASE_DIR below HEADERS below/a.h)",
     r"below/a\.h and .*refusals/a\.h of target 'code' would both be known as a\.h; give both .* BASE_DIR \$\{PROJECT_SOURCE_DIR\}"),
    ("file(CREATE_LINK ${CMAKE_SOURCE_DIR}/a.h ${CMAKE_BINARY_DIR}/linked.h SYMBOLIC)\n"
     "suture_generate(TARGET code BASE_DIR ${CMAKE_BINARY_DIR} HEADERS ${CMAKE_BINARY_DIR}/linked.h)",
     r"linked\.h, which is a link to .*refusals/a\.h; give that file"),
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
