#!/usr/bin/env bash
# Would the tests notice a wrong formula? Makes single changes of formulas, signs, sides and clauses
# (tests/mutations/mutations.py), one at a time, in a copy of the source tree, and runs the tests.
#
#   scripts/mutations.sh                     all that have not been done; the table at the end
#   scripts/mutations.sh --only NAME,NAME    some of them
#   scripts/mutations.sh --first             only the tests named with a mutation, not the whole suite
#   scripts/mutations.sh --list
#
# The copy and the outcomes stay in build/mutations (WORK=FOLDER: there), so that a run that was
# stopped goes on; remove results.jsonl there to begin anew. All of them take some hours.
# Exit code 0: at most three are not noticed.
set -u
. "$(dirname "$0")/common.sh"

case " $* " in *" --list "*) exec python3 "$root/tests/mutations/mutate.py" --list ;; esac
work=${WORK:-$root/build/mutations}
tree=$work/tree
install_missing "${packages[@]}" "${test_packages[@]}"
mkdir -p "$tree"
# With their times, so that only what is new is built anew.
tar -C "$root" -cf - --exclude=./build --exclude=./.git . | tar -C "$tree" -xf -
configure "$tree/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
  -DBOXBEAM_TESTS=ON -DBOXBEAM_PRECOMPILE=ON
build "$tree/build" all
exec python3 "$root/tests/mutations/mutate.py" "$tree" "$work/results.jsonl" --jobs "$(nproc)" "$@"
