#!/usr/bin/env bash
# Says where the minutes of the last tests/run.sh went: builds, tests, tiers, and the slowest 20, of all presets or of those named.
#   tests/timing.sh [--summary] [PRESET...]
exec python3 "$(dirname "$0")/support/timing.py" "$(dirname "$0")/../build" "$@"
