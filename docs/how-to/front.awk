# Draws what a search found: acceleration against deflection of its first generation, its last one and the base.
#
# usage: vehicle study show search.sqlite --export search.csv
#        awk -f docs/how-to/front.awk search.csv > front.svg
#
# Reads the columns "carbody.az.rms @ ..." and "secondary_front.deflection.peak @ ..." of
# models/studies/comfort-against-deflection.xml and takes the worst speed of each, as its objectives do.
BEGIN { FS = ","; population = 100 }

NR == 1 {
  for (i = 1; i <= NF; ++i) {
    if ($i ~ /^carbody.az.rms @/) across[i]
    if ($i ~ /^secondary_front.deflection.peak @/) up[i]
  }
  next
}

$3 == "done" {
  x[$1] = 0; for (i in across) if ($i > x[$1]) x[$1] = $i
  y[$1] = 0; for (i in up) if (1000 * $i > y[$1]) y[$1] = 1000 * $i
  if ($1 > last) last = $1
}

# From acceleration [m/s^2] and deflection [mm] to the sheet.
function sx(value) { return 60 + 560 * value / 2 }
function sy(value) { return 330 - 300 * value / 21 }

function circles(from, to, colour, radius,   i) {
  for (i = from; i <= to; ++i)
    if (i in x && x[i] <= 2 && y[i] <= 21)
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\"/>\n", sx(x[i]), sy(y[i]), radius, colour
}

function label(at_x, at_y, anchor, colour, text) {
  printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n", at_x, at_y, anchor, colour, text
}

END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 380\" font-family=\"sans-serif\" font-size=\"13\">"
  print "<rect width=\"640\" height=\"380\" fill=\"white\"/>"
  for (value = 0; value < 2.1; value += 0.25) {
    printf "<path d=\"M%.1f 30V330\" stroke=\"#ddd\"/>\n", sx(value)
    label(sx(value), 347, "middle", "black", sprintf("%.2f", value))
  }
  for (value = 0; value <= 21; value += 3) {
    printf "<path d=\"M60 %.1fH620\" stroke=\"#ddd\"/>\n", sy(value)
    label(52, sy(value) + 4, "end", "black", value)
  }
  label(340, 370, "middle", "black", "r.m.s. acceleration of the carbody [m/s^2]")
  label(60, 18, "start", "black", "peak deflection of the secondary suspension [mm]")
  circles(1, population, "#999", 2.5)
  circles(last - population + 1, last, "#06c", 2.5)
  circles(0, 0, "#c00", 5)
  label(sx(x[0]) + 9, sy(y[0]) + 4, "start", "#c00", "base")
  label(600, 285, "end", "#777", "first generation, at random")
  label(600, 305, "end", "#06c", "last generation")
  print "</svg>"
}
