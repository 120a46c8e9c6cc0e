# Core and boosters of data/cases/soyuz.toml at five times, to scale.
set encoding utf8
set datafile separator ','
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-9.6:9.6]
set yrange [-9:51]
set style fill solid 1 border linecolor rgb '#444444'
# Bodies as in outlines.csv: booster 2 is behind the core, the stronger booster
# 3 red.
colour(body) = body == 0 ? '#9fb8d0' : body == 1 ? '#e8e8e8' : \
  body == 3 ? '#ee6677' : '#4477aa'
set multiplot layout 1,words(times) margins 0.01,0.99,0.01,0.92 spacing 0
do for [panel = 1:words(times)] {
  set title word(times, panel).' s' offset 0,-0.5
  unset label
  unset arrow
  if (panel == 1) {
    set label 'core' at 2,40 left
    set label '3' at -4.2,8 right
    set label '4' at 4.2,8 left
    set label 'booster 1 before the core,' at -9,-3 left
    set label '2 behind it' at -9,-6.3 left
  }
  if (panel == words(times)) {
    set arrow from 3.2,30 to 3.2,40 heads size 0.5,90 linewidth 1.2
    set label '10 m' at 4,35 left
  }
  plot for [body = 0:4] 'outlines.csv' index 5 * (panel - 1) + body \
    using 1:2 with filledcurves closed linewidth 0.8 \
    fillcolor rgb colour(body)
}
unset multiplot
