#!/usr/bin/env bash
# Formatting and static analysis, as CI looks at them.
#
#   scripts/lint.sh [BASE]
#
# clang-format over everything, clang-tidy over the sources that changed since the commit BASE
# (default: the one that .ci/analysed names, whose sources have all been analysed; everything where
# that is no commit before this one). BOXBEAM_LINT_MOST=20 scripts/lint.sh: at most so many of them, by
# turns from commit to commit.
set -eu
. "$(dirname "$0")/common.sh"
cd "$root"

install_missing "${packages[@]}" clang-format clang-tidy git libopenmpi-dev

say "== Formatting (clang-format)"
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run --Werror

say "== Static analysis (clang-tidy) of changed sources"
base=${1:-$(cat .ci/analysed)}
git merge-base --is-ancestor "$base" HEAD 2>/dev/null || base=
mapfile -t changed < <(if [ -n "$base" ]; then
  git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'charts/*.cpp'
  else git ls-files 'src/*.cpp' 'charts/*.cpp'; fi)
all=${#changed[@]}
most=${BOXBEAM_LINT_MOST:-$all}
if [ "$all" -gt "$most" ]; then
  first=$(($(git rev-list --count HEAD) * most % all))
  changed=("${changed[@]:first}" "${changed[@]:0:first}")
  changed=("${changed[@]:0:most}")
fi
if [ "$all" -gt 0 ]; then
  # Configured without precompiled headers, which are another compiler's; nothing is built there.
  configure build-analyse -DBOXBEAM_TESTS=OFF -DBOXBEAM_BENCH=OFF -DBOXBEAM_MPI=ON
  printf '%s\n' "${changed[@]}" | xargs -P "$(nproc)" -n 4 \
    clang-tidy -p build-analyse --quiet --extra-arg=-Wno-unknown-warning-option
fi
say "${#changed[@]} of $all changed files analysed, $((all - ${#changed[@]})) left out"
