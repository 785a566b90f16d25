#!/usr/bin/env bash
# run.sh [SECONDS [PROGRAMS]] runs each process of deployment.json in a network namespace of its own, with a cable to a bridge.
# To the programs a namespace is a machine of its own. All of it is gone when this script ends.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
seconds=${1:-5}
programs=${2:-$here/../../build/release/bin}

# This script itself moves into a namespace: that of the bridge and of the manager. Its processes and mounts are its own too, so
# that nothing outlives it.
if [ "${INSIDE:-}" = "" ]; then
  if [ "$(id -u)" != 0 ] || ! unshare --net --mount ip link add try type bridge 2>/dev/null; then
    echo "skipped: network namespaces and a bridge between them need root, and ip from iproute2" >&2
    exit 77
  fi
  INSIDE=yes exec unshare --net --mount --pid --fork --kill-child --mount-proc "$0" "$seconds" "$programs"
fi
work=$(mktemp -d)
trap 'umount "$work"/*.net; rm -rf "$work"' EXIT

ip link set lo up
ip link add bridge type bridge
ip addr add 10.213.9.1/24 dev bridge
ip link set bridge up

# add_machine NAME ADDRESS makes a namespace, which a file keeps, and a cable NAME from it to the bridge.
add_machine() {
  touch "$work/$1.net"
  unshare --net="$work/$1.net" ip link set lo up
  nsenter --net="$work/$1.net" ip link add eth0 type veth peer name "$1" netns $$
  nsenter --net="$work/$1.net" ip addr add "$2/24" dev eth0
  nsenter --net="$work/$1.net" ip link set eth0 up
  ip link set "$1" master bridge up
}
add_machine console 10.213.9.2
add_machine arm 10.213.9.3
add_machine screen 10.213.9.4

# Machines talk by TLS, so each process must prove who it is. The keys lie beside the deployment.
cp "$here/deployment.json" "$work"
"$programs/suture" keys --deployment "$work/deployment.json" --out "$work/keys" >/dev/null

# start NAME OPTION... makes this shell that process, in that namespace.
start() {
  exec nsenter --net="$work/$1.net" "$programs/06_one_arm" --deployment "$work/deployment.json" --process "$@"
}
"$programs/suture-manager" --listen tls://10.213.9.1:7700 --keys "$work/keys" >/dev/null &
start console & console=$!
start arm & arm=$!
(start screen --seconds "$seconds")
kill $console
wait $console
kill $arm
wait $arm
