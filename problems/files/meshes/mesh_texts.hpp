// The texts of the files that a problem file names, and that these include: all that is read of
// them, so that one rank can read the files and all can make the same structure of them.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace kusabi::problems {

class MeshTexts {
 public:
  MeshTexts() = default;
  /// @param problem_file its name: the others stand relative to its folder
  /// @param texts by the place that `place` says
  MeshTexts(const std::string& problem_file, const std::map<std::string, std::string>& texts)
      : problem_file_(problem_file), texts_(&texts) {}

  /// The place of the file that is called `name` in the file at `from` (empty: in the problem
  /// file), relative to the folder of the problem file.
  static std::string place(const std::string& from, std::string_view name);

  /// Null if the file is not among those that were read.
  const std::string* text(const std::string& place) const;

  /// How errors name it: as seen from where the problem file was named.
  std::string name(const std::string& place) const;

 private:
  std::string problem_file_;
  const std::map<std::string, std::string>* texts_ = nullptr;
};

}  // namespace kusabi::problems
