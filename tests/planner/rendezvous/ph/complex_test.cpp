#include "planner/rendezvous/ph/complex.hpp"

#include <gtest/gtest.h>

namespace skein::rendezvous::ph {
namespace {

TEST(Complex, ArithmeticByHand) {
  constexpr Complex a{1.0, 2.0};
  constexpr Complex b{3.0, -1.0};
  EXPECT_EQ(a + b, (Complex{4.0, 1.0}));
  EXPECT_EQ(a - b, (Complex{-2.0, 3.0}));
  EXPECT_EQ(a * b, (Complex{5.0, 5.0}));
  EXPECT_EQ(2.0 * a, (Complex{2.0, 4.0}));
  EXPECT_EQ(dot(a, b), 1.0);
  EXPECT_EQ(cross(a, b), -7.0);
}

TEST(Complex, SquareRootIsPrincipal) {
  EXPECT_EQ(square_root({4.0, 0.0}), (Complex{2.0, 0.0}));
  EXPECT_EQ(square_root({-4.0, 0.0}), (Complex{0.0, 2.0}));
  EXPECT_EQ(square_root({0.0, 0.0}), (Complex{0.0, 0.0}));
  for (const Complex z : {Complex{3.0, 4.0}, Complex{-3.0, 4.0}, Complex{-3.0, -4.0}, Complex{1e-9, -2.0}}) {
    const Complex root = square_root(z);
    EXPECT_GE(root.re, 0.0);
    EXPECT_NEAR((root * root).re, z.re, 1e-15 * 5.0);
    EXPECT_NEAR((root * root).im, z.im, 1e-15 * 5.0);
  }
}

}  // namespace
}  // namespace skein::rendezvous::ph
