#!/usr/bin/env bash
# Runs tests of the preset dev, which is built, again and again beside two busy loops for each processor, and prints what fell.
#   tests/steady.sh N [ARGUMENT OF CTEST...]     such as: tests/steady.sh 10 -R 'stepped|deployment'
set -euo pipefail
cd "$(dirname "$0")/.."
rounds=${1:?how often}
shift

loops=()
for ((i = 0; i < 2 * $(nproc); ++i)); do
  while :; do :; done &
  loops+=($!)
done
log=$(mktemp)
trap 'kill "${loops[@]}"; rm -f "$log"' EXIT

fell=0
for ((round = 1; round <= rounds; ++round)); do
  ctest --preset dev -j "$(nproc)" --no-tests=error "$@" >"$log" 2>&1 && continue
  fell=$((fell + 1))
  echo "=== round $round"
  cat "$log"
done
echo "$((rounds - fell)) of $rounds rounds passed."
[ "$fell" = 0 ]
