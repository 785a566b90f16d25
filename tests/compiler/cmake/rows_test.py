"""Tests what runs and what is rewritten after each kind of change: rows_test.py ROW... --generator G --package P --scratch S."""

import argparse
import pathlib
import shutil
import sys

from scratch import HERE, Project, empty, expect, is_idle, run, runs_of_suturec


def stops_without_lock(project):
    status, text = project.build()
    expect(status != 0 and "[suture-lock-missing]" in text and "--target update-lock" in text,
           "without a lock the build stops and says what to run", text)
    expect(not any("count" in p.parts for p in project.times()), "a failed run writes nothing", str(project.times()))
    project.must_build("update-lock", "update-lock")
    expect((project.root / "schemas/count/counter.capnp").exists(), "update-lock writes the lock")


def no_change(project):
    text = project.must_build("builds again")
    expect(is_idle(text), "no change: nothing runs", text)


def touched_header(project):
    before = project.times()
    (project.root / "watch/watch.h").touch()
    text = project.must_build("builds")
    expect(runs_of_suturec(text) == ["watch"], "a touched header: one run, of its target", text)
    expect("capnp " not in text and project.times() == before, "and no generated file is rewritten", text)
    no_change(project)


def edited_comment(project):
    before = project.times()
    project.edit("count/sample.h", "namespace scratch {\n\n", "namespace scratch {\n\n// A plain comment.\n\n")
    text = project.must_build("builds")
    expect(sorted(runs_of_suturec(text)) == ["count", "watch"], "a comment edited: one run a target that reads it", text)
    expect("capnp " not in text and project.times() == before, "and no generated file is rewritten", text)
    no_change(project)


def transitive_header(project):
    before = project.times()
    (project.root / "count/limits.h").touch()
    text = project.must_build("builds")
    expect(sorted(runs_of_suturec(text)) == ["count", "watch"], "a header that others include: one run a target", text)
    expect(project.times() == before, "and no generated file is rewritten", text)
    no_change(project)
    project.edit("count/limits.h", "inline constexpr int", "int broken(\ninline constexpr int")
    status, text = project.build()
    expect(status != 0 and "limits.h" in text, "an error in it stops the build", text)


def new_field(project):
    before = project.times()
    project.edit("count/sample.h", "double value = 0;", "double value = 0;\n  double weight = 1;")
    status, text = project.build()
    expect(status != 0 and "[suture-lock-new]" in text, "a new field: the build stops until the lock has it", text)
    expect(project.times() == before, "and writes nothing")
    project.must_build("update-lock takes the field", "update-lock")
    text = project.must_build("builds")
    rewritten = {p.name for p, time in project.times().items() if before.get(p) != time}
    expect({"sample.suture.h", "sample.capnp.h"} <= rewritten, "the field is generated", text + str(rewritten))
    no_change(project)


WAYS = (
    "target_compile_definitions(count PRIVATE MORE_0)",
    "target_compile_definitions(count PRIVATE $<$<COMPILE_LANGUAGE:CXX>:MORE_1>)",
    "target_compile_options(count PRIVATE -DMORE_2 \"SHELL:-Wall -include count/more_3.h\")",
    "set_target_properties(count PROPERTIES COMPILE_FLAGS \"-Wall -DMORE_4\")",
    "set(CMAKE_CXX_FLAGS \"-Wall -D MORE_5\")",
    "set(CMAKE_BUILD_TYPE Debug)",
    "set(CMAKE_CXX_FLAGS_DEBUG \"-g -DMORE_6\")",
)


def grow_with_macros(project):
    fields = "".join(f"\n#ifdef MORE_{n}\n  double more{n} = 0;\n#endif" for n in range(7))
    project.edit("count/sample.h", "double value = 0;", "double value = 0;" + fields)


def changed_define(project):
    """A header sees the macros of its target, by whatever way they come: with others, it is read again."""
    before = project.times()
    grow_with_macros(project)
    (project.root / "count/more_3.h").write_text("#define MORE_3\n", encoding="utf-8")
    text = project.must_build("builds")
    expect(project.times() == before, "a field behind an undefined macro changes nothing", text)
    ways = "\n".join(WAYS) + "\n"
    project.edit("CMakeLists.txt", "suture_generate(TARGET count", ways + "suture_generate(TARGET count")
    status, text = project.build("count_suture")
    unseen = [n for n in range(7) if f"Sample::more{n}' is not in the lock" not in text]
    expect(status != 0 and not unseen, "changed macros: suturec runs anew", f"{unseen} of MORE_ are not seen\n{text}")
    project.edit("CMakeLists.txt", ways, "")
    project.must_build("and again when they are taken back")


def configurations(project):
    """Each configuration of a build has macros of its own, and suturec sees them."""
    grow_with_macros(project)
    project.edit("CMakeLists.txt", "suture_generate(TARGET count", "target_compile_definitions(count PRIVATE "
                 "$<$<CONFIG:Debug>:MORE_0> $<$<COMPILE_LANGUAGE:CXX>:OTHER>)\nsuture_generate(TARGET count")
    several = Project(project.root, project.package, "Ninja Multi-Config")
    several.build_folder = project.root / "several"
    several.configure()
    several.must_build("a configuration without the macro builds", "count_suture", "--config", "Release")
    status, text = several.build("count_suture", "--config", "Debug")
    expect(status != 0 and "Sample::more0' is not in the lock" in text, "and one with it does not", text)


def added_header(project):
    (project.root / "count/more.h").write_text(
        "#pragma once\n#include <suture/annotate.h>\nnamespace scratch {\n"
        "struct SUTURE_TYPE() More { double value = 0; };\n}\n", encoding="utf-8")
    project.edit("CMakeLists.txt", "HEADERS count/sample.h", "HEADERS count/more.h count/sample.h")
    project.must_build("update-lock takes an added header", "update-lock")
    text = project.must_build("builds")
    expect(any(p.name == "more.suture.h" for p in project.times()), "an added header is generated", text)
    no_change(project)


def many_sources(project):
    """A big header gives several sources of each kind, which together define what one would."""
    project.edit("count/counter.h", "}  // namespace scratch",
                 "struct SUTURE_TYPE() Pair {\n  Sample first;\n  std::optional<double> second;\n};\n\n"
                 "class SUTURE_INTERFACE() Pairs {\n public:\n  virtual ~Pairs() = default;\n"
                 "  SUTURE_COMMAND() virtual void add(const Pair& pair) = 0;\n};\n\n}  // namespace scratch")
    project.edit("count/counter.h", "#include \"count/sample.h\"", "#include <optional>\n\n#include \"count/sample.h\"")
    (project.root / "watch/main.cpp").write_text(
        "#include \"count/counter.suture.h\"\n\nint main() {\n  const auto bytes = suture::encode(scratch::Pair{{2}, 3});\n"
        "  scratch::Pair pair;\n  if (!bytes || !suture::decode(*bytes, pair) || pair.second != 3) return 1;\n"
        "  return suture::interfaceInfo<scratch::Counter>().codec == suture::interfaceInfo<scratch::Pairs>().codec ? 1 : 0;\n}\n",
        encoding="utf-8")
    project.edit("CMakeLists.txt", "suture_generate(TARGET count",
                 "add_executable(main watch/main.cpp)\ntarget_link_libraries(main PRIVATE count)\nsuture_generate(TARGET count")
    project.configure("-DSUTURE_DECLARATIONS_PER_SOURCE=1")
    project.must_build("update-lock takes a type and a contract more", "update-lock")
    text = project.must_build("builds")
    names = {p.name for p in project.times()}
    expect({"counter.suture.3.cpp", "counter.wire.3.cpp"} <= names and "sample.suture.3.cpp" not in names,
           "a header with more to it gives more sources", str(sorted(names)))
    wire = project.build_folder / "generated-wire/count"
    parts = [wire / f"counter.wire{number}.capnp.h" for number in ("", ".2", ".3")]
    expect(all(part.exists() for part in parts), "and capnp compiles its schema in parts", str(sorted(p.name for p in wire.iterdir())))
    status, text = run([project.build_folder / "main"])
    expect(status == 0, "and a program has all that they define", text)
    no_change(project)


def removed_output(project):
    before = set(project.times())
    for ending in ("suture.h", "suture.cpp", "capnp"):
        (project.build_folder / f"generated/count/counter.{ending}").unlink()
    (project.build_folder / "generated-wire/count/counter.capnp.h").unlink()
    text = project.must_build("builds")
    expect(set(project.times()) == before, "removed outputs come back", text)
    no_change(project)


def stale_output(project):
    """No generated file is ever read back, whatever it holds."""
    generated = project.build_folder / "generated/count/counter.suture.h"
    good = generated.read_text(encoding="utf-8")
    generated.write_text("#error stale\n", encoding="utf-8")
    (project.root / "watch/watch.h").touch()
    (project.root / "count/sample.h").touch()
    text = project.must_build("builds over a broken generated file")
    expect(generated.read_text(encoding="utf-8") == good, "and replaces it", text)


def buried_message(project):
    """What suturec says stands last, and Ninja's lines before it are short, whatever the number of headers."""
    project.edit("count/sample.h", "  double value = 0;", "  SUTURE_FIELD(unit(\"parsec2000\")) double value = 0;")
    status, text = project.build()
    expect(status != 0 and "[suture-unknown-unit]" in text, "suturec fails", text)
    begin = text.index("] suturec count")
    before = text[begin:text.index(f"{project.root}/count/sample.h:", begin)]
    for folder in (project.build_folder, project.package):
        before = before.replace(str(folder), "")
    expect(len(before) < 250, "the message is not buried", text)
    project.edit("count/sample.h", "SUTURE_FIELD(unit(\"parsec2000\")) ", "")
    project.must_build("a repaired header builds")


def bad_header(project):
    """Builds with one bad header of a target: nothing of the others is written, and nothing is half-written."""
    before = project.times()
    project.edit("count/sample.h", "namespace scratch {", "namespace scratch {\nint broken(")
    status, text = project.build()
    expect(status != 0 and project.times() == before, "suturec fails: all generated files stay", text)
    project.edit("count/sample.h", "\nint broken(", "")
    project.must_build("a repaired header builds")


def interrupted(project):
    """suturec fails while it writes: the last of its files cannot take its place."""
    project.edit("count/counter.h", "virtual Sample sum", "virtual Sample last() const = 0;\n  SUTURE_COMMAND() virtual Sample sum")
    project.edit("count/sample.h", "double value = 0;", "double value = 0;\n  double weight = 1;")
    project.must_build("update-lock takes both", "update-lock")
    blocked = project.build_folder / "generated/count/sample.suture.cpp"
    blocked.unlink()
    (blocked / "in the way").mkdir(parents=True)
    before = project.times()
    status, text = project.build()
    expect(status != 0 and "cannot write" in text and "sample.suture.cpp" in text, "it names the file", text)
    expect(project.times() == before, "no file is rewritten", text)
    expect(not list(project.build_folder.rglob("*.tmp*")), "no temporary file is left")
    shutil.rmtree(blocked)
    text = project.must_build("builds when the way is free")
    expect("weight" in blocked.read_text(encoding="utf-8"), "and writes it", text)


def capnp_interrupted(project):
    """Cap'n Proto's plugin fails when half of a file is written."""
    plugin = project.root / "half"
    plugin.write_text("#!/bin/sh\nmkdir -p count; echo half > count/sample.capnp.h; exit 1\n", encoding="utf-8")
    plugin.chmod(0o755)
    project.edit("count/sample.h", "double value = 0;", "double value = 0;\n  double weight = 1;")
    project.must_build("update-lock takes a field", "update-lock")
    wire = project.build_folder / "generated-wire/count/sample.capnp.h"
    good = wire.read_text(encoding="utf-8")
    project.configure(f"-DCAPNPC_CXX_EXECUTABLE={plugin}")
    status, text = project.build()
    expect(status != 0 and wire.read_text(encoding="utf-8") == good, "the good file stays", text)
    project.configure("-UCAPNPC_CXX_EXECUTABLE")
    project.must_build("builds when the plugin is well")
    expect("Weight" in wire.read_text(encoding="utf-8"), "and writes it anew")


def compare_committed(project):
    return run(["ctest", "--test-dir", project.build_folder, "--output-on-failure", "--no-tests=error", "-R", "check-generated"])


def committed(project):
    status, text = compare_committed(project)
    expect(status != 0 and "No tests were found" in text, "where nothing is committed, nothing is compared", text)
    project.must_build("update-generated copies", "update-generated")
    expect((project.root / "watch/generated/watch/watch.suture.h").exists(), "into the project of each header")
    project.configure()
    status, text = compare_committed(project)
    expect(status == 0 and "out of 2" in text, "check-generated passes on equal files, once a project", text)
    project.edit("watch/generated/watch/watch.suture.h", "#pragma once", "#pragma once  // of before")
    status, text = compare_committed(project)
    expect(status != 0 and "update-generated" in text, "and fails on a difference", text)
    left_over = project.root / "generated/count/old.suture.h"
    left_over.write_text("", encoding="utf-8")
    status, text = compare_committed(project)
    expect(status != 0 and "count/old.suture.h is generated from no header" in text, "and names a left-over", text)


def generated_header(project):
    """A header that a build step writes is one of those that suturec waits for."""
    project.edit("count/numbers.in", "3;", "4;")
    text = project.must_build("builds")
    expect(sorted(runs_of_suturec(text)) == ["count", "watch"], "the input of a build step: one run a target", text)
    no_change(project)


# The first rows begin in a project that has been configured, the others in one that has been built.
CONFIGURED = {"no_lock": stops_without_lock}
BUILT = {row.__name__: row for row in (no_change, touched_header, edited_comment, transitive_header, new_field,
                                       changed_define, configurations, added_header, removed_output, stale_output,
                                       bad_header, buried_message, many_sources, interrupted, capnp_interrupted,
                                       generated_header, committed)}


def fails(name, row, project, kept):
    """Returns True if a row fails that begins with what was kept, at the place and with the times of then."""
    shutil.rmtree(project.root)
    shutil.copytree(kept, project.root, symlinks=True)
    print(f"{name}:", flush=True)
    try:
        row(project)
    except SystemExit as failure:
        print(failure, flush=True)
        return True
    return False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("rows", nargs="+", choices=[*CONFIGURED, *BUILT])
    parser.add_argument("--generator", default="Ninja")
    parser.add_argument("--package", type=pathlib.Path, required=True)
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    # Ccache splits a path at its space: what it tells of the headers of one project is served to the next, and must hold there.
    own = f"{arguments.generator.split()[-1]}-{arguments.rows[0]}"
    root = empty(arguments.scratch / own / "a project")
    shutil.copytree(HERE / "project", root, dirs_exist_ok=True)
    project = Project(root, arguments.package, arguments.generator)
    failed = []

    def try_rows(rows):
        kept = root.with_name(root.name + " kept")
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(root, kept, symlinks=True)
        failed.extend(name for name in arguments.rows if name in rows and fails(name, rows[name], project, kept))
        shutil.rmtree(root)
        kept.rename(root)

    project.configure()
    try_rows(CONFIGURED)
    project.must_build("update-lock", "update-lock")
    project.must_build("builds")
    try_rows(BUILT)
    if failed:
        sys.exit("FAILED: " + " ".join(failed))


if __name__ == "__main__":
    main()
