// Texts of the files named by a problem file and of the files these include. One rank reads them,
// and all ranks construct the same structure.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace kusabi::problems {

class MeshTexts {
 public:
  MeshTexts() = default;
  /// @param problem_file its name; the others are relative to its folder
  /// @param texts by the path of `place`
  MeshTexts(const std::string& problem_file, const std::map<std::string, std::string>& texts)
      : problem_file_(problem_file), texts_(&texts) {}

  /// The path, relative to the folder of the problem file, of the file `name` in the file at `from`
  /// (empty: the problem file).
  static std::string place(const std::string& from, std::string_view name);

  /// The text at a path; null if the file was not read.
  const std::string* text(const std::string& place) const;

  /// Name in messages, relative to the working directory as the problem file's name is.
  std::string name(const std::string& place) const;

 private:
  std::string problem_file_;
  const std::map<std::string, std::string>* texts_ = nullptr;
};

}  // namespace kusabi::problems
