# How a surface is curved: a histogram of each measure. What comes before this text sets `picture`, `title`, arrays of
# `names`, `medians`, `lows`, `steps` and `highs` (of six), and $data: index: the measure; columns: the middle of a bin, its part of the
# area in %, and that of the area that is clear of noise.
set terminal svg size 1180,640 noenhanced font "DejaVu Sans,12" background "#ffffff"
set output picture
set datafile separator "\t"
set multiplot layout 2,3 margins 0.06,0.985,0.095,0.85 spacing 0.065,0.155
set label 1 title at screen 0.012,0.965 left font ",15"
set grid lc rgb "#d8d8d8"
set border lc rgb "#777777"
set style fill solid 1.0 noborder
set yrange [0 : *]
do for [p = 1:6] {
  set xrange [lows[p] : highs[p]]
  span = highs[p] - lows[p]
  power = 10.0 ** floor(log10(span / 5.0))
  tick = power * (span / power > 25 ? 10 : span / power > 10 ? 5 : 2)
  set xtics tick font ",10"
  set ytics autofreq font ",10"
  set format "%g"
  set xlabel names[p] offset 0,0.4
  if (p == 1 || p == 4) { set ylabel "% of the area" offset 1,0 } else { unset ylabel }
  if (p == 1) { set key at screen 0.985,0.975 right top horizontal samplen 1.5 font ",11" maxrows 1 } else { unset key }
  set arrow 1 from first medians[p], graph 0 to first medians[p], graph 1 nohead lc rgb "#c4442e" lw 1.5 front
  if (p == 2) { unset label 1 }
  plot $data index p - 1 using 1:2:(steps[p]) with boxes lc rgb "#b9cbe2" title "all", \
       $data index p - 1 using 1:3:(steps[p]) with boxes lc rgb "#3465a4" title "clear of noise", \
       NaN with lines lc rgb "#c4442e" lw 1.5 title "median"
}
unset multiplot
