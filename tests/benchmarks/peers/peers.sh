#!/usr/bin/env bash
# boxbeam beside Simbody, scipy and CalculiX, all in one go: installs what is missing, builds, runs
# the experiments by turns and draws them. Some minutes.
#
#   tests/benchmarks/peers/peers.sh [OUTPUT_FOLDER [rig|linkages|toggle|beams]...]
#
# The folder is reports/accuracy/peers where none is given.
set -u
. "$(dirname "$0")/../../../scripts/common.sh"

install_missing "${packages[@]}" "${test_packages[@]}" libsimbody-dev calculix-ccx python3-scipy \
  python3-numpy python3-mpmath
# As scripts/test.sh configures, so that both use the same folder.
configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_BENCH=ON
# A folder configured before Simbody was installed does not know the target.
if ! ninja -C "$root/build" -t query boxbeam_peers >/dev/null 2>&1; then
  cmake "$root/build" >&2 || { say "Configuring failed."; exit 4; }
fi
build "$root/build" boxbeam boxbeam_peers

say "Running the comparison"
# Debian's own Python, which its packages belong to.
/usr/bin/python3 "$(dirname "$0")/peers.py" "$root/build" "$@"
