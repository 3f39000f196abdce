# The share that is lost, by itself.
set xtics 3000
set ytics 0.5
set xlabel '$t$ in s'
plot curves using "t":"lost" with lines ls 1 notitle
