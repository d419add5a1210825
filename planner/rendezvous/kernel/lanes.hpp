// Packs of W doubles that one instruction works on; W = 1 is a plain double.
//
// Included only by the files that are compiled for one instruction set: everything here has internal linkage, and no
// template of the standard library is used, so that no wider instruction leaks into code shared with other files.
// Source: GCC's vector extensions. Departs from source: none. Complexity: O(1).
#pragma once

#include <cstddef>

namespace skein::rendezvous::kernel {
namespace {

/// Of a width: its pack, the mask that a comparison gives, and what the vector extensions do not spell.
template <std::size_t W>
struct PackOf;

template <>
struct PackOf<2> {
  typedef double Pack __attribute__((vector_size(16)));
  typedef long Mask __attribute__((vector_size(16)));
  static Pack least(Pack a, Pack b) { return __builtin_ia32_minpd(a, b); }
  static Pack most(Pack a, Pack b) { return __builtin_ia32_maxpd(a, b); }
  static int bits(Mask mask) { return __builtin_ia32_movmskpd((Pack)mask); }
};

#ifdef __AVX2__
template <>
struct PackOf<4> {
  typedef double Pack __attribute__((vector_size(32)));
  typedef long Mask __attribute__((vector_size(32)));
  static Pack least(Pack a, Pack b) { return __builtin_ia32_minpd256(a, b); }
  static Pack most(Pack a, Pack b) { return __builtin_ia32_maxpd256(a, b); }
  static int bits(Mask mask) { return __builtin_ia32_movmskpd256((Pack)mask); }
};
#endif

#ifdef __AVX512DQ__
template <>
struct PackOf<8> {
  typedef double Pack __attribute__((vector_size(64)));
  typedef long Mask __attribute__((vector_size(64)));
  typedef long long Bits __attribute__((vector_size(64)));
  static Pack least(Pack a, Pack b) { return a < b ? a : b; }
  static Pack most(Pack a, Pack b) { return a > b ? a : b; }
  static int bits(Mask mask) { return __builtin_ia32_cvtq2mask512((Bits)mask); }
};
#endif

template <std::size_t W>
struct LanesOf {
  using Pack = typename PackOf<W>::Pack;
  using Mask = typename PackOf<W>::Mask;
  static constexpr std::size_t kWidth = W;
  /// Packs that a loop with a long chain of dependent steps works on in turn.
  static constexpr std::size_t kInterleaved = 4;

  static Pack load(const double* from) {
    Pack pack;
    __builtin_memcpy(&pack, from, sizeof pack);
    return pack;
  }
  static void store(double* to, Pack pack) { __builtin_memcpy(to, &pack, sizeof pack); }
  static Pack all(double x) { return Pack{} + x; }
  static Pack root(Pack x) {
    Pack roots;
    for (std::size_t i = 0; i < W; ++i) roots[i] = __builtin_sqrt(x[i]);
    return roots;
  }
  static Pack magnitude(Pack x) { return (Pack)((Mask)x & kNotSign); }
  static Pack least(Pack a, Pack b) { return PackOf<W>::least(a, b); }
  static Pack most(Pack a, Pack b) { return PackOf<W>::most(a, b); }
  static bool any(Mask mask) { return PackOf<W>::bits(mask) != 0; }
  static bool every(Mask mask) { return PackOf<W>::bits(mask) == (1 << W) - 1; }
  /// Bit i for lane i.
  static unsigned bits(Mask mask) { return static_cast<unsigned>(PackOf<W>::bits(mask)); }

 private:
  static constexpr long kNotSign = 0x7fffffffffffffff;
};

template <>
struct LanesOf<1> {
  using Pack = double;
  using Mask = bool;
  static constexpr std::size_t kWidth = 1;
  static constexpr std::size_t kInterleaved = 1;

  static Pack load(const double* from) { return *from; }
  static void store(double* to, Pack x) { *to = x; }
  static Pack all(double x) { return x; }
  static Pack root(Pack x) { return __builtin_sqrt(x); }
  static Pack magnitude(Pack x) { return __builtin_fabs(x); }
  static Pack least(Pack a, Pack b) { return a < b ? a : b; }
  static Pack most(Pack a, Pack b) { return a > b ? a : b; }
  static bool any(bool mask) { return mask; }
  static bool every(bool mask) { return mask; }
  static unsigned bits(bool mask) { return mask ? 1 : 0; }
};

/// Complex numbers written out, in the order of operations of ph/complex.hpp.
template <typename Pack>
struct Number {
  Pack re;
  Pack im;
};

template <typename Pack>
Number<Pack> operator+(Number<Pack> a, Number<Pack> b) {
  return {a.re + b.re, a.im + b.im};
}
template <typename Pack>
Number<Pack> operator-(Number<Pack> a, Number<Pack> b) {
  return {a.re - b.re, a.im - b.im};
}
template <typename Pack>
Number<Pack> operator-(Number<Pack> a) {
  return {-a.re, -a.im};
}
template <typename Pack>
Number<Pack> operator*(Number<Pack> a, Number<Pack> b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <typename Pack>
Number<Pack> scaled(double k, Number<Pack> a) {
  return {k * a.re, k * a.im};
}
template <typename Pack>
Pack dot(Number<Pack> a, Number<Pack> b) {
  return a.re * b.re + a.im * b.im;
}
template <typename Pack>
Pack cross(Number<Pack> a, Number<Pack> b) {
  return a.re * b.im - a.im * b.re;
}

/// Vectors of three coordinates, summed in the order in which Eigen sums them.
template <typename Pack>
struct Triple {
  Pack x;
  Pack y;
  Pack z;
};

template <typename Pack>
Triple<Pack> operator+(Triple<Pack> a, Triple<Pack> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Pack>
Triple<Pack> operator-(Triple<Pack> a, Triple<Pack> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Pack>
Triple<Pack> scaled(double k, Triple<Pack> a) {
  return {k * a.x, k * a.y, k * a.z};
}
template <typename Pack>
Pack dot(Triple<Pack> a, Triple<Pack> b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <typename Pack>
Triple<Pack> cross(Triple<Pack> a, Triple<Pack> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// c0 + c1 q + ... + c4 q^4, the coefficients in five rows of a table.
template <typename Lanes>
typename Lanes::Pack quartic(const double* rows, std::size_t stride, typename Lanes::Pack q) {
  typename Lanes::Pack value = Lanes::load(rows + 4 * stride);
  for (std::size_t k = 4; k-- > 0;) value = Lanes::load(rows + k * stride) + q * value;
  return value;
}

}  // namespace
}  // namespace skein::rendezvous::kernel
