// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace block {

/// The cross-section of the block, |x| ≤ width/2 and 0 ≤ z ≤ height; its top z = 0 carries the
/// load.
class Rectangle {
 public:
  /// width and height (lengths), both finite and > 0, or InvalidQuantity is thrown.
  Rectangle(double width, double height);

  double width() const { return width_; }
  double height() const { return height_; }
  double left() const { return -width_ / 2; }
  double right() const { return width_ / 2; }

 private:
  double width_;
  double height_;
};

}  // namespace block
