#!/bin/bash
# Fuzzes the four targets, one after the other, for SECONDS in all: run.sh SECONDS [BUILD_FOLDER]
# What is new goes to BUILD_FOLDER/found/TARGET, what crashes or hangs to BUILD_FOLDER/found/TARGET-*.
# Exit code 0: no crash, no hang (10 s), no report of a sanitizer.
set -u
seconds=$1 build=${2:-build/fuzz}
here=$(cd "$(dirname "$0")" && pwd)
code=0
for target in study quantity query catalog; do
  found=$build/found/$target
  mkdir -p "$found"
  "$build/tests/fuzz/fuzz_$target" -max_total_time=$((seconds / 4)) -timeout=10 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="$found-" "$found" "$here/corpus/$target" > "$found.log" 2>&1 || code=1
  echo "$target: $(sed -n 's/stat::number_of_executed_units: *//p' "$found.log") executions," \
    "$(ls "$found" | wc -l) new inputs, $(ls "$found"-* 2> /dev/null | wc -l) crashes or hangs"
done
exit $code
