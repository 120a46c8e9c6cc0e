# Half-angle laws of a ball in a rigid seat, against the exact solution.
set encoding utf8
set datafile separator ','
set xlabel "load parameter μ = 3R_n/(2 ε̄ ρ_1^2 E)"
set ylabel "contact half-angle θ_0, deg"
set xrange [0:4]
set yrange [0:100]
set key inside bottom right vertical
set label 1 'limit 92.5°' at graph 0.02, first 92.5 offset 0, 0.6
plot \
  92.5 with lines linetype 7 dashtype 2 notitle, \
  'figure5.csv' using 1:3 skip 1 with lines linetype 4 \
    title 'Hertz (2.1)', \
  '' using 1:5 skip 1 with lines linetype 1 title 'arctan (2.3)', \
  '' using 1:7 skip 1 with lines linetype 2 title 'tanh (2.4)', \
  '' using 1:9 skip 1 with lines linetype 6 dashtype 2 \
    title 'mean of both', \
  'figure5_exact.csv' using 1:2 skip 1 with points pointtype 6 \
    pointsize 1.1 linewidth 2 linecolor rgb '#222222' title 'exact solution'
