// OutputFolder: a folder of output files, created before the search, so that an invalid name is
// reported at once. Each file in it appears complete or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace kusabi::run {

class OutputFolder {
 public:
  /// Creates the folder unless it exists; its parent must exist. An empty name: no folder.
  /// @param option option that names the folder, for messages
  /// @param input the problem file, which must not be a file of the folder
  /// @throws WrongInput if it exists and is not a folder, or cannot be created
  OutputFolder(std::string option, const std::string& name, std::string input);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();  ///< removes a folder created here that is empty

  [[nodiscard]] bool wanted() const { return !place_.empty(); }

  /// Writes one file. @pre wanted() @throws WrongInput, std::runtime_error if it cannot be written
  void write(const std::string& file, const std::function<void(std::ostream&)>& write_to);

  /// Path of the last file written, relative to the folder as it was given.
  [[nodiscard]] std::string last() const { return last_.string(); }

 private:
  std::string option_;
  std::string input_;
  std::filesystem::path place_;
  std::filesystem::path last_;
  bool made_ = false;
};

}  // namespace kusabi::run
