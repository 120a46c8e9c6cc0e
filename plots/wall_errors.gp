# How wrong the seat or hole without an end is, over the thickness of the wall
# that there is: peak pressure above, half-angle below. Ball and pin of steel at
# the load at which the infinite seat has 40 deg.
set encoding utf8
set datafile separator ','
set logscale x
set xrange [0.01:10]
set multiplot
do for [row = 1:2] {
  do for [i = 1:2] {
    set lmargin at screen 0.11 + 0.37 * (i - 1)
    set rmargin at screen 0.11 + 0.37 * (i - 1) + 0.31
    set bmargin at screen row == 1 ? 0.57 : 0.12
    set tmargin at screen row == 1 ? 0.94 : 0.49
    set yrange [row == 1 ? -90 : -80 : row == 1 ? 180 : 320]
    set ytics row == 1 ? 50 : 100
    set format y "%4.0f"
    if (row == 1) {
      set title i == 1 ? 'ball in a seat' : 'pin in a hole'
      unset xlabel
    } else {
      unset title
      set xlabel 'thickness of the wall over the radius'
    }
    if (i == 1) {
      set ylabel row == 1 ? 'error of the peak, %' : 'error of the half-angle, %'
    } else {
      unset ylabel
    }
    if (i == 2 && row == 1) {
      set key at graph 1.06, 0.1 left center vertical samplen 2
    } else {
      unset key
    }
    kind = i == 1 ? 'ball' : 'pin'
    is(material, backing) = (strcol(1) eq kind && strcol(2) eq material && \
      strcol(3) eq backing) ? column(row == 1 ? 6 : 5) : NaN
    array backings[3] = ['rigid', 'steel', 'held']
    # A rigid backing shows below one of steel where both are the same.
    plot for [k = 1:3] 'wall_errors.csv' skip 1 \
        using 4:(is('polymer', backings[k])) with lines linetype k \
        linewidth (k == 1 ? 6 : 2.5) \
        title 'polymer, '.backings[k], \
      for [k = 1:3] 'wall_errors.csv' skip 1 \
        using 4:(is('bronze', backings[k])) with lines linetype k dashtype 2 \
        title 'bronze, '.backings[k], \
      0 with lines linewidth 1 linecolor rgb '#555555' notitle
  }
}
unset multiplot
