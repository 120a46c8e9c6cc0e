# Half-angle laws over the load parameter, errors against the exact half-angle
# at the same load below. Before it: table (CSV of hinge-angle with the laws
# hertz, arctan, tanh, blend:0.5, fitted, exact), load_name, largest_load,
# limit (deg, of the paper's laws), error_range (%).
set encoding utf8
set datafile separator ','
set xrange [0:largest_load]
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.97
set tmargin at screen 0.97
set bmargin at screen 0.42
set format x ''
set ylabel "contact half-angle θ_0, deg"
set yrange [0:100]
set key at graph 0.99, 0.05 vertical right bottom
set label 1 sprintf('limit %g°', limit) at graph 0.02, first limit \
  offset 0, 0.6
plot \
  limit with lines linetype 7 dashtype 2 linewidth 1.5 notitle, \
  table using 1:13 skip 1 with lines linewidth 4 linecolor rgb '#222222' \
    title 'exact', \
  '' using 1:3 skip 1 with lines linetype 4 title 'Hertz (2.1)', \
  '' using 1:5 skip 1 with lines linetype 1 title 'arctan (2.3)', \
  '' using 1:7 skip 1 with lines linetype 2 title 'tanh (2.4)', \
  '' using 1:9 skip 1 with lines linetype 6 dashtype 2 title 'mean of both', \
  '' using 1:11 skip 1 with lines linetype 5 dashtype 2 title 'fitted'
unset label 1
set tmargin at screen 0.38
set bmargin at screen 0.13
set format x '%g'
set xlabel load_name
set ylabel "error, %"
set yrange [-error_range:error_range]
unset key
plot \
  table using 1:($1 > 0 ? 100*($3/$13-1) : NaN) skip 1 with lines \
    linetype 4, \
  '' using 1:($1 > 0 ? 100*($5/$13-1) : NaN) skip 1 with lines linetype 1, \
  '' using 1:($1 > 0 ? 100*($7/$13-1) : NaN) skip 1 with lines linetype 2, \
  '' using 1:($1 > 0 ? 100*($9/$13-1) : NaN) skip 1 with lines linetype 6 \
    dashtype 2, \
  '' using 1:($1 > 0 ? 100*($11/$13-1) : NaN) skip 1 with lines linetype 5
unset multiplot
