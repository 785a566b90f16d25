#!/usr/bin/env bash
# Installs what is missing, builds, and runs a tier of the tests; README.md says what each tier is for.
#   tests/run.sh                       what CI runs: dev, then the runtime's suite under tsan and asan
#   tests/run.sh dev|tsan|asan...      only these
#   tests/run.sh fast                  what a change is tried with before it is pushed
set -euo pipefail
cd "$(dirname "$0")/.."
.ci/install tests

presets=("$@")
[ $# -gt 0 ] || presets=(dev tsan asan)

# A preset's minutes are kept beside its build for tests/timing.sh, and printed also when a test failed.
trap 'tests/timing.sh --summary "${presets[@]/fast/dev}"' EXIT
timed() {  # timed FILE COMMAND...
  local file=$1 begin=$SECONDS status=0
  shift
  "$@" || status=$?
  echo $((SECONDS - begin)) >"$file"
  return $status
}

# run_tier PRESET TARGET TESTS [ARGUMENT OF CTEST...]; TESTS are those that run at a time, for each processor.
run_tier() {
  local preset=$1 target=$2 tests=$3 records=build/$1/Testing
  shift 3
  echo "=== $preset: build $target"
  mkdir -p "$records/cases"
  rm -f "$records"/seconds.* "$records"/cases/*.json "$records/tests.xml"
  cmake --preset "$preset" --log-level=WARNING >/dev/null
  timed "$records/seconds.build" cmake --build --preset "$preset" -j "$(nproc)" --target "$target" -- --quiet
  echo "=== $preset: test"
  timed "$records/seconds.test" ctest --preset "$preset" -j $((tests * $(nproc))) --output-junit Testing/tests.xml "$@"
}

for preset in "${presets[@]}"; do
  case "$preset" in
    dev) run_tier dev all 3 -LE long ;;
    fast)
      run_tier dev fast_tests 3 -L fast
      tests/tidy.sh
      ;;
    *) run_tier "$preset" runtime_tests 2 -L runtime ;;
  esac
done
