# What all figures share; it is read before each script.
set style line 1 lw 2
set style line 2 lw 2 dt 2
