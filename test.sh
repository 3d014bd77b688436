#!/usr/bin/env bash
# Installs what is missing, builds, runs every test. Options go to ctest: ./test.sh -L fast
cd "$(dirname "$0")"
. cmake/setup.sh

install_missing build test slurm
build release -DMPM_TESTS=ON
say "testing"
exec ctest --preset release -j "$(nproc)" "$@"
