// Names and the files that they lead to are compared; then each is opened.
#include "run/output/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <sys/stat.h>

#include "run/output/output_file.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;

std::optional<struct stat> status_of(const std::string& name) {
  struct stat status {};
  if (stat(name.c_str(), &status) != 0) return std::nullopt;
  return status;
}

bool is_null_device(const struct stat& status) {
  const auto null = status_of("/dev/null");
  return S_ISCHR(status.st_mode) && null && S_ISCHR(null->st_mode) &&
         status.st_rdev == null->st_rdev;
}

bool same(const std::string& one, const std::string& other) {
  const auto first = status_of(one);
  const auto second = status_of(other);
  if (first && second) {
    if (is_null_device(*first)) return false;
    if (S_ISCHR(first->st_mode) && S_ISCHR(second->st_mode) && first->st_rdev == second->st_rdev)
      return true;  // two names of one device
    return first->st_dev == second->st_dev && first->st_ino == second->st_ino;
  }
  if (first || second) return false;
  // Neither exists yet: they are the same if they lead to one name in one folder.
  std::error_code error;
  const auto place = fs::weakly_canonical(fs::absolute(one), error);
  if (error) return false;
  const auto other_place = fs::weakly_canonical(fs::absolute(other), error);
  return !error && place == other_place;
}

}  // namespace

void check_outputs(const std::string& input, const std::vector<NamedFile>& outputs,
                   const std::vector<NamedFile>& others) {
  std::vector<NamedFile> all;
  for (const auto* files : {&outputs, &others}) {
    for (const auto& file : *files) {
      if (!file.name.empty()) all.push_back(file);
    }
  }
  for (auto file = all.begin(); file != all.end(); ++file) {
    if (!input.empty() && same(file->name, input)) {
      throw WrongInput(fmt::format("{} {}: would overwrite the problem file; expected another name",
                                   file->option, file->name));
    }
    for (auto before = all.begin(); before != file; ++before) {
      if (!same(before->name, file->name)) continue;
      throw WrongInput(fmt::format("{} {}: is also the file of {}; expected another name",
                                   file->option, file->name, before->option));
    }
  }
  // Opened and closed again, except for pipes, whose readers would see the end.
  for (const auto& [option, name] : outputs) {
    if (name == standard_output_file) continue;
    const auto kind = status_of(name);
    if (!kind || S_ISREG(kind->st_mode)) OutputFile(option, name, input);
    if (kind && S_ISDIR(kind->st_mode)) OutputFile(option, name, input);
  }
}

void check_read_files(const std::vector<std::string>& read, const std::vector<NamedFile>& outputs) {
  for (const auto& file : outputs) {
    const auto found = std::ranges::find_if(
        read, [&](const std::string& name) { return !file.name.empty() && same(file.name, name); });
    if (found == read.end()) continue;
    throw WrongInput(fmt::format(
        "{} {}: would overwrite {}, which the problem file names; expected another name",
        file.option, file.name, *found));
  }
}

}  // namespace kusabi::run
