# Pressure in the plane of the load on two cups: as if their bodies went on
# beyond the rim, and with a side face that is free there.
set encoding utf8
set xlabel "polar angle, °"
set ylabel "pressure, MPa"
set yrange [0:*]
set key inside bottom center
set xtics 15
cups = "bronze hip"
titles = "'bronze, 10 mm, corner of 65°, 4.3 kN' \
'PE, 8 mm, corner of 90°, 3.2 kN at 65°'"
rims = "35 90"
low = "-40 15"
set multiplot layout 1, 2
do for [i = 1:2] {
  rim = word(rims, i) + 0
  set title word(titles, i)
  set xrange [word(low, i) + 0:rim * 1.08]
  set arrow 1 from rim, graph 0 to rim, graph 1 nohead dashtype 3 \
    linecolor rgb '#333333'
  name = "side_face_".word(cups, i)
  plot name."_goes_on.dat" with lines linestyle 2 dashtype 2 \
    title "body goes on", \
    name."_free.dat" with lines linestyle 1 title "side face free"
}
unset multiplot
