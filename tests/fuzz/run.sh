#!/bin/bash
# Fuzzes the four targets for SECONDS in all, two at a time: run.sh SECONDS [BUILD_FOLDER]
# What is new goes to BUILD_FOLDER/found/TARGET, what crashes or hangs to BUILD_FOLDER/found/TARGET-*.
# Exit code 0: no crash, no hang (10 s), no report of a sanitizer.
#   run.sh merge [BUILD_FOLDER]: the smallest part of what was found that covers what the corpus here does not,
# under names that begin with found_, into the corpus.
set -u
here=$(cd "$(dirname "$0")" && pwd)
build=${2:-build/fuzz}
declare -A longest=([study]=4096 [quantity]=64 [query]=512 [catalog]=4096)

merge() {
  for target in "${!longest[@]}"; do
    corpus=$here/corpus/$target new=$build/found/$target-new
    rm -rf "$new" && cp -r "$corpus" "$new"
    "$build/tests/fuzz/fuzz_$target" -merge=1 "$new" "$build/found/$target" > "$build/found/$target-merge.log" 2>&1
    for file in "$new"/*; do
      name=$(basename "$file")
      [ -e "$corpus/$name" ] || cp "$file" "$corpus/found_${name:0:10}"
    done
    echo "$target: $(ls "$corpus" | wc -l) inputs"
  done
}
[ "$1" = merge ] && { merge; exit; }

fuzz() {  # TARGET
  local target=$1 found=$build/found/$1 dictionary=()
  mkdir -p "$found"
  [ -e "$here/$target.dict" ] && dictionary=(-dict="$here/$target.dict")
  "$build/tests/fuzz/fuzz_$target" -max_total_time=$((seconds / 4)) -timeout=10 -rss_limit_mb=2048 \
    -max_len="${longest[$target]}" "${dictionary[@]}" -print_final_stats=1 -artifact_prefix="$found-" \
    "$found" "$here/corpus/$target" > "$found.log" 2>&1
  local code=$?
  echo "$target: $(sed -n 's/stat::number_of_executed_units: *//p' "$found.log") executions," \
    "$(ls "$found" | wc -l) new inputs, $(ls "$found"-{crash,leak,timeout,oom}-* 2> /dev/null | wc -l) crashes or hangs"
  return $code
}
seconds=$1 code=0
(fuzz study; a=$?; fuzz quantity && exit $a) & first=$!
(fuzz query; a=$?; fuzz catalog && exit $a) & second=$!
wait $first || code=1
wait $second || code=1
exit $code
