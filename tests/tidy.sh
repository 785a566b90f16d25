#!/usr/bin/env bash
# Runs clang-tidy on the sources that differ from origin/main, or from the commit before where there is none, and for each header that
# differs on a source that includes it: .clang-tidy says what it looks for. It needs the build folder of the preset dev.
#   tests/tidy.sh [--all | FILE...]
set -euo pipefail
cd "$(dirname "$0")/.."
case "${1:-}" in
  --all) exec python3 tests/support/tidy.py build/dev --all ;;
  "")
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=$(git rev-parse --verify --quiet HEAD~) || base=HEAD
    files=$({ git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } | grep -E '\.(cpp|h)$' | sort -u) || true
    ;;
  *) files=$(printf '%s\n' "$@") ;;
esac
printf '%s' "$files" | python3 tests/support/tidy.py build/dev
