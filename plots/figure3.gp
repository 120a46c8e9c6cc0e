# Limit half-angle against the modulus ratio, nu = 0.3: the paper's formulas
# beside the exact limits of a pin and of a ball; errors of the formulas below.
set encoding utf8
set datafile separator ','
set logscale x
set xrange [0.01:100]
set multiplot
set lmargin at screen 0.13
set rmargin at screen 0.97
set tmargin at screen 0.97
set bmargin at screen 0.42
set format x ''
set ylabel "limit half-angle θ_0*, deg"
set yrange [79:94]
set key at graph 0.99, 0.99 vertical right top
plot \
  'figure3.csv' using 1:5 skip 1 with lines linetype 3 linewidth 3 \
    title 'ball, exact', \
  '' using 1:4 skip 1 with lines linewidth 3.5 linecolor rgb '#222222' \
    title 'pin, exact', \
  '' using 1:2 skip 1 with lines linetype 1 dashtype 2 \
    title 'arctan formula', \
  '' using 1:3 skip 1 with lines linetype 2 linewidth 3.5 dashtype 2 \
    title '84.85° ± 2° (y − 1)'
set tmargin at screen 0.38
set bmargin at screen 0.13
set format x '%g'
set xlabel "modulus ratio Ē = E_1/E_2 (inner over outer)"
set ylabel "error, %"
set yrange [-5.5:1.5]
set key at graph 0.02, 0.08 vertical left bottom
plot \
  0 with lines linewidth 1.5 linecolor rgb '#888888' notitle, \
  'figure3.csv' using 1:(100*($2/$4-1)) skip 1 with lines linetype 1 \
    dashtype 2 title 'for a pin', \
  '' using 1:($3 > 0 ? 100*($3/$4-1) : NaN) skip 1 with lines linetype 2 \
    linewidth 3.5 dashtype 2 notitle, \
  '' using 1:(100*($2/$5-1)) skip 1 with lines linetype 3 dashtype 2 \
    title 'for a ball'
unset multiplot
