# The period over that of small swings, as a function of the amplitude.
set xlabel '$\theta$ in degrees'
set ylabel '$T/T_0$'
set key top left
plot periods using "angle":"integral" with lines lt 1 title 'integral', \
     periods using "angle":"series" with lines lt 2 title '$1 + \theta^2/16$'
