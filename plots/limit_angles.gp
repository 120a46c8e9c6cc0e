# Exact limit half-angle against the modulus ratio for several Poisson's
# ratios (of both bodies): pin and ball.
set encoding utf8
set datafile separator ','
set logscale x
set xrange [0.01:100]
set yrange [70:135]
set xlabel "Ē = E_1/E_2 (inner over outer)"
unset colorbox
array nus[5] = [0.2, 0.3, 0.4, 0.45, 0.49]
set multiplot
do for [i = 1:2] {
  set lmargin at screen 0.1 + 0.41 * (i - 1)
  set rmargin at screen 0.1 + 0.41 * (i - 1) + 0.34
  set bmargin at screen 0.19
  set tmargin at screen 0.9
  set title i == 1 ? 'pin in a hole' : 'ball in a seat'
  if (i == 1) {
    set ylabel "limit half-angle θ_0*, deg"
    unset key
  } else {
    unset ylabel
    set key at graph 1.05, 0.5 left center vertical samplen 2
  }
  plot for [k = 5:1:-1] 'limit_angles.csv' skip 1 \
    using 2:($1 == nus[k] ? column(2 + i) : NaN) with lines linewidth 2.8 \
    linecolor palette frac (k - 1) / 4.0 title sprintf('ν = %g', nus[k])
}
unset multiplot
