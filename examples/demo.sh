#!/usr/bin/env bash
# Two masters drive two slaves. This script installs what is missing, builds and runs. For options see --help.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
Usage: examples/demo.sh [options]

Installs the Debian packages that are missing, builds, and runs the teleoperation demo: two masters drive two slaves
at 1 kHz, and the run is judged. Exit status 0 only if all went well.

  --topology NAME|FILE.json      one of those below (default fig3c), or a deployment file of your own
  --compare NAME NAME            run nothing, but print what differs between two topologies, by their files alone
  --lane auto|shm|frame|rpc      how connections travel: the fastest that fits, shared memory, frames, Cap'n Proto RPC (default auto)
  --network auto|unix|tcp|tls|namespaces
                                 what processes talk over: TLS between a network namespace for each process (auto, as root), TCP
                                 on loopback (auto, as anybody else), Unix sockets (auto with --lane shm), or TLS on loopback
  --break PROCESS@TIME           cut a process off during the run, vision@4s or vision@4s+1500ms: its cable is pulled, or without
                                 namespaces it is frozen. The arms that depend on it have to hold, and not to jump
  --stop TIME                    press the emergency stop during the run, 6s or 6s+1500ms; both slaves have to hold, and not to jump
  --seconds N                    how long to run (default 10); with four arms it records 2.5 MB a second below TMPDIR
  --rate HZ                      cycles of teleoperations a second (default 1000). Arms and their drives run 1.5 times as often;
                                 cameras and what looks at their images keep their periods, and connections keep their max_age
  --dynamics Lag|RigidBody       what the drives simulate: joints without mass (as in the files), or bodies that have mass
  --json FILE                    also write all figures to FILE
  --picture FILE                 where a knot is placed: write the scene at the end as the endoscope sees it, and how the knot
                                 came to its target, and the processes with the ages of what went between them, as a PNG

Topologies, which are the deployment files in examples/teleoperation:
HELP
  for file in "$root"/examples/teleoperation/*.json; do
    printf '  %-12s %s\n' "$(basename "$file" .json)" "$(sed -n 's/^  "title": "\(.*\)",$/\1/p' "$file")"
  done
}

build() (
  cd "$root"
  mkdir -p build
  echo "Configuring"
  cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log >&2; return 1; }
  cmake --build --preset release --target suture-demo
)

for argument in "$@"; do
  case "$argument" in -h | --help) usage; exit 0 ;; esac
done
if [ ! -e "$root/CMakePresets.json" ]; then  # this is an installed copy, and the demo is installed too
  exec "$root"/../../../bin/suture-demo "$@"
fi
# suturec's LLVM 19 is not needed: without it the committed generated/ is compiled.
"$root/.ci/install" build
build
exec "$root"/build/release/bin/suture-demo "$@"
