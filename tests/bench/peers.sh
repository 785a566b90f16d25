#!/usr/bin/env bash
# Suture beside its peers: installs what is missing, builds, measures all by turns, and writes tables and a chart.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source=$root/tests/bench/peers

usage() {
  cat <<'HELP'
Usage: tests/bench/peers.sh [options]

Installs the Debian packages that are missing, builds the peers, installs Suture from this checkout into a folder of its own
and builds its peer against that as any user would, then runs all by turns. Writes peers.md, peers.csv, peers.json and peers.png.

  --quick      fewer messages, some four minutes
  --check      exit status 1 if a bound of tests/bench/peers/bounds.txt is not kept
  --out DIR    where results go (default build/peers/results)
  --build DIR  where everything is built (default build/peers)

A quiet machine is wanted. What has no package, does not start or hangs is a row that says so.
HELP
}

build=$root/build/peers out='' arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --quick | --check) arguments+=("$1") ;;
    --out) out=${2:?--out needs a folder} && shift ;;
    --build) build=${2:?--build needs a folder} && shift ;;
    --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
  shift
done
build=$(realpath -m "$build")
out=${out:-$build/results}

is_installed() { dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null | grep -q '^ii'; }

# Installs the packages; one that cannot be had leaves out its peer alone.
install_packages() {
  local package missing=() sudo=''
  while read -r package; do is_installed "$package" || missing+=("$package"); done < <(grep -v '^#' "$source/packages.txt")
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing: ${missing[*]}" >&2
  [ "$(id -u)" -eq 0 ] || sudo=sudo
  $sudo apt-get update -qq || true
  for package in "${missing[@]}"; do
    # sudo passes no variable of the environment on.
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$package" >/dev/null ||
      echo "$package cannot be installed" >&2
  done
}

# The robot components are not measured, so they are not built.
install_suture() (
  cd "$root"
  cmake --preset release -B "$build/suture" --log-level=WARNING >/dev/null
  cmake --build "$build/suture" --target suturec suture-manager suture_cli suture_deploy suture_record suture_schemas \
    suture_testing -- --quiet >&2
  cmake --install "$build/suture" --prefix "$build/prefix" --component suture >/dev/null
)

# Builds the peers. A peer that does not compile is a row that says so, since what an earlier build left must not be
# measured in its place.
build_peers() {
  rm -rf "$build/project/bin"
  cmake -S "$source" -B "$build/project" -G Ninja -DCMAKE_PREFIX_PATH="$build/prefix" --log-level=WARNING >/dev/null
  cmake --build "$build/project" -- -k 0 --quiet >&2 || echo "Some peers do not compile" >&2
}

"$root/.ci/install" compiler
install_packages
install_suture
build_peers
# It starts suture-manager; the chart needs the modules of Debian's own Python.
export PATH=$build/prefix/bin:$PATH
exec /usr/bin/python3 -B "$source/report/run.py" --programs "$build/project/bin" --out "$out" "${arguments[@]}"
