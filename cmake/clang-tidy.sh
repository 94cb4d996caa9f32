#!/usr/bin/env bash
# clang-tidy.sh <folder or source>...: reads the sources of each folder as one translation unit, so that clang-tidy reads and
# matches every header once and not once a source: a tenth of the time. Needs a configured build/release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Sources that include the heavy libraries are left out: they take minutes each. So are those that must include plain_fad.hpp
# before any other header.
light() {
  local files=("$1")
  [[ -f "$1" ]] || files=("$1"/*.cpp)
  # grep's status tells whether a line matched, which is not the question here.
  grep -L -E '#include <(CGAL|NOX|LOCA|Thyra|Tpetra|Belos|Stratimikos|Sacado)|plain_fad' "${files[@]}" || true
}

# The unnamed namespace of each test gets a name of its own in a copy: tests may hold equal names.
copies() {
  local number=0 source copy
  for source in $(light "$1"); do
    number=$((number + 1))
    copy="build/tidy/$source"
    mkdir -p "$(dirname "$copy")"
    if [[ "$source" == *_test.cpp ]]; then
      sed "s|^namespace {|namespace unnamed_$number {|" "$source" >"$copy"
    else
      cp "$source" "$copy"
    fi
    printf '#include "%s"\n' "$PWD/$copy"
  done
}

originals() { light "$1" | sed "s|.*|#include \"$PWD/&\"|"; }

flags="$(grep -ohE -- '-(I|isystem )[^ "]+' build/release/compile_commands.json | sort -u)"
# Texts that the build defines: which ones does not matter here.
definitions='-DTOILE_VERSION="" -DTOILE_SOURCE_DIR="" -DTOILE_PROGRAM="" -DTOILE_MPIEXEC="" -DTOILE_FULL_DISK="" -DTOILE_MESHER="" -DTOILE_EXAMPLE="" -DTOILE_MANNEQUIN_BODY="" -DTOILE_HAS_BODY=1 -DTOILE_HAS_RESULT=1 -DTOILE_HAS_REPORT=1'
checks=-bugprone-suspicious-include
status=0
for folder in "$@"; do
  unit="build/tidy/${folder//\//-}.cpp"
  mkdir -p build/tidy
  case "$folder" in
    # What reads well and what misuses an object; the rest would cost most of the time and finds little in tests.
    test/*)
      copies "$folder" >"$unit"
      checks+=",-bugprone-*,-performance-*,-modernize-*,bugprone-argument-comment,bugprone-dangling-handle,\
bugprone-infinite-loop,bugprone-unused-raii,bugprone-use-after-move,performance-for-range-copy,\
performance-unnecessary-copy-initialization,modernize-use-override"
      ;;
    *) originals "$folder" >"$unit" ;;
  esac
  # shellcheck disable=SC2086  # every flag is a word of its own
  clang-tidy --quiet --config-file=.clang-tidy --checks="$checks" "$unit" -- \
    -std=c++17 -fopenmp $flags -Itest "-I$folder" "-I$(dirname "$folder")" "-I$(dirname "$folder")/src" $definitions || status=1
done
exit "$status"
