#!/usr/bin/env bash
# From a clean clone to every figure of the paper and its claims, judged: installs what is missing, builds, runs all
# studies, writes results/report.html. Running it again goes on where it was.
# Ends with 0 once every study is run and the page is written, also if single jobs failed (coarse cells lose some of
# the fastest shots of a search): the page, the tables above it and `mpmstudy status` show those. 75 if work is left.
#   ./reproduce.sh           coarse cells (0.14 um; Figs. 1 and 4 0.2 um)
#   ./reproduce.sh --full    fine cells (0.05 um; Figs. 1 and 4 0.07 um)
# Other options go to `mpmstudy run`: -j N (jobs at a time), --results DIR.
cd "$(dirname "$0")"
. cmake/setup.sh

cells=1.4 audit="5 %"
options=() results=()
while [ $# -gt 0 ]; do
  case $1 in
    --full) cells=0.5 audit="3 %" ;;
    --results) results=(--results "$2"); shift ;;
    *) options+=("$1") ;;
  esac
  shift
done
studies=(two-body-jet strong-collapse critical-speed critical-speed-spall weak-collapse symmetry block-height
         collapsibility-radius collapsibility-yield scale-invariance planar-impact)
files=("${studies[@]/#/studies/paper/}")
files=("${files[@]/%/.toml}")

install_missing build
build release -DMPM_TESTS=OFF
say "running ${#files[@]} studies, cells times $cells"
build/release/runner/mpmstudy run "${files[@]}" --cells "$cells" --audit "$audit" "${results[@]}" "${options[@]}" || {
  code=$?
  [ $code -eq 1 ] || exit $code  # 1: some jobs failed; the page shows which
}
say "claims"
exec build/release/runner/mpmstudy report "${files[@]}" "${results[@]}"  # as they have just been run
