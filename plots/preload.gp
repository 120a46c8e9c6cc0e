# Torque against load of a lined bush, from interference to clearance.
set encoding utf8
set datafile separator ','
set xlabel "load, kN"
set ylabel "friction torque, N m"
set xrange [0:15]
set yrange [0:*]
set key bottom right
clearances = "-5 -3 -1 0 5"
title_of(eps) = eps < 0 ? sprintf("interference %d µm", -eps) : \
  eps == 0 ? "no clearance" : sprintf("clearance %d µm", eps)
plot for [i = 1:words(clearances)] "preload_".word(clearances, i).".csv" \
  skip 1 using ($1 / 1e3):2 with lines linestyle i title title_of(int(word(clearances, i)))
