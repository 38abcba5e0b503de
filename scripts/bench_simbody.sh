#!/usr/bin/env bash
# The sledge rig in Simbody beside boxbeam: installs what is missing, builds and runs the comparison.
# The last lines are its tables.
#
#   scripts/bench_simbody.sh [INSTANTS PER PERIOD ...]     (24 96 384 where none is given)
set -u
. "$(dirname "$0")/common.sh"

install_missing "${packages[@]}" "${test_packages[@]}" libsimbody-dev
# As scripts/test.sh configures, so that both use the same folder.
configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_BENCH=ON
# A folder configured before Simbody was installed does not know the target.
if ! ninja -C "$root/build" -t query boxbeam_simbody >/dev/null 2>&1; then
  cmake "$root/build" >&2 || { say "Configuring failed."; exit 4; }
fi
build "$root/build" boxbeam_simbody

say "Running the comparison (about a minute)"
"$root/build/tests/benchmarks/boxbeam_simbody" "$@"
