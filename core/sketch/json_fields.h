#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief Takes typed values out of a document and keeps the first thing that is wrong.
//! \details Every member returns false once something has failed; `place` is a path such as
//! `lines[3].from` that the message begins with.
class FieldReader {
 public:
  //! \return Always false, so that a caller can return it.
  bool fail(std::string_view place, std::string_view message);

  //! Refuses keys that the format does not have: most are misspelt, and would be lost in silence.
  bool object(const nlohmann::json& value,
              std::string_view place,
              std::initializer_list<std::string_view> knownKeys);

  bool array(const nlohmann::json& value, std::string_view place, std::string_view whatItHolds);

  //! \return The member, or null after noting that it is missing (`wanted` says what would be
  //! right).
  const nlohmann::json* required(const nlohmann::json& object,
                                 std::string_view key,
                                 std::string_view place,
                                 std::string_view wanted);

  //! A finite number within +-`limit`.
  bool number(const nlohmann::json& value, std::string_view place, double limit, double& out);

  //! Three finite numbers within +-`limit`.
  bool vector(const nlohmann::json& value,
              std::string_view place,
              double limit,
              lattice::Vec3& out);

  //! A vector that is not zero, made unit length.
  bool direction(const nlohmann::json& value, std::string_view place, lattice::Vec3& out);

  bool boolean(const nlohmann::json& value, std::string_view place, bool& out);

  bool text(const nlohmann::json& value, std::string_view place, std::string& out);

  //! "x", "y" or "z".
  bool axis(const nlohmann::json& value, std::string_view place, lattice::Axis& out);

  //! The number of a line: a whole number in [0, lineCount).
  bool lineIndex(const nlohmann::json& value, std::string_view place, int lineCount, int& out);

  //! A list of line numbers without repetition.
  bool lineIndices(const nlohmann::json& value,
                   std::string_view place,
                   int lineCount,
                   std::vector<int>& out);

  [[nodiscard]] bool failed() const { return !message_.empty(); }

  [[nodiscard]] base::Error error() const {
    return base::Error{base::Status::kInvalidInput, message_};
  }

 private:
  std::string message_;
};

//! \brief `place[index]`.
std::string elementPlace(std::string_view place, std::size_t index);

//! \brief `place.key`.
std::string memberPlace(std::string_view place, std::string_view key);

//! \brief The letter of an axis.
std::string_view axisName(lattice::Axis axis);

}  // namespace liftarm::sketch
