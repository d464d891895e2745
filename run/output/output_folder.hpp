// A folder that the command fills with files, made before the work begins, so that a wrong name
// costs a second and not a night. Each file in it is written as all outputs are: whole or not at
// all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace kusabi::run {

class OutputFolder {
 public:
  /// Makes the folder unless it is there; those above it must be. An empty name: nothing will be
  /// written.
  /// @param option the option of the command that names it, for messages
  /// @param input the problem file, which no file of the folder may be
  /// @throws WrongInput if it is something else than a folder, or cannot be made
  OutputFolder(std::string option, const std::string& name, std::string input);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();  ///< a folder made here that nothing was written to is gone again

  [[nodiscard]] bool wanted() const { return !place_.empty(); }

  /// Writes one file. @pre wanted()
  /// @throws WrongInput, std::runtime_error if it cannot be written
  void write(const std::string& file, const std::function<void(std::ostream&)>& write_to);

  /// The file written last, with the folder as it was given.
  [[nodiscard]] std::string last() const { return last_.string(); }

 private:
  std::string option_;
  std::string input_;
  std::filesystem::path place_;
  std::filesystem::path last_;
  bool made_ = false;
};

}  // namespace kusabi::run
