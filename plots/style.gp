# The look of every picture of the project. Colours: Paul Tol's "bright"
# scheme (seven colours that colour-blind readers tell apart) for curves of
# different kinds, a dark-to-light palette for families in order.
set border 3 linewidth 1 linecolor rgb '#555555'
# Without the blank for a sign, which moves numbers from their ticks.
set format '%g'
set tics nomirror out textcolor rgb '#333333'
set grid linetype 1 linewidth 0.6 linecolor rgb '#e4e4e4'
set key outside right center Left reverse samplen 2.5 spacing 1.25
set linetype 1 linewidth 2.5 linecolor rgb '#4477aa'
set linetype 2 linewidth 2.5 linecolor rgb '#ee6677'
set linetype 3 linewidth 2.5 linecolor rgb '#228833'
set linetype 4 linewidth 2.5 linecolor rgb '#ccbb44'
set linetype 5 linewidth 2.5 linecolor rgb '#66ccee'
set linetype 6 linewidth 2.5 linecolor rgb '#aa3377'
set linetype 7 linewidth 2.5 linecolor rgb '#888888'
set dashtype 2 (9, 6)
set dashtype 3 (2, 4)
set palette defined (0 '#440154', 0.3 '#3b528b', 0.6 '#21918c', \
  0.85 '#5ec962', 1 '#9bd93c')
