#!/bin/sh
# Runs the tensile tests input/tensile-{wale,course,bias}.xml and makes from their force-curves.csv:
#   doc/data/tensile.csv           all curves, one column each, at stretch 1, 1.025, ... 1.4
#   doc/figures/tensile.svg, .png  the same as a plot (gnuplot)
# Usage, anywhere: doc/tensile.sh PATH-OF-toile
set -eu
toile=${1:?"usage: doc/tensile.sh PATH-OF-toile"}
toile=$(realpath "$toile")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p data figures
for direction in wale course bias; do
  "$toile" run "../input/tensile-$direction.xml" --quiet --output "$work/$direction"
done
python3 tensile.py "$work" data/tensile.csv
for ending in svg png; do
  gnuplot -e "ending='$ending'" tensile.gp
done
