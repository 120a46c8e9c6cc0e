# Three quantities side by side, columns COLUMN1..3 with the names NAME1..3,
# against the slip axis angle for four half-angles; exact solid, planar dashed.
set encoding utf8
set datafile separator ','
set xrange [0:90]
set xtics 30
set xlabel 'α, deg'
colour(theta0) = (theta0 - 20) / 60.0
set multiplot
do for [i = 1:3] {
  c = value(sprintf('column%d', i))
  name = value(sprintf('name%d', i))
  set lmargin at screen 0.055 + 0.285 * (i - 1)
  set rmargin at screen 0.055 + 0.285 * (i - 1) + 0.225
  set bmargin at screen 0.19
  set tmargin at screen 0.89
  set title name
  set yrange [0:value(sprintf('top%d', i))]
  if (i == 3) {
    set key outside right center vertical maxrows 8 samplen 2
  } else {
    unset key
  }
  plot for [theta0 = 80:20:-20] 'figure8_exact.csv' skip 1 \
      using 2:($1 == theta0 ? column(c) : NaN) with lines linewidth 2.8 \
      linecolor palette frac colour(theta0) \
      title sprintf('θ_0 = %d°', theta0), \
    for [theta0 = 80:20:-20] 'figure8_planar.csv' skip 1 \
      using 2:($1 == theta0 ? column(c) : NaN) with lines linewidth 1.6 \
      dashtype 2 linecolor palette frac colour(theta0) notitle, \
    NaN with lines linewidth 2 dashtype 1 linecolor rgb '#444444' \
      title 'exact', \
    NaN with lines linewidth 2 dashtype 2 linecolor rgb '#444444' \
      title 'planar'
}
unset multiplot
