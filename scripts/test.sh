#!/usr/bin/env bash
# Builds everything and runs all tests; installs what is missing first.
#
#   scripts/test.sh [arguments of ctest, for example -R sledge]
set -u
. "$(dirname "$0")/common.sh"

install_missing "${packages[@]}" "${test_packages[@]}"
configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_BENCH=ON \
  -DBOXBEAM_PRECOMPILE=ON
build "$root/build" all

say "Running the tests"
ctest --test-dir "$root/build" --output-on-failure -j "$(nproc)" "$@"
