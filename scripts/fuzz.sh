#!/usr/bin/env bash
# Runs the fuzzers for a time and says executions, coverage and findings; ends with 1 where
# something was found.
#
#   scripts/fuzz.sh [SECONDS] [case|case-reader|history|comparison|signal]...     default: 60, all
#   scripts/fuzz.sh --executions N [case|case-reader|history|comparison|signal]...
#
# The time is shared: half of it goes to whole cases that are verified, the rest to the readers under
# libFuzzer with the address sanitizer. With --executions each of them runs N times, however long
# that takes. Findings stand in build-fuzz/findings.
#   BOXBEAM_FUZZ_SEED=N scripts/fuzz.sh ..     another seed than 1 for the cases
set -u
. "$(dirname "$0")/common.sh"
cd "$root" || exit 4

seconds=60
executions=
if [ "${1:-}" = --executions ]; then
  [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || { echo "--executions wants a number" >&2; exit 2; }
  executions=$2
  shift 2
elif [ $# -gt 0 ] && [[ $1 =~ ^[0-9]+$ ]]; then
  seconds=$1
  shift
fi
wanted=("$@")
[ ${#wanted[@]} -gt 0 ] || wanted=(case case-reader history comparison signal)
jobs=$(nproc)
folder=build-fuzz
findings=$folder/findings
mkdir -p "$findings"

install_missing "${packages[@]}" "${test_packages[@]}" clang-14 libclang-rt-14-dev

# seconds_of NAME: its share.
seconds_of() {
  local rest=0 name
  for name in "${wanted[@]}"; do [ "$name" = case ] || rest=$((rest + 1)); done
  if [ "$1" = case ]; then
    [ $rest -eq 0 ] && echo "$seconds" || echo $((seconds / 2))
  else
    printf '%s\n' "${wanted[@]}" | grep -qx case && echo $((seconds / 2 / rest)) || echo $((seconds / rest))
  fi
}

failed=0
for name in "${wanted[@]}"; do
  share=$(seconds_of "$name")
  [ "$share" -gt 0 ] || share=1
  if [ "$name" = case ]; then
    # In the folder of the tests, whose library is there already.
    if ! grep -qs boxbeam_case_fuzzer build/build.ninja; then
      configure build -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=ON -DBOXBEAM_CHARTS=ON -DBOXBEAM_BENCH=OFF
    fi
    build build boxbeam_case_fuzzer
    how_long=(--time "$share")
    [ -z "$executions" ] || how_long=(--count "$executions")
    build/tests/boxbeam_case_fuzzer "${how_long[@]}" --jobs "$jobs" --seed "${BOXBEAM_FUZZ_SEED:-1}" \
      --out "$findings/case" sections tests/fuzz/corpus/case || failed=1
    continue
  fi
  reader=${name%-reader}
  configure $folder -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++-14 -DBOXBEAM_TESTS=OFF \
    -DBOXBEAM_BENCH=OFF -DBOXBEAM_FUZZ=ON
  build $folder "boxbeam_fuzz_$reader"
  mkdir -p "$findings/$name" "$folder/corpus/$name"
  corpora=("$folder/corpus/$name" "tests/fuzz/corpus/$name")
  longest=4096
  if [ "$reader" = case ]; then
    longest=32768
    rm -rf $folder/corpus/shipped && mkdir -p $folder/corpus/shipped
    for file in sections/*/*.toml; do cp "$file" "$folder/corpus/shipped/${file//\//-}"; done
    corpora+=("$folder/corpus/shipped")
  fi
  limit="-max_total_time=$share"
  [ -z "$executions" ] || limit="-runs=$executions"
  log=$findings/$name.log
  "$folder/tests/fuzz/boxbeam_fuzz_$reader" "$limit" -max_len=$longest -timeout=20 \
    -rss_limit_mb=4096 -print_final_stats=1 -dict="tests/fuzz/$reader.dict" \
    -artifact_prefix="$findings/$name/" "${corpora[@]}" >"$log" 2>&1
  code=$?
  count=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  coverage=$(grep -o 'cov: [0-9]* ft: [0-9]*' "$log" | tail -n 1)
  found=$(find "$findings/$name" -type f -newer "$folder/build.ninja" | wc -l)
  printf '%s reader: %s executions, %s, exit %s, %s findings in %s\n' "$reader" "${count:-0}" \
    "${coverage:-no coverage}" $code "$found" "$findings/$name"
  [ $code -eq 0 ] || { tail -n 30 "$log" >&2; failed=1; }
done
exit $failed
