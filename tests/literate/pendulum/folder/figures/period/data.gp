# Data of the figure period, which gnuplot reads before its script.
set encoding utf8
set decimalsign '.'
set datafile separator comma
width_cm = 10.0
height_cm = 6.0
set terminal cairolatex pdf size width_cm cm, height_cm cm
set output 'period.tex'
periods = 'periods.csv'
largest = 120.0
heading = '$T/T_0$, ''exact'''
