#!/usr/bin/env bash
# Builds and runs open_chain.cpp against the headers of Pinocchio that PyPI has (package pin, in a virtual environment)
# and the library of a build; both by the same compiler and flags.
#
#     tests/benchmarks/outside/open_chain.sh ENV [BUILD]       e.g. after python3 -m venv env && env/bin/pip install pin
set -euo pipefail
cd "$(dirname "$0")/../../.."
headers=$(echo "${1:?folder of the virtual environment}"/lib/python3*/site-packages/cmeel.prefix/include)
build=${2:-build}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
g++ -std=c++20 -O2 -DNDEBUG -w -Iinclude -Itests -isystem "$headers" -isystem /usr/include/eigen3 \
  -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -DBOOST_FUSION_INVOKE_MAX_ARITY=12 \
  tests/benchmarks/outside/open_chain.cpp "$build/libboxbeam.a" -lfmt -ltomlplusplus -lmd -o "$folder/open_chain"
"$folder/open_chain"
