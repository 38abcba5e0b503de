#!/usr/bin/env bash
# Compares the program with an oracle that looks everywhere (tests/oracle), over random cases.
#
#   scripts/oracle.sh [CASES [SEED [FOLDER]]]
#
# CASES (10000) cases from number SEED (1) on, at full density: 2000 stations and every cut on both
# sides, 200 places around the section, 2000 instants. Says how many disagree and by how much; those
# that do stay in FOLDER (build/oracle) as cases for `boxbeam verify`. Runs on all cores; what is done
# is not done again: the folder keeps the outcome of every hundred cases.
# DENSITY=coarse for a quick look. Exit code 0: all agree.
set -u
. "$(dirname "$0")/common.sh"

cases=${1:-10000}
seed=${2:-1}
folder=${3:-$root/build/oracle}
density=${DENSITY:-full}
oracle=$root/build/tests/boxbeam_oracle
# What scripts/verify.sh has configured has no tests.
if ! grep -qs boxbeam_oracle "$root/build/build.ninja"; then
  install_missing "${packages[@]}" "${test_packages[@]}"
  configure "$root/build" -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_CHARTS=ON \
    -DBOXBEAM_PRECOMPILE=ON
fi
build "$root/build" boxbeam_oracle
# Of another program nothing is known yet.
folder=$folder/$(sha256sum "$oracle" | cut -c 1-12)
mkdir -p "$folder"

# A hundred at a time; each answers in a file of its own, which is there only when it is complete.
run_hundred() {
  local from=$1 count=$2 log="$folder/$density-$1-$2.txt"
  [ -f "$log" ] && return
  "$oracle" --from "$from" --cases "$count" --density "$density" --keep "$folder" > "$log.part"
  [ $? -le 1 ] && mv "$log.part" "$log"
}
export -f run_hundred
export oracle folder density
for ((from = seed; from < seed + cases; from += 100)); do
  left=$((seed + cases - from))
  echo "$from $((left < 100 ? left : 100))"
done | xargs -P "$(nproc)" -L 1 bash -c 'run_hundred "$0" "$1"'

say "Random cases $seed to $((seed + cases - 1)), density $density"
python3 "$root/tests/oracle/summary.py" "$seed" "$cases" "$density" "$folder"
