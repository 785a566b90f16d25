#!/usr/bin/env bash
# Plants one fault after another in a copy of the tree, and requires the fast tier to find each.
#   tests/planted.sh [FAULT...]      lost_wake_up dropped_credit swapped_order silent_heartbeat missing_fence
#                                    endless_lease forgotten_cut
#   tests/planted.sh --plant-only    builds nothing: tells whether each fault can still be planted
set -euo pipefail
cd "$(dirname "$0")/.."

# The first case that fails is enough: under some faults each of a shard's hundreds waits to the end of its patience.
export GTEST_FAIL_FAST=1

# plant FAULT: replaces a text of a source, which must be there exactly once.
plant() {
  case "$1" in
    lost_wake_up) replace runtime/suture/component/required/command_sender.cpp \
      '  attachment_.owner().ringLater(*channel.ends.provider);
  return Errc{};' '  return Errc{};' ;;
    dropped_credit) replace runtime/suture/rt/queue/mailbox.cpp \
      'credits.store(credits.load(std::memory_order_relaxed) + 1' \
      'credits.store(credits.load(std::memory_order_relaxed) + (lastReturned_ % 8 == 7 ? 0 : 1)' ;;
    swapped_order) replace runtime/suture/rt/queue/mailbox.cpp \
      'record->sequence < earliest->sequence' 'record->sequence > earliest->sequence' ;;
    silent_heartbeat) replace runtime/suture/session/client/heartbeat.cpp \
      'watch->look(present, begun);
    return look();' 'watch->look(present, begun);
    return kj::Promise<void>(kj::READY_NOW);' ;;
    missing_fence) replace runtime/suture/rt/queue/spsc_ring.h \
      'shared_->tail.store(tail_, std::memory_order_release)' \
      'shared_->tail.store(tail_, std::memory_order_relaxed)' ;;
    endless_lease) replace runtime/suture/component/channel/channel_provider.cpp \
      'looksAtClock && lease.lapsed()' 'looksAtClock && false' ;;
    forgotten_cut) replace runtime/suture/lane/client_end.cpp \
      '  channel_->client.cut();
' '' ;;
    *) echo "there is no planted fault '$1'" >&2; exit 2 ;;
  esac
}

replace() {
  python3 - "$tree/$1" "$2" "$3" <<'PYTHON'
import sys
path, old, new = sys.argv[1:]
text = open(path, encoding="utf-8").read()
if text.count(old) != 1:
    sys.exit(f"{path} has {text.count(old)} times what a fault is to replace:\n{old}\nSay in tests/planted.sh what it has now.")
open(path, "w", encoding="utf-8").write(text.replace(old, new))
PYTHON
}

all=(lost_wake_up dropped_credit swapped_order silent_heartbeat missing_fence endless_lease forgotten_cut)

if [ "${1:-}" = --plant-only ]; then
  tree=$(mktemp -d)
  trap 'rm -r "$tree"' EXIT
  cp -r runtime "$tree"
  for fault in "${all[@]}"; do plant "$fault"; done
  exit
fi

tree=$PWD/build/planted
trap 'git worktree remove --force "$tree"' EXIT
git worktree add --force --detach "$tree" HEAD >/dev/null
faults=("$@")
[ $# -gt 0 ] || faults=("${all[@]}")

missed=()
for fault in "${faults[@]}"; do
  git -C "$tree" checkout --quiet -- .
  plant "$fault"
  cmake -S "$tree" --preset dev --log-level=WARNING >/dev/null
  cmake --build "$tree/build/dev" -j "$(nproc)" --target fast_tests -- --quiet
  # A fault may make a test wait for ever; the first program that fails is enough.
  if found=$(ctest --test-dir "$tree/build/dev" -L fast -j "$((2 * $(nproc)))" --stop-on-failure --timeout 120 2>&1); then
    missed+=("$fault")
  else
    echo "$fault is found by: $(sed -nE 's/^[[:space:]]*[0-9]+ - ([^ ]+) \(.*/\1/p' <<<"$found" | tr '\n' ' ')"
  fi
done
[ ${#missed[@]} -eq 0 ] || { echo "The fast tier does not find: ${missed[*]}" >&2; exit 1; }
