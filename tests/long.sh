#!/usr/bin/env bash
# What takes too long for every push: suturec under AddressSanitizer and UBSan on 10,000 mutated headers and on all its
# tests, and ten minutes of fuzzing.
#   tests/long.sh [MUTANTS] [SECONDS]
set -euo pipefail
cd "$(dirname "$0")/.."
mutants=${1:-10000} seconds=${2:-600}
.ci/install tests

# LLVM's libraries are not built for the sanitizers and keep what they allocate until the process ends, as compilers do. So
# leaks are not looked for; every other finding ends the run.
export ASAN_OPTIONS=detect_leaks=0

cmake --preset asan-compiler --log-level=WARNING
cmake --build --preset asan-compiler -j "$(nproc)" --target suturec lock_test check_test emit_test -- --quiet
build=build/asan-compiler
for test in lock_test check_test emit_test; do "$build/bin/$test" --gtest_brief=1; done
eigen=$(pkg-config --variable=prefix eigen3)/include/eigen3
python3 tests/compiler/errors/errors_test.py "$PWD/$build/bin/suturec" "$eigen" --mutants "$mutants"

cmake --preset dev --log-level=WARNING
cmake --build --preset dev --target fuzzers -- --quiet
build/dev/tests/fuzz/lock_fuzz -max_total_time="$seconds" -max_len=8192 -timeout=10 \
  -artifact_prefix=build/dev/tests/fuzz/ build/dev/tests/fuzz/corpus
