// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column.hpp"

#include <utility>

#include "literate/text/latex.hpp"

namespace literate {

Column::Column(ColumnFormat format) : format_(std::move(format)) {
  require_unit(format_.unit);
}

Column Column::fixed(std::string heading, std::string unit, int decimals) {
  return scaled(std::move(heading), std::move(unit), 0, decimals);
}

Column Column::scaled(std::string heading, std::string unit, int exponent, int decimals) {
  return Column({ColumnKind::fixed, std::move(heading), std::move(unit), exponent, decimals});
}

Column Column::common_exponent(std::string heading, std::string unit, int n_digits) {
  return Column({ColumnKind::common_exponent, std::move(heading), std::move(unit), 0, n_digits});
}

Column Column::scientific(std::string heading, std::string unit, int n_digits) {
  return Column({ColumnKind::scientific, std::move(heading), std::move(unit), 0, n_digits});
}

Column Column::integer(std::string heading, std::string unit) {
  return Column({ColumnKind::integer, std::move(heading), std::move(unit)});
}

Column Column::text(std::string heading) {
  return Column({ColumnKind::text, std::move(heading), ""});
}

}  // namespace literate
