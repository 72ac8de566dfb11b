#!/usr/bin/env bash
# Compares the bits of the scalar forms and methods between the programs of two compilers: every shipped vehicle on the
# paper's track and the paper's vehicle on every shipped track, by flat and matrix, with rk4, dopri5 and exact. Each
# history is compared byte for byte; of those that differ it prints the largest difference, as a share of the column's
# peak, and where.
#
# usage: tools/compare-compilers.sh [PROGRAM PROGRAM]   (default: of the release and of the clang preset)
# Exit status: 0 no difference, or only small ones; 1 a larger one, or what one refuses the other runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export OPENBLAS_NUM_THREADS=1

programs=("${1:-build/release/bin/vehicle}" "${2:-build/clang/bin/vehicle}")
# Both compilers keep to IEEE arithmetic in the order of the text (-ffp-contract=off, no -ffast-math), and take sin, cos
# and exp from the same libm; what may differ is said in docs/how-to/build.md. A last bit grows over a run by the
# tolerance of dopri5 at most (1e-10), as each program chooses its own steps.
largest=1e-9

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
paper=models/vehicles/al-oraiqat-2017.xml
pairs=()
for vehicle in models/vehicles/*.xml; do pairs+=("$vehicle models/scenarios/paper-20mps.xml"); done
for scenario in models/scenarios/*.xml; do
  [[ $scenario == */paper-20mps.xml ]] || pairs+=("$paper $scenario")
done

# largest_difference A B: of two histories with the same columns, "SHARE COLUMN LINE"
largest_difference() {
  awk -F, '
    FNR == 1 { for (i = 1; i <= NF; ++i) name[i] = $i; next }
    NR == FNR { for (i = 1; i <= NF; ++i) { a[FNR, i] = $i; if ($i < 0) $i = -$i; if ($i + 0 > peak[i] + 0) peak[i] = $i }; lines = FNR; next }
    { for (i = 1; i <= NF; ++i) {
        d = $i - a[FNR, i]; if (d < 0) d = -d
        if (peak[i] > 0 && d / peak[i] > most) { most = d / peak[i]; where = name[i] " at line " FNR } } }
    END { if (lines != FNR) { most = 1; where = "another number of samples" }; printf "%.1e %s\n", most, where }' "$1" "$2"
}

same=0 refused=0 different=0 bad=0
for pair in "${pairs[@]}"; do
  read -r vehicle scenario <<<"$pair"
  for form in flat matrix; do
    for method in rk4 dopri5 exact; do
      name="$(basename "$vehicle" .xml) $(basename "$scenario" .xml) $form $method"
      for i in 0 1; do
        status=0
        "${programs[i]}" simulate "$vehicle" "$scenario" --form "$form" --method "$method" --quiet \
          --output "$folder/$i.csv" --overwrite >"$folder/$i.out" 2>"$folder/$i.err" || status=$?
        echo "$status" >>"$folder/$i.err"
      done
      if ! cmp -s "$folder/0.err" "$folder/1.err"; then
        echo "$name: what they say differs"
        diff "$folder/0.err" "$folder/1.err" || true
        bad=$((bad + 1))
      elif [[ $(tail -n 1 "$folder/0.err") != 0 ]]; then
        refused=$((refused + 1))
      elif cmp -s "$folder/0.csv" "$folder/1.csv"; then
        same=$((same + 1))
      else
        read -r share where <<<"$(largest_difference "$folder/0.csv" "$folder/1.csv")"
        echo "$name: $share of the peak, $where"
        different=$((different + 1))
        awk -v share="$share" -v most="$largest" 'BEGIN { exit !(share > most) }' && bad=$((bad + 1))
      fi
      rm -f "$folder"/*.csv
    done
  done
done
echo "== bits: $same histories are the same to the last bit, $different differ, $refused are refused by both"
if ((same + different == 0)); then
  echo "compare-compilers.sh: nothing ran" >&2
  exit 1
fi
((bad == 0))
