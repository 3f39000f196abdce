// SPDX-License-Identifier: GPL-3.0-or-later
template <int depth, class... Types>
struct Bomb {
  using Left = typename Bomb<depth - 1, Types..., int>::Type;
  using Right = typename Bomb<depth - 1, Types..., char>::Type;
  struct Type {
    Left left;
    Right right;
  };
};

template <class... Types>
struct Bomb<0, Types...> {
  struct Type {};
};

double square(double x) {
  return x * sizeof(Bomb<40>::Type);
}
