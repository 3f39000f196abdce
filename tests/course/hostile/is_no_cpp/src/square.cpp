// SPDX-License-Identifier: GPL-3.0-or-later
\documentclass {
  article
}
\begin{document} I did not get to it. \end {
  document
}
