#!/usr/bin/env bash
# Draws the figures of docs/families from the sweep's own curves: sets up and builds what is missing, runs one seed of
# each planner, and writes SVG files.
#
# usage: deploy/figures.sh [FOLDER]    where the files go: docs/figures by default
set -euo pipefail
target=$(realpath -m "${1:-$(dirname "${BASH_SOURCE[0]}")/../docs/figures}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

deploy/setup.sh figures
cmake --preset release --log-level=WARNING >/dev/null
cmake --build build/release --target skein -- --quiet

curves=$(mktemp -d)
trap 'rm -rf "$curves"' EXIT
for scenario in rendezvous-2d rendezvous-3d; do
  build/release/bin/skein sweep "deploy/scenarios/$scenario.yaml" --runs 1 --seed 1 \
    --planner dcpso,dcpso-paper,dcpso-solo --curves "$curves/$scenario" >/dev/null
done
build/release/bin/skein sweep deploy/scenarios/transit-power-station.yaml --runs 1 --seed 1 \
  --set planner.name=peach3d,peach3d-paper,peach --curves "$curves/transit-power-station" >/dev/null
mkdir -p "$target"

# draw NAME WIDTH HEIGHT < gnuplot commands; they find the curves in `plane`, `space` and `station`.
draw() {
  {
    cat <<PRELUDE
set terminal svg noenhanced size $2,$3 font 'DejaVu Sans,11' background '#ffffff'
set output '$target/$1.svg'
plane = '$curves/rendezvous-2d/'
space = '$curves/rendezvous-3d/'
station = '$curves/transit-power-station/'
PRELUDE
    cat <<'PRELUDE'
set encoding utf8
set datafile separator comma
set datafile columnheaders
set datafile missing NaN
array planner[3] = ['dcpso', 'dcpso-paper', 'dcpso-solo']
array colour[3] = ['#0072b2', '#d55e00', '#009e73']
stem(i) = sprintf('%d-%s-', i, planner[i])
paths(i) = stem(i) . 'paths.csv'
zones(i) = stem(i) . 'zones.csv'
convergence(i) = stem(i) . 'convergence.csv'
of(name, index, value) = column(name) == index ? value : NaN
km(name) = column(name) / 1000
per_km(name) = column(name) * 1000
zone_x(index) = of('zone', index, km('x_m'))
fill(index) = index <= 2 ? '#c8c8c8' : '#f6c6c6'
uav(v) = sprintf('UAV %d', v)
set tics nomirror
set grid linecolor '#e4e4e4'
PRELUDE
    cat
  } | gnuplot
  echo "figures: $target/$1.svg"
}

draw rendezvous-2d-paths 1000 350 <<'PLOT'
set multiplot layout 1,3 margins 0.06,0.985,0.24,0.91 spacing 0.05,0
set size ratio -1
set xrange [-5:33]
set yrange [-8:24]
set xlabel 'x (km)'
set key horizontal maxrows 1 samplen 2
do for [i=1:3] {
  set title planner[i]
  if (i == 1) { set ylabel 'y (km)' } else { unset ylabel }
  if (i == 3) { unset key } else { set key on at screen (i == 1 ? 0.2 : 0.52),0.03 center bottom }
  plot for [z=1:4] plane.zones(i) using (zone_x(z)):(km('y_m')) with filledcurves closed fillcolor rgb fill(z) \
         title (i > 1 ? '' : z == 1 ? 'obstacle' : z == 3 ? 'no-fly zone' : ''), \
       for [v=1:3] plane.paths(i) using (of('vehicle', v, km('x_m'))):(km('y_m')) with lines linewidth 2 \
         linecolor rgb colour[v] title (i == 1 ? '' : uav(v))
}
PLOT

draw rendezvous-2d-curvature 1000 360 <<'PLOT'
set multiplot layout 1,3 margins 0.07,0.985,0.27,0.91 spacing 0.035,0
set xrange [0:36]
set yrange [-2.3:2.3]
set xlabel 'distance along the path (km)'
set key horizontal maxrows 1 samplen 2
do for [i=1:3] {
  set title planner[i]
  if (i == 1) { set ylabel 'curvature (1/km), left positive' } else { unset ylabel }
  if (i == 3) { unset key } else { set key on at screen (i == 1 ? 0.2 : 0.52),0.03 center bottom }
  plot for [side=-1:1:2] plane.paths(i) every 200::0::200 using (km('arc_m')):(side * per_km('max_curvature_per_m')) \
         with lines dashtype 2 linecolor rgb '#555555' title (i == 1 && side < 0 ? 'limit' : ''), \
       for [v=1:3] plane.paths(i) using (of('vehicle', v, km('arc_m'))):(per_km('curvature_per_m')) \
         with lines linewidth 2 linecolor rgb colour[v] title (i == 1 ? '' : uav(v))
}
PLOT

# What each generation published: its modified cost and the length of its path.
plot_convergence='
set multiplot layout 2,3 margins 0.075,0.985,0.16,0.93 spacing 0.05,0.05
set xrange [0:50]
set key at screen 0.5,0.02 center bottom horizontal maxrows 1 samplen 2
do for [row=1:2] {
  do for [i=1:3] {
    if (row == 1) { set title planner[i]; unset xlabel; set format x ""; set yrange [15.5:24]; set ytics 2 } \
    else { unset title; set xlabel "generation"; set format x; set yrange [31:36]; set ytics 1 }
    if (i == 1) { set ylabel (row == 1 ? "modified cost (km)" : "path length (km)") } else { unset ylabel }
    if (row == 2 && i == 2) { set key on } else { unset key }
    plot for [v=1:3] folder.convergence(i) \
      using (column("round") == column("generation") + 1 ? of("vehicle", v, column("generation")) : NaN):(row == 1 ? \
      column("cost") : km("path_length_m")) with lines linewidth 2 linecolor rgb colour[v] title uav(v)
  }
}
'
draw rendezvous-2d-convergence 1000 520 <<<"folder = plane$plot_convergence"
draw rendezvous-3d-convergence 1000 520 <<<"folder = space$plot_convergence"

draw rendezvous-3d-paths 1000 520 <<'PLOT'
set multiplot
set key at screen 0.26,0.02 center bottom horizontal maxrows 1 samplen 2
set xrange [-5:33]
set xlabel 'x (km)'
set lmargin at screen 0.06
set rmargin at screen 0.47
set tmargin at screen 0.93
set bmargin at screen 0.19
set title 'from above'
set size ratio -1
set yrange [-8:24]
set ylabel 'y (km)'
set label 1 'to 4 km' at 8.5,3.4 right front
set label 2 'to 2.8 km' at 6.5,17.5 center front
set label 3 'from 3.4 km' at 14,10.5 center front
plot for [z=1:5] space.zones(1) using (zone_x(z)):(km('y_m')) with filledcurves closed fillcolor rgb fill(z) \
       title (z == 1 ? 'obstacle' : z == 3 ? 'no-fly zone' : ''), \
     for [v=1:3] space.paths(1) using (of('vehicle', v, km('x_m'))):(km('y_m')) with lines linewidth 2 \
       linecolor rgb colour[v] notitle
unset label
set size noratio
set lmargin at screen 0.54
set rmargin at screen 0.985
set title 'from the side; dotted: the ground below each path'
set yrange [0:6]
set ylabel 'height (km)'
set key at screen 0.76,0.02 center bottom
plot for [v=1:3] space.paths(1) using (of('vehicle', v, km('x_m'))):(km('z_m')) with lines linewidth 2 \
       linecolor rgb colour[v] title uav(v), \
     for [v=1:3] '' using (of('vehicle', v, km('x_m'))):(km('ground_m')) with lines dashtype 3 \
       linecolor rgb colour[v] notitle
PLOT

# Along the path in space: dcpso beside the UAVs on their own.
plot_along='
set multiplot layout 1,2 margins 0.07,0.985,0.24,0.91 spacing 0.04,0
set xrange [0:36]
set yrange [low:2.3]
set xlabel "distance along the path (km)"
set key at screen 0.5,0.03 center bottom horizontal maxrows 1 samplen 2
do for [i=1:3:2] {
  set title planner[i]
  if (i == 1) { set ylabel what." (1/km)"; unset key } else { unset ylabel; set key on }
  plot for [side=-1:1:2] space.paths(i) every 200::0::200 using (km("arc_m")):(side * per_km("max_".what."_per_m")) \
         with lines dashtype 2 linecolor rgb "#555555" title (side < 0 ? "limit" : ""), \
       for [v=1:3] space.paths(i) using (of("vehicle", v, km("arc_m"))):(per_km(what."_per_m")) with lines linewidth 2 \
         linecolor rgb colour[v] title uav(v)
}
'
draw rendezvous-3d-curvature 1000 380 <<<"what = 'curvature'; low = 0$plot_along"
draw rendezvous-3d-torsion 1000 380 <<<"what = 'torsion'; low = -2.3$plot_along"

# Nine UAVs, each a colour, from the circles to the cross; seen from above.
draw transit-power-station-paths 1000 380 <<'PLOT'
set multiplot layout 1,3 margins 0.075,0.985,0.13,0.92 spacing 0.045,0
set size ratio -1
set xrange [0:500]
set yrange [0:500]
set tics 100
unset grid
unset key
set xlabel 'x (m)'
array hue[9] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#7f3c8d', '#8c564b', '#333333']
array name[3] = ['peach3d', 'peach3d-paper', 'peach']
file(i, what) = station . sprintf('%d-%s-%s.csv', i, name[i], what)
do for [i=1:3] {
  set title name[i]
  if (i == 1) { set ylabel 'y (m)' } else { unset ylabel }
  plot for [z=1:28] file(i, 'zones') using (of('zone', z, column('x_m'))):(column('y_m')) with filledcurves closed \
         fillcolor rgb '#c8c8c8', \
       for [v=1:9] file(i, 'positions') using (of('vehicle', v, column('x_m'))):(column('y_m')) with lines \
         linewidth 1.2 linecolor rgb hue[v], \
       for [v=1:9] '' using (column('step') == 0 ? of('vehicle', v, column('x_m')) : NaN):(column('y_m')) with points \
         pointtype 7 pointsize 0.4 linecolor rgb hue[v], \
       '+' every ::0::0 using (465):(330) with points pointtype 2 pointsize 1.2 linewidth 2 linecolor rgb '#000000'
}
PLOT
