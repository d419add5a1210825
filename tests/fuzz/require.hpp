// What a fuzz target demands of the code under test: a violation ends the process, and libFuzzer keeps the input.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace skein {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

}  // namespace skein
