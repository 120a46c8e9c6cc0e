# Pressure over the angle from the centre of the contact, equal materials with
# Poisson's ratio 0.3: exact solid, the paper's (3.3) dashed. Pin and ball.
set encoding utf8
set datafile separator ','
set xrange [0:85]
set xtics 20
set yrange [0:*]
set xlabel 'angle from the centre, deg'
unset colorbox
files = 'pressure_pin.csv pressure_ball.csv'
set multiplot
do for [i = 1:2] {
  set lmargin at screen 0.095 + 0.4 * (i - 1)
  set rmargin at screen 0.095 + 0.4 * (i - 1) + 0.31
  set bmargin at screen 0.2
  set tmargin at screen 0.9
  set title i == 1 ? 'pin in a hole' : 'ball in a seat'
  set ylabel i == 1 ? 'pressure over P/(2ρ)' : 'pressure over R_n/(πρ^2)'
  if (i == 1) {
    unset key
  } else {
    set key at graph 1.04, 0.5 left center vertical samplen 2
  }
  file = word(files, i)
  plot for [theta0 = 40:80:20] file skip 1 \
      using 3:(abs($2 - theta0) < 1 ? $5 : NaN) with lines linewidth 2.8 \
      linecolor palette frac (theta0 - 40) / 50.0 \
      title sprintf('θ_0 = %d°', theta0), \
    for [theta0 = 40:80:20] file skip 1 \
      using 3:(abs($2 - theta0) < 1 ? $4 : NaN) with lines linewidth 1.8 \
      dashtype 2 linecolor palette frac (theta0 - 40) / 50.0 notitle, \
    NaN with lines linewidth 2 dashtype 1 linecolor rgb '#444444' \
      title 'exact', \
    NaN with lines linewidth 2 dashtype 2 linecolor rgb '#444444' \
      title 'cosine (3.3)'
}
unset multiplot
