#!/usr/bin/env bash
# From a clean clone to Fig. 8(a, b): installs what is missing, builds, runs the main job, names the figures.
# Running it again goes on where it was. Options: -j N (jobs at a time), --results DIR.
cd "$(dirname "$0")"
. cmake/setup.sh

install_missing build
build release -DMPM_TESTS=OFF
say "running studies/collapsibility-radius.toml"
exec build/release/runner/mpmstudy run studies/collapsibility-radius.toml "$@"
