# gnuplot -c scaling.gp TABLE PICTURE: growth of a frame's time beside that of blocks and voxels, relative to
# the smallest volume.
set terminal svg size 640,420 font "DejaVu Sans,13" background "#ffffff"
set output ARG2
stats ARG1 using 1 every ::0::0 nooutput name "edge"
stats ARG1 using 2 every ::0::0 nooutput name "blocks"
stats ARG1 using 3 every ::0::0 nooutput name "frame"
set logscale x 2
set logscale y 10
set xtics (64, 128, 256, 512)
set xrange [58:565]
set yrange [0.7:700]
set xlabel "edge of the volume, voxels"
set ylabel sprintf("growth (1 = at %d^3)", edge_min)
set key top left Left reverse
set grid lc rgb "#dddddd"
set style line 1 lc rgb "#999999" lw 2 dt 2 pt 4
set style line 2 lc rgb "#3465a4" lw 2 pt 6
set style line 3 lc rgb "#c4442e" lw 3 pt 7
plot ARG1 using 1:(($1/edge_min)**3) with linespoints ls 1 title "voxels", \
     ARG1 using 1:($2/blocks_min) with linespoints ls 2 title "blocks that hold the surface", \
     ARG1 using 1:($3/frame_min) with linespoints ls 3 title "time of a frame"
