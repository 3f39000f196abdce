# The share that is left, and the share that is lost.
set xlabel '$t$ in s'
set ylabel share
set xrange [0:4*half_life]
plot curves using "t":"left" with lines ls 1 title 'left', \
     curves using "t":"lost" with lines ls 2 title 'lost'
