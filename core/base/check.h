#pragma once

namespace liftarm::base {

//! \brief Prints the broken invariant with its place and aborts.
[[noreturn]] void checkFailed(const char* condition,
                              const char* message,
                              const char* file,
                              int line);

}  // namespace liftarm::base

//! Invariants of our own code, always on: a bug stops at once. Bad input is a Result instead.
#define LIFTARM_CHECK(condition, message)                                    \
  do {                                                                       \
    if (!(condition)) {                                                      \
      ::liftarm::base::checkFailed(#condition, message, __FILE__, __LINE__); \
    }                                                                        \
  } while (false)
