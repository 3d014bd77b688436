#!/bin/bash
# Studies through a real Slurm: elements requeued, held and killed, the controller killed, shards merged twice, a
# search in rounds; at the end the catalogs are those of runs on one machine, bit for bit.
#   slurm_test.sh PROGRAM FAULT_HARNESS STUDY SEARCH
# Nothing is waited for without an end.
set -u
program=$1 harness=$2 study=$3 search=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d /tmp/mpmstudy-slurm-XXXXXX)
export MINI_SLURM=$work/slurm SLURM_CONF=$work/slurm/slurm.conf
failures=0
check() { echo "ok: $1"; }
wrong() { echo "FAILED: $*"; failures=$((failures + 1)); }
expect() {  # WHAT TEXT PATTERN
  if grep -Eq -- "$3" <<< "$2"; then check "$1"; else wrong "$1: '$2' has no '$3'"; fi
}
cleanup() {
  [ $failures -gt 0 ] && squeue -r -o '%i %j %t %r'
  timeout 30 "$here/mini_slurm.sh" down
  if [ $failures -gt 0 ]; then
    echo "left: $work"
    cat "$work"/*/*/slurm/*/log-*.txt 2>/dev/null | tail -40
  else
    rm -rf "$work"
  fi
}
run() { timeout 240 "$program" "$@"; }

timeout 90 "$here/mini_slurm.sh" up 2
code=$?
if [ $code -ne 0 ]; then
  rm -rf "$work"
  [ $code -eq 124 ] && echo "skipped: a Slurm does not start here in 90 s"
  exit 77
fi
trap cleanup EXIT

set_options=(--set 'cell_size=0.15 um')
results="$work/my runs/50%j it's \"5\" #1"  # a folder as users name them
run run "$study" "${set_options[@]}" --results "$work/calm" -q || wrong "the undisturbed run"

text=$(run run "$study" "${set_options[@]}" --results "$results" --engine slurm --dry-run)
expect "a dry run prints the scripts" "$text" '#SBATCH --array=0-'
[ -e "$results" ] && wrong "a dry run writes"

# 16 jobs in 6 elements of one processor each; four run at a time.
submit=(run run "$study" "${set_options[@]}" --results "$results" --engine slurm -j 1 --shards 6 --shard-time 0.1
  --slurm=--time=2)  # a controller that comes back may think that an element still runs: for as long as this
text=$("${submit[@]}") || wrong "submitting: $text"
expect "the study is submitted" "$text" 'submitted: array [0-9]+, merge [0-9]+'
array=$(sed -n 's/^submitted: array \([0-9]*\),.*/\1/p' <<< "$text")
scontrol hold "${array}_4" && scontrol hold "${array}_5" || wrong "holding elements"
text=$(run status --results "$results")
expect "status shows the queue" "$text" "array $array: . of 6 shards whole"
expect "status shows what is held" "$text" '\(2 held: `scontrol release`'
scancel "${array}_4" && check "element 4 is cancelled"  # on a slow machine, element 1 may end before it is killed
expect "what is in the queue is not submitted again" "$("${submit[@]}")" '16 jobs in the queue already'

state_of() { squeue -h -r -j "${array}_$1" -o %t 2>/dev/null; }
wait_until_running() { for _ in $(seq 200); do [ "$(state_of "$1")" = R ] && return; sleep 0.1; done; }
processes_of() {  # of an element of the array
  for p in /proc/[0-9]*; do
    { tr '\0' '\n' < "$p/environ"; } 2>/dev/null | grep -qx "SLURM_ARRAY_TASK_ID=$1" && echo "${p#/proc/}"
  done
}
wait_until_running 0
scontrol update JobId="${array}_0" Requeue=1 && scontrol requeue "${array}_0" && check "element 0 is requeued"
wait_until_running 1
for _ in $(seq 50); do
  processes=$(processes_of 1)
  [ -n "$processes" ] && break
  sleep 0.1
done
kill -9 $processes && check "element 1 is killed"
sleep 6  # the controller writes its state down every few seconds; an older one knows less than the nodes
"$here/mini_slurm.sh" kill-controller && check "the controller is killed"
sleep 1
text=$("${submit[@]}" 2>&1)  # element 5 is held, so the study has not ended
[ $? = 75 ] || wrong "a Slurm that does not answer: $text"
expect "a Slurm that does not answer is not taken for an empty queue" "$text" 'not known whether it is in the queue'
"$here/mini_slurm.sh" start-controller
for _ in $(seq 100); do
  scontrol release "${array}_5" 2>/dev/null && check "element 5 is released" && break
  sleep 0.5
done

number() { run query "$1" --format csv --results "$results" | tail -1 | tr -d '\r'; }
wait_until() {  # SECONDS SQL: until it gives something other than 0
  for _ in $(seq $((2 * $1))); do
    [ "$(number "$2")" != 0 ] && return 0
    sleep 0.5
  done
  return 1
}
finished="SELECT (SELECT count(*) FROM jobs WHERE status <> 'done') = 0 AND (SELECT count(*) FROM fits) > 0"
if wait_until 240 "$finished"; then check "every job is done"; else wrong "jobs are left"; fi
rounds=$(ls -d "$results"/slurm/*/ | wc -l)
if [ "$rounds" -gt 1 ]; then check "what was lost came in another round"; else wrong "one round was enough"; fi

# Elements that Slurm runs twice, and shards merged twice, change nothing.
first=$(ls -d "$results"/slurm/*/ | head -1)
for i in 0 1 2 3 4 5; do
  SLURM_ARRAY_TASK_ID=$i SLURM_JOB_ID=99$i timeout 240 bash "$first/array.sh" >/dev/null || wrong "element $i again"
done
text=$(run merge "$first"/shard-? --results "$results") || wrong "merging again: $text"
expect "merging again changes nothing" "$text" '^0 jobs merged, 16 known already'
timeout 240 "$harness" --compare "$work/calm" "$results" || wrong "the catalog differs from the undisturbed one"
ls "$results"/slurm/*/*.tmp 2>/dev/null && wrong "halves are left"
[ -e "$first/log-0.txt" ] && check "logs are in the folder" || wrong "no log in $first"
expect "nothing is left" "$(run run "$study" "${set_options[@]}" --results "$results" --engine slurm --dry-run)" \
  'nothing is left to submit'

# A search: each round is an array, and its merge asks for the next.
results=$work/searched
run run "$search" --results "$work/calm-search" -q || wrong "the search on one machine"
text=$(run run "$search" --results "$results" --engine slurm -j 1 --shards 2 --shard-time 0.1 --rounds 1) ||
  wrong "submitting the search: $text"
expect "the search is submitted" "$text" 'submitted: array [0-9]+, merge [0-9]+'
if wait_until 120 "SELECT count(*) FROM critical_speed"; then check "the search ends"; else wrong "the search goes on"; fi
rounds=$(ls -d "$results"/slurm/*/ | wc -l)
if [ "$rounds" -gt 1 ]; then check "in $rounds rounds"; else wrong "in $rounds rounds"; fi
brackets="SELECT * FROM critical_speed ORDER BY position"
[ "$(run query "$brackets" --format csv --results "$results")" = \
  "$(run query "$brackets" --format csv --results "$work/calm-search")" ] || wrong "other brackets"
timeout 240 "$harness" --compare "$work/calm-search" "$results" || wrong "the searched catalogs differ"
exit $((failures > 0))
