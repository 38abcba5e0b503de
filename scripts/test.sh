#!/usr/bin/env bash
# Builds everything and runs all tests; installs what is missing first.
#
#   scripts/test.sh [arguments of ctest, for example -R sledge]
#   BOXBEAM_BROWSER=ON scripts/test.sh        also tests the HTML reports in Chromium
#   BOXBEAM_OPTIONS="-D.. .." scripts/test.sh  further options of CMake
set -u
. "$(dirname "$0")/common.sh"

browser=${BOXBEAM_BROWSER:-OFF}
install_missing "${packages[@]}" "${test_packages[@]}"
if [ "$browser" = ON ]; then install_missing chromium; fi
configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_BENCH=ON \
  -DBOXBEAM_CHARTS=ON -DBOXBEAM_PRECOMPILE=ON -DBOXBEAM_BATCHES=ON -DBOXBEAM_BROWSER="$browser" ${BOXBEAM_OPTIONS:-}
build "$root/build" all

if [ "$browser" != ON ]; then say "Left out: the HTML reports in Chromium (BOXBEAM_BROWSER=ON scripts/test.sh)"; fi
say "Running the tests"
ctest --test-dir "$root/build" --output-on-failure -j "$(nproc)" "$@"
