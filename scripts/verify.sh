#!/usr/bin/env bash
# Verifies a case from nothing: installs what is missing, builds boxbeam, runs it.
#
#   scripts/verify.sh [CASE.toml] [arguments of `boxbeam verify`]
#
# Without a case it verifies the sledge rig. Ends with the program's own exit code.
set -u
. "$(dirname "$0")/common.sh"

case=$root/sections/sledge-rig/rig.toml
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  case=$1
  shift
else
  # The shipped case: its report belongs to the project's own reports.
  cd "$root" || exit 4
  case=sections/sledge-rig/rig.toml
fi

case $case in
  # Shipped reports are dated by their last change, so that verifying again leaves them as they are.
  "$root"/sections/* | sections/*) export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(cat "$root/reports/date")}" ;;
esac

install_missing "${packages[@]}"
# Tests and benchmarks need more packages; where scripts/test.sh has configured them, they stay.
if [ ! -f "$root/build/build.ninja" ]; then
  configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=OFF -DBOXBEAM_BENCH=OFF \
    -DBOXBEAM_CHARTS=OFF -DBOXBEAM_PRECOMPILE=ON -DBOXBEAM_BATCHES=ON
fi
build "$root/build" boxbeam

"$root/build/boxbeam" verify "$case" "$@"
code=$?
case $code in
  0) say "Exit 0: all checks pass." ;;
  1) say "Exit 1: the beam does not pass (a check fails, or a gate says not applicable); this is a result, not an error." ;;
  2) say "Exit 2: the case or the command line is wrong; nothing was written." ;;
  3) say "Exit 3: the analysis cannot be done; nothing was written." ;;
  4) say "Exit 4: an output or an external tool failed." ;;
esac
exit $code
