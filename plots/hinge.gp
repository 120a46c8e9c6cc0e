# A ball in its seat, cut through the middle, as the body slides over the seat.
# The clearance is drawn much larger than it is; where the surfaces are apart the
# gap is that of rigid ones, eps (1 - cos t/cos theta0).
set encoding utf8
unset border
unset tics
unset grid
set key off
set size ratio -1
set xrange [-2.15:2.45]
set yrange [-1.62:2.1]
set samples 400
set style fill solid 1 noborder

theta0 = 48.0 * pi / 180
g = 20.0 * pi / 180  # friction angle
gap(t) = abs(t) < theta0 ? 0 : 0.09 * (1 - cos(t) / cos(theta0))
pressure(t) = 0.42 * (cos(t) - cos(theta0)) / (1 - cos(theta0))
# At the angle t from the contact's centre, r from the joint's centre.
x(t, r) = r * sin(t - g)
y(t, r) = -r * cos(t - g)

seat = '#d9d9d9'
ball = '#c6dbef'
ink = '#333333'
red = '#c8102e'
blue = '#224488'
set object 1 rectangle from -1.75, -1.58 to 1.75, 0.3 fillcolor rgb seat behind
set object 2 rectangle from -0.22, 0.95 to 0.22, 1.95 fillcolor rgb ball front
set label 1 'body' at 0.31, 1.62 textcolor rgb ink
set label 2 'carrier' at 1.12, -1.42 textcolor rgb ink
set label 3 'θ_0' at x(0.75 * theta0, 0.38), y(0.75 * theta0, 0.38) right \
  textcolor rgb ink front
set label 4 'clearance ε' at 1.3, 0.62 textcolor rgb ink
set arrow 8 from 1.36, 0.52 to 1.05, 0.12 head filled size 0.07, 18 \
  linewidth 1 linecolor rgb ink front
set label 5 'pressure p' at -1.7, -1.42 textcolor rgb '#aa5500'

# Forces on the body, at the contact's centre: R = R_n + R_t.
force = 0.84
set style arrow 1 head filled size 0.1, 20 fixed linewidth 3 linecolor rgb red
set style arrow 2 head filled size 0.1, 20 fixed linewidth 3 linecolor rgb blue
set style arrow 3 nohead linewidth 1 dashtype 2 linecolor rgb ink
px = x(0, 1)
py = y(0, 1)
nx = force * cos(g) * sin(g)
ny = force * cos(g) * cos(g)
set arrow 1 from px, py to px, py + force arrowstyle 2 front
set arrow 2 from px, py to px + nx, py + ny arrowstyle 1 front
set arrow 3 from px, py to px - nx, py + force - ny arrowstyle 1 front
set arrow 4 from px + nx, py + ny to px, py + force arrowstyle 3 front
set arrow 5 from px - nx, py + force - ny to px, py + force arrowstyle 3 front
set label 6 'R' at px - 0.13, py + force + 0.02 textcolor rgb blue front
set label 7 'R_n' at px + 0.5 * nx + 0.08, py + 0.5 * ny - 0.06 textcolor rgb red front
set label 8 'R_t' at px - nx - 0.07, py + force - ny right textcolor rgb red front

# Turning: the body's angular velocity and the friction moment against it.
set arrow 6 from 0.72 * cos(2.52), 0.72 * sin(2.52) \
  to 0.72 * cos(2.62), 0.72 * sin(2.62) arrowstyle 2 front
set arrow 7 from 0.42 * cos(0.55), 0.42 * sin(0.55) \
  to 0.42 * cos(0.36), 0.42 * sin(0.36) arrowstyle 1 front
set label 9 'Δω' at 0.72 * cos(0.6) + 0.05, 0.72 * sin(0.6) textcolor rgb blue \
  front
set label 10 'M_t' at 0.42 * cos(2.4) - 0.06, 0.42 * sin(2.4) right \
  textcolor rgb red front

plot sample \
  [t = -pi:pi] '+' using (x(t, 1 + gap(t))):(y(t, 1 + gap(t))) \
    with filledcurves closed fillcolor rgb 'white', \
  [t = -theta0:theta0] '+' using (x(t, 1 + pressure(t))):(y(t, 1 + pressure(t))) \
    with filledcurves closed fillcolor rgb '#f4a582', \
  [t = -pi:pi] '+' using (x(t, 1)):(y(t, 1)) \
    with filledcurves closed fillcolor rgb ball, \
  [t = -theta0:theta0] '+' using (x(t, 1)):(y(t, 1)) with lines linewidth 4 \
    linecolor rgb ink, \
  [t = 0:theta0] '+' using (x(t, 0.27)):(y(t, 0.27)) with lines linewidth 1 \
    linecolor rgb ink, \
  [t = 0:1] '+' using (x(theta0, t)):(y(theta0, t)) with lines linewidth 1 \
    linecolor rgb ink, \
  [t = 0:1] '+' using (x(0, t)):(y(0, t)) with lines linewidth 1 \
    linecolor rgb ink, \
  [t = 0.6:2.52] '+' using (0.72 * cos(t)):(0.72 * sin(t)) with lines \
    linewidth 3 linecolor rgb blue, \
  [t = 0.55:2.4] '+' using (0.42 * cos(t)):(0.42 * sin(t)) with lines \
    linewidth 3 linecolor rgb red
