# One knob of a study: two panels of error against time. What comes before this text sets `picture`, `title`,
# `series` (the legend's name of the first), `joined` (the settings are numbers in order), `comparison` and `fields`
# (there are such points, not both), `bars` (the first error has a standard error, column 7), arrays of two `xlabels`, `ylabels` and `zeros` (the height that stands for no
# error), and $data: label, whether it is the default, then time and error of each panel; index 0: the knob's settings,
# 1: exact hits for comparison, or the settings judged by another field.
set terminal svg size 1040,480 noenhanced font "DejaVu Sans,12" background "#ffffff"
set output picture
set datafile separator "\t"
set multiplot layout 1,2 margins 0.095,0.985,0.135,0.83 spacing 0.125,0
set label 1 title at screen 0.012,0.95 left font ",15"
set grid lc rgb "#d8d8d8"
set border lc rgb "#777777"
set style line 1 lc rgb "#3465a4" lw 2 pt 7 ps 0.8
set style line 2 lc rgb "#8a5a9e" lw 2 pt 5 ps 0.9
set style line 3 lc rgb "#2e8b57" lw 2 pt 9 ps 1.2
set style line 4 lc rgb "#c4442e" lw 2.5 pt 6 ps 2
own = "#24496f"
other = "#6a3f7c"
steps = "0.01 0.02 0.05 0.1 0.2 0.5 1 2 5 10 20 50 100 200 500 1000 2000 5000 10000"
do for [p = 1:2] {
  # Not x and y: those are variables of plot itself.
  time = 1 + 2 * p
  error = 2 + 2 * p
  unset logscale
  set autoscale  # the ranges of the panel before would leave out data here
  stats $data using time nooutput name "T"
  stats $data using error nooutput name "E"
  if (T_max > 3 * T_min) {
    set logscale x
    from = T_min / 1.5
    to = T_max * 1.9
    middle = sqrt(T_min * T_max)
    set xtics () font ",11"
    do for [s in steps] { set xtics add (s s + 0) }
  } else {
    span = T_max - T_min > 0.1 * T_max ? T_max - T_min : 0.1 * T_max
    from = T_min - 0.4 * span
    to = T_max + 0.4 * span
    middle = 0.5 * (from + to)
    set xtics autofreq font ",11"
  }
  set xrange [from : to]
  if (joined) { middle = to }  # labels to the right of every point of a line
  set logscale y
  set yrange [10 ** floor(log10(E_min / 1.5)) : 10 ** ceil(log10(E_max * 2))]
  set format y "%g"
  set ytics autofreq font ",11"
  if (E_min <= zeros[p] * 1.0001) { set ytics add ("0" zeros[p]) }
  set xlabel xlabels[p]
  set ylabel ylabels[p] offset 0.5,0
  if (p == 1) { set key at screen 0.985,0.955 right top horizontal samplen 1 font ",11" maxrows 1 } else { unset key }
  plot for [k = 1:(p == 1 ? bars : 0)] $data index 0 using time:error:7 with yerrorbars lc rgb "#9db8d8" lw 1.5 pt 0 notitle, \
       $data index 0 using time:(joined ? column(error) : NaN) with lines ls 1 notitle, \
       $data index 0 using time:error with points ls 1 title series, \
       for [k = 1:fields] $data index 1 using time:error with points ls 2 title "against cubic_interpolating", \
       for [k = 1:comparison] $data index 1 using time:error with points ls 3 title "exact hits", \
       $data index 0 using time:($2 == 1 ? column(error) : NaN) with points ls 4 title "default", \
       for [k = 1:fields] $data index 1 using time:($2 == 1 ? column(error) : NaN) with points ls 4 notitle, \
       for [i = 0:1] $data index 0 every 2::i using time:error:(column(time) <= middle ? strcol(1) : "") \
           with labels left offset 0.9,0.7 - 1.4 * i font ",11" tc rgb own notitle, \
       for [i = 0:1] $data index 0 every 2::i using time:error:(column(time) > middle ? strcol(1) : "") \
           with labels right offset -0.9,0.7 - 1.4 * i font ",11" tc rgb own notitle, \
       for [i = 0:2 * fields - 1] $data index 1 every 2::i using time:error:(column(time) <= middle ? strcol(1) : "") \
           with labels left offset 0.9,0.7 - 1.4 * i font ",11" tc rgb other notitle, \
       for [i = 0:2 * fields - 1] $data index 1 every 2::i using time:error:(column(time) > middle ? strcol(1) : "") \
           with labels right offset -0.9,0.7 - 1.4 * i font ",11" tc rgb other notitle
}
unset multiplot
