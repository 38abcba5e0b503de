#!/usr/bin/env bash
# Writes a long record of six channels and verifies the beam under it; says wall seconds and peak memory.
#
#     tests/benchmarks/long_record.sh [INSTANTS [doubles]]       default 10000000, 16-bit integers
set -euo pipefail
cd "$(dirname "$0")/../.."
ninja -C build boxbeam long_record >/dev/null
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build/tests/benchmarks/long_record "$folder" "$@"
status=0
/usr/bin/time -f "%e s, %M kB of memory at most, %U s of processors" \
  build/boxbeam verify "$folder/case.toml" --no-plots --no-pdf --out "$folder/report" || status=$?
# The beam fails or does not apply: that is no fault of the measurement.
[ "$status" -le 1 ]
