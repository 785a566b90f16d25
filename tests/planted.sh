#!/usr/bin/env bash
# Plants one fault after another in a copy of the tree, and requires a test program of the fast tier to find each: it passes
# without the fault and fails with it. Tests of the tree itself do not count, since they also find that a text is another.
#   tests/planted.sh [FAULT...]      lost_wake_up dropped_credit swapped_order silent_heartbeat missing_fence
#                                    endless_lease forgotten_cut unrung_lane
#   tests/planted.sh --plant-only    builds nothing: tells whether each fault can still be planted
set -euo pipefail
cd "$(dirname "$0")/.."

# The first case that fails is enough: under some faults each of a program's hundreds waits to the end of its patience.
export GTEST_FAIL_FAST=1

# finder FAULT: tells which program finds it.
finder() {
  case "$1" in
    lost_wake_up | dropped_credit) echo component_test ;;
    swapped_order) echo rt_test ;;
    silent_heartbeat) echo session_test ;;
    endless_lease | forgotten_cut) echo manager_test ;;
    missing_fence) echo model_test ;;
    unrung_lane) echo testing_test ;;
    *) echo "there is no planted fault '$1'" >&2; exit 2 ;;
  esac
}

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
      'lease.lapsed(*present)' 'false' ;;
    forgotten_cut) replace runtime/suture/lane/client_end.cpp \
      '  channel_->client.cut();
' '' ;;
    unrung_lane) replace runtime/suture/component/provided/command_drain.cpp \
      '  // the client also learns of what has been taken
      owner_.ringLater(*channel_.ends.client);' '' ;;
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

all=(lost_wake_up dropped_credit swapped_order silent_heartbeat missing_fence endless_lease forgotten_cut unrung_lane)

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

build() { cmake --build "$tree/build/dev" -j "$(nproc)" --target "$1" -- --quiet >"$tree/built" || { cat "$tree/built"; exit 1; }; }
passes() { timeout 300 "$tree/build/dev/bin/$1" --gtest_brief=1 >"$tree/found" 2>&1; }

programs=$(for fault in "${faults[@]}"; do finder "$fault"; done | sort -u)
cmake -S "$tree" --preset dev --log-level=WARNING >/dev/null
for program in $programs; do
  build "$program"
  passes "$program" || { cat "$tree/found"; echo "$program fails without any planted fault." >&2; exit 1; }
done

missed=()
for fault in "${faults[@]}"; do
  git -C "$tree" checkout --quiet -- .
  plant "$fault"
  program=$(finder "$fault")
  build "$program"
  status=0
  passes "$program" || status=$?
  if [ $status = 0 ] || [ $status = 124 ]; then
    missed+=("$fault")
  else
    echo "$fault is found by $program: $(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' "$tree/found" | head -1)"
  fi
done
[ ${#missed[@]} -eq 0 ] || { echo "The fast tier does not find: ${missed[*]}" >&2; exit 1; }
