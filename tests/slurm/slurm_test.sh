#!/bin/bash
# A study through a real Slurm: elements requeued and killed, the controller killed, shards merged twice; at the
# end the catalog is that of a run on one machine, bit for bit.  slurm_test.sh PROGRAM FAULT_HARNESS STUDY
set -u
program=$1 harness=$2 study=$3
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
  "$here/mini_slurm.sh" down
  if [ $failures -gt 0 ]; then
    echo "left: $work"
    cat "$work"/results/slurm/*/log-*.txt 2>/dev/null | tail -40
  else
    rm -rf "$work"
  fi
}

"$here/mini_slurm.sh" up 2 || exit $?
trap cleanup EXIT

set_options=(--set 'cell_size=0.15 um')
results=$work/results
"$program" run "$study" "${set_options[@]}" --results "$work/calm" -q || wrong "the undisturbed run"

text=$("$program" run "$study" "${set_options[@]}" --results "$results" --engine slurm --dry-run)
expect "a dry run prints the scripts" "$text" '#SBATCH --array=0-'
[ -e "$results" ] && wrong "a dry run writes"

# 16 jobs in 4 elements of one processor each.
submit=("$program" run "$study" "${set_options[@]}" --results "$results" --engine slurm -j 1 --shards 4 --shard-time 0.1)
text=$("${submit[@]}") || wrong "submitting: $text"
expect "the study is submitted" "$text" 'submitted: array [0-9]+, merge [0-9]+'
array=$(sed -n 's/^submitted: array \([0-9]*\),.*/\1/p' <<< "$text")
expect "status shows the queue" "$("$program" status --results "$results")" "array $array: . of 4 shards whole"
expect "what is in the queue is not submitted again" "$("${submit[@]}")" 'what is left is in the queue'

state_of() { squeue -h -r -j "${array}_$1" -o %t 2>/dev/null; }
wait_until_running() { for _ in $(seq 200); do [ "$(state_of "$1")" = R ] && return; sleep 0.1; done; }
processes_of() {  # of an element of the array
  for p in /proc/[0-9]*; do
    { tr '\0' '\n' < "$p/environ"; } 2>/dev/null | grep -qx "SLURM_ARRAY_TASK_ID=$1" && echo "${p#/proc/}"
  done
}
wait_until_running 0
scontrol requeue "${array}_0" && check "element 0 is requeued"
wait_until_running 1
kill -9 $(processes_of 1) && check "element 1 is killed"
"$here/mini_slurm.sh" kill-controller && check "the controller is killed"
sleep 1
"$here/mini_slurm.sh" start-controller

for _ in $(seq 600); do
  left=$("$program" query "SELECT count(*) FROM jobs WHERE status <> 'done'" --format csv --results "$results" | tail -1 | tr -d '\r')
  fits=$("$program" query "SELECT count(*) FROM fits" --format csv --results "$results" | tail -1 | tr -d '\r')
  [ "$left" = 0 ] && [ "$fits" != 0 ] && break
  sleep 0.5
done
if [ "$left" = 0 ]; then check "every job is done"; else wrong "$left jobs are left"; fi
rounds=$(ls -d "$results"/slurm/*/ | wc -l)
if [ "$rounds" -gt 1 ]; then check "what was killed came in another round"; else wrong "one round was enough"; fi

# Elements that Slurm runs twice, and shards merged twice, change nothing.
first=$(ls -d "$results"/slurm/*/ | head -1)
for i in 0 1 2 3; do
  SLURM_ARRAY_TASK_ID=$i SLURM_JOB_ID=99$i bash "$first/array.sh" >/dev/null || wrong "element $i again"
done
text=$("$program" merge "$first"/shard-? --results "$results") || wrong "merging again: $text"
expect "merging again changes nothing" "$text" '^0 jobs merged, 16 known already'
"$harness" --compare "$work/calm" "$results" || wrong "the catalog differs from the undisturbed one"
ls "$results"/slurm/*/*.tmp 2>/dev/null && wrong "halves are left"
exit $((failures > 0))
