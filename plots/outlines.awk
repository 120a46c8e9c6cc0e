# Outlines of core and boosters from a history of data/cases/soyuz.toml:
#   awk -v times='0.5 2' -f outlines.awk HISTORY.csv
# prints five blocks of corners y,x in the core's axes for each time, seen from
# -z and those behind first: booster 2, core, boosters 1, 3 and 4.
BEGIN {
  FS = ","
  count = split(times, time, " ")
}
NR == 1 {
  for (i = 1; i <= NF; ++i) at[$i] = i
}

# Turns a vector from the axes of BODY to those of space; sign -1: back.
function rotate(body, sign, vector,   i, j, k, w, q, u) {
  w = $at[body ".qw"]
  q[1] = sign * $at[body ".qx"]
  q[2] = sign * $at[body ".qy"]
  q[3] = sign * $at[body ".qz"]
  for (i = 1; i <= 3; ++i) {
    j = i % 3 + 1
    k = j % 3 + 1
    u[i] = q[j] * vector[k] - q[k] * vector[j] + w * vector[i]
  }
  for (i = 1; i <= 3; ++i) {
    j = i % 3 + 1
    k = j % 3 + 1
    vector[i] += 2 * (q[j] * u[k] - q[k] * u[j])
  }
}

# A cone, 19.6 m long and 1.34 m in radius, its centre of mass 6.9 m from the
# base; the core's is 18.2 m from the nozzles.
function booster(name,   i, x, axis, place, width) {
  split("1 0 0", axis, " ")
  rotate(name, 1, axis)
  rotate("core", -1, axis)
  for (i = 1; i <= 3; ++i) {
    x = substr("xyz", i, 1) "_m"
    place[i] = $at[name "." x] - $at["core." x]
  }
  rotate("core", -1, place)
  width = 1.34 / sqrt(axis[1] ^ 2 + axis[2] ^ 2)
  corner(place, axis, -6.9, width)
  corner(place, axis, -6.9, -width)
  corner(place, axis, 19.6 - 6.9, 0)
  corner(place, axis, -6.9, width)
  print "\n"
}
function corner(place, axis, along, across) {
  print place[2] + along * axis[2] + across * axis[1] "," \
    18.2 + place[1] + along * axis[1] - across * axis[2]
}

function core(   i, n, x, y) {
  n = split("0 20 27.1 28.1 47.8 49.1 49.5", x, " ")
  split("1.025 1.475 1.475 1.4 1.4 0.7 0", y, " ")
  for (i = 1; i <= n; ++i) print y[i] "," x[i]
  for (i = n; i >= 1; --i) print -y[i] "," x[i]
  print y[1] "," x[1]
  print "\n"
}

NR > 1 {
  for (; drawn < count && $1 >= time[drawn + 1] - 1e-9; ++drawn) {
    booster("booster_2")
    core()
    for (i = 1; i <= 4; ++i) if (i != 2) booster("booster_" i)
  }
}
