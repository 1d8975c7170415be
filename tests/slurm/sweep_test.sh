#!/usr/bin/env bash
# A sweep on a cluster of four virtual nodes gives the scores of a local one, byte for byte: one node is killed on the
# way, then the sweep itself, and then a part of the results is lost.
#   sweep_test.sh <cogslam>      77: skipped, and why
set -euo pipefail
PATH=$PATH:/usr/sbin
program=$1
source "$(dirname -- "${BASH_SOURCE[0]}")/cluster.sh"

reason=$(no_cluster)
if [[ -n $reason ]]; then
  echo "skipped: $reason"
  exit 77
fi

folder=$(mktemp -d)
trap 'set +e; stop_cluster "$folder/cluster"; rm -rf "$folder"' EXIT
mkdir "$folder/cluster"

fail() {
  echo "FAILED: $*" >&2
  cat "$folder"/*.err >&2 || true
  tail -n 20 "$folder"/cluster/slurmctld.log >&2
  exit 1
}

cat >"$folder/room.yaml" <<'YAML'
name: room
duration_s: 12
world: {kind: simple, start: {x_m: 0, y_m: -1.3, heading_deg: 0}}
drive: {waypoints: [{x_m: 1, y_m: -1.3}, {x_m: 1, y_m: 1.3}, {x_m: -1, y_m: 0}]}
sensors: {camera: {enabled: false}}
slam: {particles: 50}
YAML
cat >"$folder/sweep.yaml" <<'YAML'
seeds: {count: 6}
worlds: [{scenario: room.yaml}]
variants:
  - {name: og, slam: {store: {kind: dense}}}
  - {name: cog, slam: {store: {kind: coefficients, percent_kept: 20}}}
YAML
episodes=24

sweep() {
  "$program" sweep "$folder/sweep.yaml" --out "$folder/$1" "${@:2}" >"$folder/$1.out" 2>>"$folder/$1.err"
}
on_slurm() { sweep "$1" --engine slurm --chunk 4 --poll-ms 300; }
results_in() { find "$folder/$1/episodes" -name '*.json' 2>/dev/null | wc -l; }
same_scores() { cmp "$folder/local/scores.csv" "$folder/$1/scores.csv" || fail "$1: other scores"; }

started=$SECONDS
sweep local || fail "the local sweep"
start_cluster "$folder/cluster"
echo "$((SECONDS - started)) s: cluster up"

# One node dies while it works.
on_slurm cluster_run &
sweep_id=$!
for ((i = 0; i < 600; ++i)); do
  kill -0 "$sweep_id" 2>/dev/null || fail "it ended before a node could be killed"
  [[ $(results_in cluster_run) -ge 3 && -n $(processes_of "$folder/cluster" n2) ]] && break
  sleep 0.05
done
[[ -n $(processes_of "$folder/cluster" n2) ]] || fail "nothing runs on n2"
kill_node "$folder/cluster" n2
echo "$((SECONDS - started)) s: n2 killed after $(results_in cluster_run) of $episodes results"
wait "$sweep_id" || fail "the sweep with a node killed"
same_scores cluster_run
[[ $(results_in cluster_run) -eq $episodes ]] || fail "not $episodes results"
echo "$((SECONDS - started)) s: same scores"

# The sweep is killed; the next one waits for its array, and submits none of its own.
on_slurm killed_run &
sweep_id=$!
for ((i = 0; i < 600; ++i)); do
  [[ -e $folder/killed_run/slurm/job ]] && break
  sleep 0.05
done
kill -9 "$(pgrep -P "$sweep_id")"  # the program is the child of the shell in the background
wait "$sweep_id" 2>/dev/null || true
on_slurm killed_run || fail "the sweep after one that was killed"
same_scores killed_run
[[ ! -e $folder/killed_run/slurm/2 ]] || fail "a second array, though the first was at work"
echo "$((SECONDS - started)) s: same scores after kill -9 of the sweep"

# Only what is missing is submitted again.
rm "$folder/killed_run/sweep.sqlite" $(find "$folder/killed_run/episodes" -name '*.json' | head -n 5)
on_slurm killed_run || fail "the sweep with results missing"
same_scores killed_run
[[ $(cat "$folder"/killed_run/slurm/2/*.jobs | wc -l) -eq 5 ]] || fail "not the 5 missing episodes"
echo "$((SECONDS - started)) s: same scores with only what was missing submitted"
