// SPDX-License-Identifier: GPL-3.0-or-later
// {fmt} for the static judge, since Debian has no archive of it: its functions, and the templates
// that its headers declare elsewhere.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail {
template FMT_API auto thousands_sep_impl(locale_ref) -> thousands_sep_result<char>;
template FMT_API auto decimal_point_impl(locale_ref) -> char;
}  // namespace detail
FMT_END_NAMESPACE
