#!/usr/bin/env bash
# Everything: installs what is missing, builds, runs all tests, then the runtime's suite under the sanitizers.
#   tests/run.sh            what CI runs
#   tests/run.sh dev        only one of the presets dev, tsan, asan
set -euo pipefail
cd "$(dirname "$0")/.."
.ci/install tests

presets=("${@:-}")
[ -n "${presets[0]}" ] || presets=(tsan asan dev)

for preset in "${presets[@]}"; do
  echo "=== $preset: build"
  cmake --preset "$preset" --log-level=WARNING
  # What the sanitizers run waits more than it works; dev's tests compile, and judge control at 1 kHz.
  case "$preset" in
    dev) target=all only=() jobs=$(nproc) ;;
    *) target=runtime_tests only=(-L runtime) jobs=$((2 * $(nproc))) ;;
  esac
  cmake --build --preset "$preset" -j "$(nproc)" --target "$target" -- --quiet
  echo "=== $preset: test"
  ctest --preset "$preset" -j "$jobs" "${only[@]}"
done
