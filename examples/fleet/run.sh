#!/usr/bin/env bash
# Three robots in two sites share their places through a throw-away PostgreSQL, while this script kills
# and restarts the server and a follower; ends with what each knows. Needs the topobag program and
# `postgresql`.
#   bash examples/fleet/run.sh [FOLDER]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
topobag=${TOPOBAG_PROGRAM:-$root/build/examples/topobag}
bin=$(ls -d /usr/lib/postgresql/*/bin | sort -V | tail -n 1)
folder=${1:-$(mktemp -d)}
port=${PGPORT:-54329}
mkdir -p "$folder/data"
as=()
if [ "$(id -u)" -eq 0 ]; then # PostgreSQL refuses to run as root
  chmod 711 "$folder" && chown nobody "$folder/data"
  as=(setpriv --reuid nobody --regid nogroup --clear-groups)
fi
server() { (cd / && "${as[@]}" "$bin/pg_ctl" -s -w -D "$folder/data" -l "$folder/data/log" "$@"); }
start() { server -o "-p $port -k $folder/data -c listen_addresses=127.0.0.1" start; }
trap 'server -m immediate stop || true; kill $(jobs -p) 2>/dev/null || true' EXIT

(cd / && "${as[@]}" "$bin/initdb" -D "$folder/data" -U owner -A trust >/dev/null)
start
base=postgresql://owner@127.0.0.1:$port/postgres
"$topobag" fleet init "$base?site=hall&site=yard"

# Each robot maps to a file of its own; the file is its outbox, and needs no server.
camera=517.3,516.5,318.6,255.3,640,480
map() { "$topobag" map --nodes "examples/data/$2" --out "$folder/$1.db" --camera "$camera" ${3:+"$3"}; }
map robot1 fr1_xyz
map robot2 fr1_rpy
map robot3 fr1_xyz

follow() { # seconds
  "$topobag" fleet follow "$base?site=hall&site=yard" --seconds "$1" > >(sed -u 's/^/  follower: /') 2>&1 &
  follower=$!
}
follow 60
echo "== two robots push"
"$topobag" fleet push --map "$folder/robot1.db" "$base?site=hall"
"$topobag" fleet push --map "$folder/robot2.db" "$base?site=hall"
sleep 1
echo "== the follower is killed; another one reads what it knew"
kill -9 "$follower"
wait "$follower" 2>/dev/null || true
follow 20
sleep 2
echo "== the server is killed; the third robot can push nothing"
server -m immediate stop
"$topobag" fleet push --map "$folder/robot3.db" "$base?site=yard" || true
echo "== the server is back: everybody goes on where they were"
start
"$topobag" fleet push --map "$folder/robot3.db" "$base?site=yard"
"$topobag" fleet push --map "$folder/robot1.db" "$base?site=hall"
wait "$follower"
sleep 1 # for its last words
echo "== what each knows"
for robot in robot1 robot2 robot3; do
  echo "$robot: $("$topobag" info "$folder/$robot.db" | sed -n 's/^keyframes *//p') key frames of its own"
done
echo "the server:"
"$topobag" fleet status "$base"
echo "== robot 2 was never in the yard; it finds its way there by what robot 3 saw"
"$topobag" localize --map "$base?site=yard" --query examples/data/fr1_rpy --camera "$camera"
