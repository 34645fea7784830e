#!/usr/bin/env bash
# Usage: wide_packs_test.sh NM OBJECT...
# Objects that are compiled for machines with wide registers may define only their one function and nothing
# that the linker could use for other objects: their code must not run anywhere else.
set -euo pipefail
nm=$1
shift
[[ $# -eq 2 ]] || { echo "two objects are expected, not $#: $*"; exit 1; }
for object in "$@"; do
  defined=$("$nm" --demangle --defined-only --extern-only "$object")
  if [[ $(grep -c '^' <<<"$defined") -ne 1 ]] || ! grep -q ' T higherpair::fill_by_[48](' <<<"$defined"; then
    printf '%s defines more than its own function:\n%s\n' "$object" "$defined"
    exit 1
  fi
done
