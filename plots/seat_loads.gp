# A ring and the seat without an end over the load: how far the contact reaches
# and the largest pressure; a cup over the direction of the load.
set encoding utf8
set datafile separator ','
set key inside left top samplen 2 spacing 1.15
free = NaN
set multiplot
set bmargin at screen 0.2
set tmargin at screen 0.88

set lmargin at screen 0.06
set rmargin at screen 0.32
set title 'ring: half-width, deg'
set xlabel 'load, kN'
set xrange [0:200]
set yrange [0:100]
set key bottom right
plot 'seat_loads_ring.csv' skip 1 using ($1 / 1e3):2 with lines \
    title 'ring', \
  'seat_loads_free.csv' skip 1 using ($1 / 1e3):2 with lines linestyle 7 \
    dashtype 2 title 'without rims'

set lmargin at screen 0.395
set rmargin at screen 0.655
set key top left
set title 'ring: pressure, MPa'
set yrange [0:200]
plot 'seat_loads_ring.csv' skip 1 using ($1 / 1e3):($3 / 1e6) with lines \
    linestyle 2 title '0.66 mm from a rim', \
  'seat_loads_ring.csv' skip 1 using ($1 / 1e3):($4 / 1e6) with lines \
    linestyle 1 title 'in the middle', \
  'seat_loads_free.csv' skip 1 using ($1 / 1e3):($3 / 1e6) with lines \
    linestyle 7 dashtype 2 title 'without rims'

set lmargin at screen 0.725
set rmargin at screen 0.985
set xtics 20
set title 'hip cup, 2 kN: pressure, MPa'
set xlabel 'load from the axis, deg'
set xrange [0:85]
set yrange [0:60]
plot 'seat_loads_cup.csv' skip 1 using 1:($2 / 1e6) with lines linestyle 2 \
    title 'largest', \
  'seat_loads_cup.csv' skip 1 using 1:($3 / 1e6) with lines linestyle 1 \
    title 'under the load', \
  'seat_loads_cup.csv' skip 1 using 1:(free = $1 == 0 ? $2 / 1e6 : free) \
    with lines linestyle 7 dashtype 2 title 'without a rim'
unset multiplot
