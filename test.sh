#!/usr/bin/env bash
# Installs what is missing, builds, runs every test. Options go to ctest: ./test.sh -L fast
#   ./test.sh --sanitize address    the same under the address and undefined-behaviour sanitizers
#   ./test.sh --sanitize thread     ... the thread sanitizer
cd "$(dirname "$0")"
. cmake/setup.sh

preset=release
if [ "${1:-}" = --sanitize ]; then
  case ${2:-} in
    address) preset=asan ;;
    thread) preset=tsan ;;
    *) echo "--sanitize address, or --sanitize thread" >&2; exit 2 ;;
  esac
  shift 2
fi
install_missing build test slurm
build "$preset" -DMPM_TESTS=ON
say "testing"
# One more than there are processors: tests of a cluster and of time-outs mostly wait.
exec ctest --preset "$preset" -j "$(($(nproc) + 1))" "$@"
