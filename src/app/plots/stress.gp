# SPDX-License-Identifier: GPL-3.0-or-later
# The greatest shear in the plane and von Mises' stress against the depth z, a curve for each x, or along
# x at one depth; and McEwen's closed form where there is one. A blank line of the data parts the curves.
set xlabel sprintf('%s (%s)', axis, length_unit)
set ylabel sprintf('stress (%s)', stress_unit)
set key outside top center horizontal
if (exists('mcewen')) {
  plot mcewen using "place":"max_shear" with lines ls 1 title 'greatest shear, McEwen', \
       points using "place":"max_shear" with points ls 11 title 'greatest shear', \
       points using "place":"von_mises" with points ls 13 title 'von Mises'
} else {
  plot points using "place":"max_shear" with linespoints ls 11 title 'greatest shear', \
       points using "place":"von_mises" with linespoints ls 13 title 'von Mises'
}
