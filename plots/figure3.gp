# Limit half-angle of a pin in a hole against the modulus ratio.
set encoding utf8
set datafile separator ','
stats 'figure3_ends.csv' using 1 skip 1 nooutput name 'seat'
stats 'figure3_ends.csv' using 2 skip 1 nooutput name 'pin'
set xlabel "modulus ratio Ē = E_1/E_2 (pin over hole)"
set ylabel "limit half-angle θ_0*, deg"
set logscale x
set format x '%g'
set xrange [0.01:100]
set yrange [79:94]
set key at graph 0.98, 0.82 vertical
set label 1 'rigid hole, Ē = 0' at graph 0.02, first seat_mean offset 0, 0.6
set label 2 'rigid pin, Ē = ∞' at graph 0.02, first pin_mean offset 0, 0.6
plot \
  seat_mean with lines linetype 7 dashtype 2 notitle, \
  pin_mean with lines linetype 7 dashtype 2 notitle, \
  'figure3.csv' using 1:2 skip 1 with lines linetype 1 \
    title 'arctan formula', \
  '' using 1:3 skip 1 with lines linetype 2 linewidth 3.5 dashtype 2 \
    title '84.85° ± 2° (y − 1)'
