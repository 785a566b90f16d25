#!/usr/bin/env bash
# Runs what takes too long for every push: the tests labelled long (docs/tests.md lists them), suturec under AddressSanitizer and
# UBSan on 10,000 mutated headers and on all its tests, ten minutes of each fuzzer, a minute of stress on each part between
# threads, a thousand restarts of a peer, a million changed sessions, twenty rounds of faults between processes, ten minutes of
# faults of messages, ten random contracts, a thousand random headers, each scenario of conformance on each row that
# is possible, a million seeds of the explorer, two hundred orders of threads under each freeze, the planted faults, a build in
# which each source is compiled by itself, the whole grid of the experiment over a link and six of its points in real time, and
# the demo as a newcomer runs it.
#   tests/long.sh [MUTANTS] [SECONDS]
set -euo pipefail
cd "$(dirname "$0")/.."
mutants=${1:-10000} seconds=${2:-600}
.ci/install long

# A source that does not include all that it uses is hidden by its neighbours in a unit of the presets' builds.
cmake --preset dev -B build/alone -DCMAKE_UNITY_BUILD=OFF --log-level=WARNING
cmake --build build/alone -- --quiet

cmake --preset asan-compiler --log-level=WARNING
cmake --build --preset asan-compiler -j "$(nproc)" --target suturec lock_test check_test emit_test -- --quiet
build=build/asan-compiler
for test in lock_test check_test emit_test; do "$build/bin/$test" --gtest_brief=1; done
eigen=$(pkg-config --variable=prefix eigen3)/include/eigen3
python3 tests/compiler/errors/errors_test.py "$PWD/$build/bin/suturec" "--flags=-isystem;$eigen" --mutants "$mutants"

cmake --preset dev --log-level=WARNING
cmake --build --preset dev --target fuzzers -- --quiet
export build=$PWD/build/dev seconds
printf '%s\n' lock deployment frames shared handshake generated golden | xargs -P "$(nproc)" -I{} bash -o pipefail -c '
  cd "$build/tests/fuzz"
  ./{}_fuzz -max_total_time="$seconds" -max_len=8192 -timeout=10 -artifact_prefix=found/{}_ \
    found/{} corpus/{} 2>&1 | sed -u "s/^/{}: /"'

# The tiers leave this test out under the sanitizers, since they have an allocator and locks of their own, and it needs the arm.
for preset in tsan asan; do
  cmake --preset $preset --log-level=WARNING
  cmake --build --preset $preset --target task_thread_test -- --quiet
  "build/$preset/bin/task_thread_test" --gtest_brief=1
done

cmake --build --preset dev -- --quiet
SUTURE_CONFORMANCE=full "$build/bin/conformance_test" --gtest_brief=1
SUTURE_SEEDS=1000000 "$build/bin/explorer_test" --gtest_filter='*NewSeeds*' --gtest_brief=1
tests/planted.sh
ctest --preset dev -j "$(nproc)" -L long
for seed in {1..200}; do
  SUTURE_TEST_SEED=$seed "$build/bin/manager_test" --gtest_filter='*FrozenProcess*:*Ttl*:*Stop*' --gtest_brief=1 || { echo "seed $seed"; exit 1; }
done
SUTURE_STRESS_SECONDS=60 "$build/bin/stress_test" --gtest_brief=1
SUTURE_SESSIONS=1000000 "$build/bin/fault_test" --gtest_filter=Sessions.*
SUTURE_RECONNECTS=1000 "$build/bin/fault_test" --gtest_filter='*Restarts.ManyRestartsOfAPeer*'
SUTURE_FAULT_SECONDS=20 "$build/bin/stepped_fault_test" --gtest_filter='*Messages*' --gtest_brief=1
for _ in {1..20}; do SUTURE_FAULT_ROUNDS=3 "$build/bin/fault_test" --gtest_filter='*Kill.*:*Stop.*:*Proxy.*:Lanes/Stopped*' --gtest_brief=1; done
for _ in {1..20}; do "$build/bin/stepped_fault_test" --gtest_filter='*Messages*' --gtest_brief=1; done
for _ in {1..10}; do python3 tests/integration/random_contract/random_contract.py --suture "$build"; done
python3 tests/integration/random_contract/random_headers_test.py --suture "$build" --headers 1000
"$build/bin/suture-experiment" --csv "$build/experiment.csv" --png "$build/experiment.png"
if [ "$(id -u)" = 0 ]; then
  "$build/bin/suture-experiment" --real-time
else
  echo "skipped: suture-experiment --real-time makes network namespaces, which needs root"
fi
examples/demo.sh --seconds 5
