#!/usr/bin/env bash
# Usage: wide_packs_test.sh NM OBJECT...
# Objects for machines with wide registers define one function each and nothing that the linker may take for other
# objects too: their code must run nowhere else.
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
