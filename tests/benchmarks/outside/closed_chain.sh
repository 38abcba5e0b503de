#!/usr/bin/env bash
# Builds and runs closed_chain.cpp against Simbody (Debian: libsimbody-dev), the headers of Pinocchio that PyPI has
# (package pin, in a virtual environment) and the library of a build, all by the same compiler; Simbody with its assertions, as Debian's package
# has them, the others without.
#
#     tests/benchmarks/outside/closed_chain.sh ENV [BUILD [LOOPS...]]    e.g. after python3 -m venv env && env/bin/pip install pin
set -euo pipefail
cd "$(dirname "$0")/../../.."
headers=$(echo "${1:?folder of the virtual environment}"/lib/python3*/site-packages/cmeel.prefix/include)
build=${2:-build}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
here=tests/benchmarks/outside
g++ -std=c++17 -O2 -w -isystem /usr/include/simbody -c $here/closed_chain_simbody.cpp -o "$folder/simbody.o"
g++ -std=c++20 -O2 -DNDEBUG -w -Iinclude -Itests -isystem "$headers" -isystem /usr/include/eigen3 \
  -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -DBOOST_FUSION_INVOKE_MAX_ARITY=12 \
  $here/closed_chain.cpp "$folder/simbody.o" "$build/libboxbeam.a" -lfmt -ltomlplusplus -lmd -lSimTKsimbody -lSimTKmath -lSimTKcommon \
  -o "$folder/closed_chain"
"$folder/closed_chain" "${@:3}"
