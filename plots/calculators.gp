# Largest pressures by what calculators and catalogues take, over that of the
# exact contact: a pin and a ball of steel.
set encoding utf8
set xlabel "half-angle of the contact, °"
set xrange [0:85]
set yrange [0:1.2]
set xtics 15
unset key
shares = "'4 F/(π D L)' '3 F/(2 π R²)'"
means = "'F/(D L)' 'F/(π R²)'"
set multiplot layout 1, 2
do for [i = 1:2] {
  joint = word("pin ball", i)
  set title joint." of steel"
  set ylabel i == 1 ? "pressure over the exact one" : ""
  set label 1 "Hertz, Roark" at i == 1 ? 57 : 61, i == 1 ? 0.3 : 0.06 \
    textcolor linetype 1
  set label 2 word(shares, i) at 14, i == 1 ? 0.56 : 0.42 textcolor linetype 3
  set label 3 word(means, i) at i == 1 ? 31 : 38, i == 1 ? 0.3 : 0.18 textcolor linetype 7
  set label 4 "the larger of both" at 45, 1.08 right textcolor linetype 2
  plot 1 with lines linewidth 1.2 linecolor rgb '#333333', \
    "calculators_".joint.".dat" using 1:($2 > $3 ? $2 : $3) with lines \
      linestyle 2 linewidth 6, \
    "" using 1:2 with lines linestyle 1, \
    "" using 1:3 with lines linestyle 3, \
    "" using 1:4 with lines linestyle 7 dashtype 2
}
unset multiplot
