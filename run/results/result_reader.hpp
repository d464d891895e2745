// ResultReader: checked access to a result file. Missing members, wrong types and numbers out of
// range are errors with a message.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "run/results/result_parser.hpp"
#include "run/session/session.hpp"
#include "support/exact_count.hpp"

namespace kusabi::run {

class ResultReader;

/// True if the file gives friction coefficients to its candidates, which that of the call multiplies.
/// @throws WrongInput
bool has_own_friction(const ResultReader& reader);

/// The text of a result file, which rank 0 reads for all. @throws support::InputError on every rank
std::string result_text(Session& session, const std::string& file);

class ResultReader {
 public:
  /// @throws WrongInput if the text is no JSON
  ResultReader(const std::string& text, std::string file);
  /// Reader of a result that is not in a file yet.
  ResultReader(ResultJson json, std::string file)
      : file_(std::move(file)), json_(std::move(json)) {}

  [[nodiscard]] const ResultJson& all() const { return json_; }

  /// The value of a key. @throws WrongInput if there is none
  [[nodiscard]] const ResultJson& at(const ResultJson& object, const char* key) const;
  /// Null if there is none, or it is null.
  [[nodiscard]] static const ResultJson* find(const ResultJson& object, const char* key);

  [[nodiscard]] std::string text(const ResultJson& object, const char* key) const;
  [[nodiscard]] double number(const ResultJson& object, const char* key) const;
  /// A value as a number. @param name in the message
  double number_of(const ResultJson& value, std::string_view name) const;
  /// The value of the lower or upper bound of a bracket; null if it is open.
  [[nodiscard]] const ResultJson* bound_value(const ResultJson& bracket, const char* key) const;
  /// The same as a number.
  [[nodiscard]] std::optional<double> bound(const ResultJson& bracket, const char* key) const;
  /// A count of any size: a number, or a string of decimal digits.
  [[nodiscard]] support::ExactCount count(const ResultJson& object, const char* key) const;
  /// An index with 0 <= index < count.
  [[nodiscard]] int index(const ResultJson& value, std::size_t count) const;
  [[nodiscard]] const ResultJson& list(const ResultJson& object, const char* key) const;
  /// A list of a given length.
  [[nodiscard]] const ResultJson& list(const ResultJson& object, const char* key,
                                       std::size_t length) const;
  /// A vector of d numbers, with zeros for the others of three.
  [[nodiscard]] Eigen::Vector3d vector(const ResultJson& value, int dimension) const;
  [[nodiscard]] std::vector<std::string> names(const ResultJson& object, const char* key) const;
  /// The answer of the run in a sentence.
  [[nodiscard]] std::string sentence() const { return text(at(all(), "verdict"), "sentence"); }

  /// @throws WrongInput always
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  std::string file_;
  ResultJson json_;
};

}  // namespace kusabi::run
