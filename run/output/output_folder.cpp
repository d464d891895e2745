// The folder; its files are OutputFiles.
#include "run/output/output_folder.hpp"

#include <utility>

#include <fmt/format.h>

#include "run/output/output_file.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(std::string option, const std::string& name, std::string input)
    : option_(std::move(option)), input_(std::move(input)), place_(name) {
  if (name.empty()) return;
  std::error_code error;
  if (fs::is_directory(place_, error)) return;
  if (fs::exists(place_, error)) {
    throw WrongInput(
        fmt::format("{} {}: is not a folder; expected a folder or a new name", option_, name));
  }
  made_ = fs::create_directory(place_, error);
  if (error) {
    throw WrongInput(fmt::format("{} {}: cannot be created: {}", option_, name, error.message()));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code not_empty;
  if (made_) fs::remove(place_, not_empty);
}

void OutputFolder::write(const std::string& file,
                         const std::function<void(std::ostream&)>& write_to) {
  last_ = place_ / file;
  OutputFile output(option_, last_.string(), input_);
  write_to(output.stream());
  output.put_in_place();
}

}  // namespace kusabi::run
