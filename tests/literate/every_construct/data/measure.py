# Writes measured.csv: what a counter would have seen.
# begin excerpt: counter
def seen(time, half_life=750.0):
    """The share of the sample that the counter sees."""
    return 2 ** (-time / half_life)
# end excerpt: counter


print('t (s),share,abs_error,counter')
for time in (0, 300, 600):
    print(f'{time},{seen(time):.3f},0.001,left')
