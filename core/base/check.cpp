#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace liftarm::base {

void checkFailed(const char* condition, const char* message, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, message, condition);
  std::abort();
}

}  // namespace liftarm::base
