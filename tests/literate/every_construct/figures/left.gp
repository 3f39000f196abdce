# The share that is left, by itself.
set xtics 3000
set ytics 0.5
set xlabel '$t$ in s'
plot curves using "t":"left" with lines ls 1 notitle
