# Core and boosters of data/cases/soyuz.toml at five times, to scale.
set encoding utf8
set datafile separator ','
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-11:11]
set yrange [-14:51]
set style fill solid 1 border linecolor rgb '#444444'
# Bodies as in outlines.csv: core grey, the stronger booster 3 red.
colour(body) = body == 1 ? '#e8e8e8' : body == 3 ? '#ee6677' : '#4477aa'
set multiplot layout 1,words(times) margins 0.01,0.99,0.01,0.92 spacing 0
do for [panel = 1:words(times)] {
  set title word(times, panel).' s' offset 0,-0.5
  plot for [body = 0:4] 'outlines.csv' index 5 * (panel - 1) + body \
    using 1:2 with filledcurves closed linewidth 0.8 \
    fillcolor rgb colour(body)
}
unset multiplot
