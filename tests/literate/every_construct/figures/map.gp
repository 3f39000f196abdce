# A surface as a map of colours.
set view map
unset key
set xlabel '$x$'
set ylabel '$y$'
splot grid using "x":"y":"z" with pm3d
