# One knob of a study: two panels of error against what it costs. What comes before this text sets `picture`, `title`,
# `series` (the legend's name of the first), `joined` (the settings are numbers in order), `comparison` and `fields`
# (there are such points, not both), `bars` (the first error has a standard error, column 11), arrays of two `xlabels`,
# `ylabels`, `bottoms` and `tops` (of the axes of error, powers of ten) and `zeros` (there are errors of 0), and $data:
# label, whether it is the default, then of each panel cost, its lower and upper quartile, and error; index 0: the
# knob's settings, 1: exact hits for comparison, or the settings judged by another field. Colours: Okabe and Ito.
set terminal svg size 860,470 noenhanced font "DejaVu Sans,14" background "#ffffff"
set output picture
set datafile separator "\t"
set multiplot layout 1,2 margins 0.105,0.985,0.15,0.8 spacing 0.145,0
set label 1 title at screen 0.012,0.955 left font ",17"
set grid lc rgb "#d8d8d8"
set border lc rgb "#777777"
set style line 1 lc rgb "#0072b2" lw 2 pt 7 ps 0.8
set style line 2 lc rgb "#b0578d" lw 2 pt 5 ps 0.9
set style line 3 lc rgb "#009e73" lw 2 pt 9 ps 1.2
set style line 4 lc rgb "#d55e00" lw 2.5 pt 6 ps 2
own = "#004b76"
other = "#7d3a63"
steps = "0.001 0.002 0.005 0.01 0.02 0.05 0.1 0.2 0.5 1 2 5 10 20 50 100 200 500 1000 2000 5000 10000"
# An error of 0 stands at the lower end of its axis; what is not a number, nowhere.
shown(e, p) = e > 0 ? e : (e == 0 ? bottoms[p] : NaN)
none(e, p) = e == 0 ? bottoms[p] : NaN
some(e) = e > 0 ? e : NaN
placed(e, p) = e > 0 ? e : bottoms[p]  # of labels: gnuplot 5.4 crashes where none of them has a place
do for [p = 1:2] {
  if (p == 2) { unset label 1 }
  # Not x and y: those are variables of plot itself.
  time = 4 * p - 1
  error = 4 * p + 2
  unset logscale
  set autoscale  # the ranges of the panel before would leave out data here
  stats $data using time nooutput name "T"
  if (T_max > 3 * T_min && T_min > 0) {
    set logscale x
    from = T_min / 1.5
    to = T_max * 1.9
    middle = sqrt(T_min * T_max)
    set xtics () font ",13"
    do for [s in steps] { set xtics add (s s + 0) }
  } else {
    span = T_max - T_min > 0.1 * T_max ? T_max - T_min : 0.1 * T_max
    from = T_min - 0.4 * span
    to = T_max + 0.4 * span
    middle = 0.5 * (from + to)
    set xtics autofreq font ",13"
  }
  set xrange [from : to]
  if (joined) { middle = to }  # labels to the right of every point of a line
  set logscale y
  set yrange [0.9999 * bottoms[p] : 1.0001 * tops[p]]
  set format y "%g"
  if (tops[p] > 150 * bottoms[p]) {
    set ytics autofreq font ",13"
  } else {
    set ytics () font ",13"
    do for [e = -12:9] { do for [m in "1 2 5"] { set ytics add (sprintf("%g", m * 10.0 ** e) m * 10.0 ** e) } }
  }
  set xlabel xlabels[p]
  set ylabel ylabels[p] offset 0.5,0
  if (p == 1) { set key at screen 0.985,0.985 right top samplen 1 font ",13" } else { unset key }
  plot for [i = 0:comparison + fields] $data index i using time:(shown(column(error), p)):time + 1:time + 2 \
           with xerrorbars lc rgb "#9a9a9a" lw 1.2 pt 0 notitle, \
       for [k = 1:(p == 1 ? bars : 0)] $data index 0 using time:(some(column(error))):11 with yerrorbars lc rgb "#9db8d8" lw 1.5 pt 0 notitle, \
       $data index 0 using time:(joined ? shown(column(error), p) : NaN) with lines ls 1 notitle, \
       $data index 0 using time:(some(column(error))) with points ls 1 title series, \
       for [k = 1:fields] $data index 1 using time:(some(column(error))) with points ls 2 title "against cubic_interpolating", \
       for [k = 1:comparison] $data index 1 using time:(some(column(error))) with points ls 3 title "exact hits", \
       for [k = 1:zeros] $data index 0 using time:(none(column(error), p)) with points ls 1 pt 11 ps 1.4 title "no error: at the lower end", \
       for [k = 1:zeros * fields] $data index 1 using time:(none(column(error), p)) with points ls 2 pt 11 ps 1.4 notitle, \
       for [k = 1:zeros * comparison] $data index 1 using time:(none(column(error), p)) with points ls 3 pt 11 ps 1.4 notitle, \
       for [i = 0:comparison + fields] $data index i using time:($2 == 1 ? shown(column(error), p) : NaN) with points ls 4 notitle, \
       NaN with points ls 4 title "default", \
       for [i = 0:1] $data index 0 every 2::i using time:(placed(column(error), p)):(column(time) <= middle && column(error) > 0 ? strcol(1) : "") \
           with labels left offset 0.9,0.7 - 1.4 * i font ",13" tc rgb own notitle, \
       for [i = 0:1] $data index 0 every 2::i using time:(placed(column(error), p)):(column(time) > middle && column(error) > 0 ? strcol(1) : "") \
           with labels right offset -0.9,0.7 - 1.4 * i font ",13" tc rgb own notitle, \
       for [i = 0:2 * zeros - 1] $data index 0 every 2::i using time:(placed(column(error), p)):(column(time) <= middle && column(error) == 0 ? strcol(1) : "") \
           with labels left offset 0.9,0.7 + 0.9 * i font ",13" tc rgb own notitle, \
       for [i = 0:2 * zeros - 1] $data index 0 every 2::i using time:(placed(column(error), p)):(column(time) > middle && column(error) == 0 ? strcol(1) : "") \
           with labels right offset -0.9,0.7 + 0.9 * i font ",13" tc rgb own notitle, \
       for [i = 0:2 * fields - 1] $data index 1 every 2::i using time:(placed(column(error), p)):(column(time) <= middle && column(error) > 0 ? strcol(1) : "") \
           with labels left offset 0.9,0.7 - 1.4 * i font ",13" tc rgb other notitle, \
       for [i = 0:2 * fields - 1] $data index 1 every 2::i using time:(placed(column(error), p)):(column(time) > middle && column(error) > 0 ? strcol(1) : "") \
           with labels right offset -0.9,0.7 - 1.4 * i font ",13" tc rgb other notitle, \
       for [i = 0:2 * zeros * fields - 1] $data index 1 every 2::i using time:(placed(column(error), p)):(column(time) <= middle && column(error) == 0 ? strcol(1) : "") \
           with labels left offset 0.9,0.7 + 0.9 * i font ",13" tc rgb other notitle, \
       for [i = 0:2 * zeros * fields - 1] $data index 1 every 2::i using time:(placed(column(error), p)):(column(time) > middle && column(error) == 0 ? strcol(1) : "") \
           with labels right offset -0.9,0.7 + 0.9 * i font ",13" tc rgb other notitle
}
unset multiplot
