# SPDX-License-Identifier: GPL-3.0-or-later
blue = '#1f4e79'
red = '#8a3324'
set tics nomirror out
