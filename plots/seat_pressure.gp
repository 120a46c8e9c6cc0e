# Pressure on seats that end: a ring and a cup, seen from outside along the load
# and cut in the plane of the load; dashed what the seat without an end would
# have.
set encoding utf8
unset border
unset tics
unset grid
set key off
set size ratio -1
set style fill solid 1 noborder
set view map
set pm3d corners2color mean
set palette defined (0 '#e9e9e9', 0.05 '#dbe6f3', 0.25 '#92b4dc', \
  0.5 '#f7d06b', 0.75 '#ee7a3a', 1 '#a11021')

# The place v from the seat's axis, seen against a load at b from the axis: X
# to the side, Y upwards, d towards the eye.
X(v, phi) = sin(v) * sin(phi)
Y(v, phi) = sin(b) * cos(v) - cos(b) * sin(v) * cos(phi)
d(v, phi) = cos(b) * cos(v) + sin(b) * sin(v) * cos(phi)
seen(v, phi) = d(v, phi) > -1e-3 ? 1 : NaN
# The same at the radius r in the cut, v below 0 beyond the axis; the load
# points to the right.
x(r, v) = r * cos(v - b)
y(r, v) = -r * sin(v - b)
wall = 1.5
along(t) = t < 1 ? v1 + (v2 - v1) * t : v2 - (v2 - v1) * (t - 1)
high = 0.42  # of the largest pressure
ink = '#333333'
red = '#c8102e'
rad = pi / 180

set multiplot
do for [i = 1:2] {
  ring = i == 1
  name = ring ? 'seat_ring' : 'seat_cup'
  b = (ring ? 90 : 65) * rad
  v1 = (ring ? 64.9 : -90) * rad
  v2 = (ring ? 115.1 : 90) * rad
  set autoscale
  stats name.'_free.dat' using 5 nooutput
  free = STATS_max
  stats name.'.dat' using 3 nooutput
  top = STATS_max
  scale = high / (top > free ? top : free)
  set cbrange [0:top / 1e6]
  bottom = 0.98 - 0.49 * i
  set bmargin at screen bottom
  set tmargin at screen bottom + 0.41
  set label 1 ring ? '28 mm ring on a 66 mm ball, 0.5 mm liner, 100 kN' : \
    'hip, hemispherical cup, 2 kN at 65° from its axis' \
    at screen 0.5, bottom + 0.45 center

  set xrange [-1.2:1.2]
  set yrange [-1.2:1.2]
  set lmargin at screen 0.02
  set rmargin at screen 0.40
  set colorbox user origin 0.415, bottom + 0.06 size 0.017, 0.29
  set cbtics out nomirror
  set label 6 'MPa' at screen 0.4235, bottom + 0.372 center textcolor rgb ink
  splot sample [t = 0:1] '+' using (NaN):(NaN):(NaN) with points, \
    name.'.dat' using (X($1 * rad, $2 * rad)):(Y($1 * rad, $2 * rad)):\
(seen($1 * rad, $2 * rad) * $3 / 1e6) with pm3d, \
    [t = 0:2 * pi] '+' using (cos(t)):(sin(t)):(0) with lines linewidth 1 \
      linecolor rgb ink, \
    [t = -pi:pi] '+' using (X(v1, t)):(Y(v1, t)):(seen(v1, t)) with lines \
      linewidth 3 linecolor rgb ink, \
    [t = -pi:pi] '+' using (X(v2, t)):(Y(v2, t)):(seen(v2, t)) with lines \
      linewidth 3 linecolor rgb ink
  unset colorbox
  set xrange [-1.6:1.95]
  set yrange [-1.6:1.6]
  set lmargin at screen 0.54
  set rmargin at screen 0.99
  set label 2 'R' at 1.83, 0.14 textcolor rgb red
  set label 3 'ball' at 0, 0 center textcolor rgb ink front
  set label 4 'seat' at x(1.25, ring ? -b : 0), y(1.25, ring ? -b : 0) center \
    textcolor rgb ink front
  set label 5 'dashed: without rims' at x(1, b), -1.42 center textcolor rgb ink
  set arrow 1 from 1.55, 0 to 1.9, 0 head filled size 0.12, 20 fixed \
    linewidth 3 linecolor rgb red front
  # A ring is cut twice.
  plot sample [t = 0:2] '+' using (x(t < 1 ? 1 : wall, along(t))):\
(y(t < 1 ? 1 : wall, along(t))) with filledcurves closed \
      fillcolor rgb '#d9d9d9', \
    [t = 0:2] '+' using (ring ? x(t < 1 ? 1 : wall, -along(t)) : NaN):\
(y(t < 1 ? 1 : wall, -along(t))) with filledcurves closed \
      fillcolor rgb '#d9d9d9', \
    name.'_cut.dat' using (x(1 + scale * $2, $1 * rad)):\
(y(1 + scale * $2, $1 * rad)) with filledcurves closed fillcolor rgb '#f4a582', \
    [t = 0:2 * pi] '+' using (cos(t)):(sin(t)) with filledcurves closed \
      fillcolor rgb '#c6dbef', \
    for [side = -1:1:2] name.'_free.dat' \
      using (x(1 + scale * $5, b + side * $4 * rad)):\
(y(1 + scale * $5, b + side * $4 * rad)) with lines linewidth 2 dashtype 2 \
      linecolor rgb ink
  unset arrow 1
  unset label 2
  unset label 3
  unset label 4
  unset label 5
  unset label 6
}
unset multiplot
