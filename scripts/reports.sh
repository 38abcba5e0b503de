#!/usr/bin/env bash
# Writes the reports of all shipped cases into reports/, the comparisons with published values, and the pages of
# the rig's studies.
#
#   scripts/reports.sh
#
# The reports carry the date of the day on which a change of program or cases last changed them
# (reports/date, in seconds of Unix time), so that running it again changes nothing.
set -u
. "$(dirname "$0")/common.sh"
cd "$root" || exit 4

install_missing "${packages[@]}"
if [ ! -f build/build.ninja ]; then
  configure build -DCMAKE_BUILD_TYPE=Release -DBOXBEAM_TESTS=OFF -DBOXBEAM_BENCH=OFF \
    -DBOXBEAM_CHARTS=OFF
fi
build build boxbeam

# A verification that does not pass is a result; anything above exit 1 is an error.
failed=0
run() {
  say "boxbeam $*"
  build/boxbeam "$@" >/dev/null
  [ $? -le 1 ] || failed=$((failed + 1))
}

# compare CASE TABLE FOLDER
compare() {
  run compare "$1" "$2" --html "$3/comparison.html" --json "$3/comparison.json"
  build/boxbeam compare "$1" "$2" >"$3/comparison.txt"
}

# page COMMAND STUDY FILE: of what it writes the page alone is kept.
page() {
  local folder
  folder=$(mktemp -d)
  run "$1" "sections/sledge-rig/studies/$2.toml" --out "$folder"
  mkdir -p reports/sledge-rig-studies
  mv "$folder/$3" "reports/sledge-rig-studies/$2.html"
  rm -r "$folder"
}

write_all() {
  SOURCE_DATE_EPOCH=$(cat reports/date)
  export SOURCE_DATE_EPOCH
  for case in sections/*/*.toml; do
    case $case in
      sections/catalogue/* | sections/templates/*) continue ;;
      *) run verify "$case" ;;
    esac
  done
  compare sections/sledge-rig/published.toml sections/sledge-rig/thesis.csv reports/sledge-rig-published
  compare sections/sledge-rig/rig.toml sections/sledge-rig/thesis-rigorous.csv reports/sledge-rig
  compare sections/landing-gear/gear.toml sections/landing-gear/published.csv reports/landing-gear
  page sweep stroke-and-frequency study.html
  page sweep indices study.html
  page optimise least-mass optimum.html
  page reliability reliability reliability.html
}

write_all
today=$(date -u -d "$(date -u +%F)" +%s)
if [ "$(cat reports/date)" != "$today" ] && ! git diff --quiet HEAD -- reports; then
  say "The reports have changed: dated $(date -u +%F)"
  echo "$today" >reports/date
  write_all
fi
[ $failed -eq 0 ] || { say "$failed runs failed."; exit 4; }
