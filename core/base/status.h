#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace liftarm::base {

//! \brief Why an operation did not give its result. Expected failure is a value, never an
//! exception.
enum class Status {
  kOk,
  kInvalidInput,  //!< the input breaks its format or a stated limit
  kUnsupported,   //!< legal input that this program cannot treat
  kInfeasible,    //!< no solution exists or none was found
  kSingular,      //!< a linear system has no unique solution (the structure is a mechanism)
  kCancelled,     //!< stopped on request
};

//! \brief A failure: its kind and one sentence that names the place and what would be right.
struct Error {
  Status status = Status::kInvalidInput;
  std::string message;
};

inline Error invalidInput(std::string message) {
  return {Status::kInvalidInput, std::move(message)};
}

//! \brief Either a value or an Error. Reading the wrong side is a bug and stops the program.
template <typename T>
class Result {
 public:
  Result(T value) : content_(std::move(value)) {}  // NOLINT(google-explicit-constructor)

  Result(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(content_); }

  [[nodiscard]] const T& value() const& {
    LIFTARM_CHECK(ok(), "value() of a failed Result");
    return std::get<T>(content_);
  }

  [[nodiscard]] T&& value() && {
    LIFTARM_CHECK(ok(), "value() of a failed Result");
    return std::get<T>(std::move(content_));
  }

  [[nodiscard]] const Error& error() const {
    LIFTARM_CHECK(!ok(), "error() of a good Result");
    return std::get<Error>(content_);
  }

 private:
  std::variant<T, Error> content_;
};

}  // namespace liftarm::base
