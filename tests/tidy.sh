#!/usr/bin/env bash
# Runs clang-tidy on the sources that differ from origin/main, or from the commit before where there is none: .clang-tidy says what
# it looks for. It needs the build folder of the preset dev.
#   tests/tidy.sh [--all | FILE...]
set -euo pipefail
cd "$(dirname "$0")/.."
case "${1:-}" in
  --all) exec python3 tests/support/tidy.py build/dev --all ;;
  "")
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=$(git rev-parse --verify --quiet HEAD~) || base=HEAD
    sources=$({ git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } | grep '\.cpp$' | sort -u) || true
    ;;
  *) sources=$(printf '%s\n' "$@") ;;
esac
printf '%s' "$sources" | python3 tests/support/tidy.py build/dev
