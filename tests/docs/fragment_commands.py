"""Judges the commands of pages without running a system: the programs, verbs, options, targets and files that they name have to exist."""

import functools
import json
import os
import re
import shlex
import subprocess

from fragment_code import Fault

LIMIT = 60  # s; only so that a hang ends the test
SHELL = {"sleep", "kill"}
CMAKE_OPTIONS = {"--preset", "--build", "--install", "--target", "--prefix"}


class Commands:
    """Knows the tree, and the folder of its build, whose programs judge their own options. What they may write goes to `scratch`."""

    def __init__(self, root, build, scratch):
        self._root, self._build = root, build
        self._environment = {**os.environ, "XDG_RUNTIME_DIR": str(scratch)}
        self._scratch = scratch

    def judge(self, text):
        """Raises a Fault at the first command that cannot be given. `text` may have several lines."""
        variables = {}
        for line in text.split("\n"):
            lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
            lexer.whitespace_split = True
            command = []
            for word in [*lexer, ";"]:
                if set(word) <= set(";&|"):
                    self._judge_one(command, variables)
                    command = []
                else:
                    command.append(re.sub(r"\$(\w+)", lambda m: variables.get(m[1], m[0]), word))

    def _judge_one(self, words, variables):
        while words and re.match(r"\w+=", words[0]):
            name, _, value = words.pop(0).partition("=")
            variables[name] = value
        if words and words[0] == "sudo":
            words = words[1:]
        if not words or words[0] in SHELL:
            return
        program, *arguments = words
        if program == "cmake":
            self._judge_cmake(arguments)
        elif built := re.fullmatch(r"build/(\w+)/bin/([\w-]+)", program):
            self._require(built[1] in self._presets(), f"there is no preset '{built[1]}'")
            self._judge_program(built[2], arguments)
        elif "/" in program:
            self._require(os.access(self._root / program, os.X_OK), f"there is no program {program}")
        else:
            self._judge_program(program, arguments)

    def _judge_program(self, name, arguments):
        program = self._build / "bin" / name
        self._require(program.exists(), f"there is no program '{name}'")
        if name == "suture":  # it asks a manager that is not there, if the command line makes sense
            done = self._run([program, *arguments])
            self._require(done.returncode >= 0 and done.returncode != 2, done.stderr.strip() or f"it ended by signal {-done.returncode}")
            return
        for word in arguments:
            if word.startswith("--"):
                self._require(word in self._options(name), f"'{name}' has no option {word}")
        if "--deployment" in arguments:
            kept = [word for one in ("--deployment", "--process") if one in arguments for word in (one, arguments[arguments.index(one) + 1])]
            done = self._run([program, *kept, "--check"], cwd=self._root)
            self._require(done.returncode == 0, done.stderr.strip())
        elif not any(word.startswith("--") for word in arguments):
            source = self._root / "examples" / name / "main.cpp"
            for word in arguments:
                self._require(f'"{word}"' in source.read_text(encoding="utf-8"), f"'{name}' does not know '{word}'")

    def _judge_cmake(self, arguments):
        option = ""
        for word in arguments:
            if word.startswith("-"):
                option = word
                self._require(word in CMAKE_OPTIONS, f"cmake {word} is not known to this test")
            elif option == "--preset":
                self._require(word in self._presets(), f"there is no preset '{word}'")
            elif option == "--target":
                self._require(word in self._targets(), f"there is no target '{word}'")

    def judge_cmake_file(self, text):
        """Raises a Fault at a command that neither CMake nor Suture's package has, at an argument of suture_generate() and at a target."""
        sources = "".join(file.read_text(encoding="utf-8") for file in (self._root / "compiler/cmake").glob("*.cmake"))
        lines = re.sub(r"#.*", "", text)
        known = self._run(["cmake", "--help-command-list"]).stdout.split()
        for command, arguments in re.findall(r"(\w+)\(([^()]*)\)", lines):
            if command not in known:
                self._require(re.search(rf"\b(?:function|macro)\({command}\b", sources), f"there is no command {command}()")
                for word in re.findall(r"\b[A-Z_]{3,}\b", arguments):
                    self._require(re.search(rf"\b{word}\b", sources), f"{command}() has no argument {word}")
        for target in re.findall(r"\bsuture::(\w+)", lines):
            self._require(target in self._exported(), f"there is no target suture::{target}")

    @functools.cache
    def _exported(self):
        files = self._build.glob("Suture*Targets.cmake")
        return {name for file in files for name in re.findall(r"\bsuture::(\w+)", file.read_text(encoding="utf-8"))}

    @functools.cache
    def _presets(self):
        presets = json.loads((self._root / "CMakePresets.json").read_text(encoding="utf-8"))
        return {preset["name"] for preset in presets["buildPresets"]}

    @functools.cache
    def _targets(self):
        return set(re.findall(r"^build ([\w.-]+):", (self._build / "build.ninja").read_text(encoding="utf-8"), re.M))

    @functools.cache
    def _options(self, name):
        return set(re.findall(r"--[\w-]+", self._run([self._build / "bin" / name, "--help"]).stdout))

    def _run(self, call, cwd=None):
        return subprocess.run(call, capture_output=True, text=True, check=False, timeout=LIMIT, cwd=cwd or self._scratch,
                              env=self._environment)

    @staticmethod
    def _require(holds, otherwise):
        if not holds:
            raise Fault(otherwise)
