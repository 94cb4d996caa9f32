# Plot of data/tensile.csv; called by tensile.sh with ending = "svg" or "png".
if (ending eq "svg") { set terminal svg size 1100,880 font "sans-serif,15" background "white" } \
else { set terminal pngcairo size 1100,880 font "sans-serif,13" }
set output "figures/tensile.".ending
set datafile separator ","
set multiplot layout 2,2 title "Strips 150 x 50 mm, clamped ends"
set xlabel "stretch"
set xrange [1:1.4]
set grid
set key top left
wale = "#0072b2"; course = "#d55e00"; bias = "#009e73"
do for [fabric in "pantyhose T-shirt"] {
  r = fabric." rebar "; i = fabric." Itskov "
  set title fabric.": force on 50 mm"
  set ylabel "N"
  set yrange [0:*]
  plot for [d in "wale course bias"] "data/tensile.csv" using "stretch":(column(r.d." force [N]")) \
         with lines lw 2 lc rgb value(d) title "rebar, ".d, \
       for [d in "wale course bias"] "" using "stretch":(column(i.d." force [N]")) \
         with lines lw 2 dt 2 lc rgb value(d) title "Itskov, ".d
}
do for [fabric in "pantyhose T-shirt"] {
  r = fabric." rebar "; i = fabric." Itskov "
  set title fabric.": length of the middle section"
  set ylabel "mm"
  set yrange [40:50]
  set key bottom left
  plot for [d in "wale course bias"] "data/tensile.csv" using "stretch":(column(r.d." section [mm]")) \
         with lines lw 2 lc rgb value(d) title "rebar, ".d, \
       for [d in "wale course bias"] "" using "stretch":(column(i.d." section [mm]")) \
         with lines lw 2 dt 2 lc rgb value(d) title "Itskov, ".d
}
unset multiplot
