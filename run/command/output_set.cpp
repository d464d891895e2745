// Names of outputs from the rows of the call.
#include "run/command/output_set.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "run/output/output_file.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

// Destination of an output; empty: none.
std::string place_of(const OptionRow& row) {
  if (row.role == Role::output && row.given == standard_output) return standard_output_file;
  return row.given.value_or(std::string{});
}

// Refuses an output that a file of an output folder may replace.
void check_folders(const OptionTable& table, const std::vector<NamedFile>& outputs) {
  namespace fs = std::filesystem;
  for (const auto& row : table.rows()) {
    if (row.role != Role::folder || !row.given || row.given->empty()) continue;
    const auto* const ending = row.name == "--vtu" ? ".vtu" : ".cert";
    for (const auto& file : outputs) {
      const fs::path path(file.name);
      std::error_code fault;
      if (file.option == row.name || path.extension() != ending ||
          !fs::equivalent(path.has_parent_path() ? path.parent_path() : ".", *row.given, fault))
        continue;
      throw WrongInput(
          fmt::format("{} {}: is in the folder of {}, whose files end in {}; expected "
                      "another name",
                      file.option, file.name, row.name, ending));
    }
  }
}

}  // namespace

std::vector<NamedFile> OutputSet::names() const {
  std::vector<NamedFile> outputs;
  for (const auto& row : table_.rows()) {
    if (!row.given || row.given->empty()) continue;
    if (row.role != Role::output && row.role != Role::evidence && row.role != Role::folder)
      continue;
    for (const auto& ending : row.endings) outputs.push_back({row.name, place_of(row) + ending});
  }
  return outputs;
}

void OutputSet::check(const std::string& input) const {
  std::vector<NamedFile> others;
  std::vector<NamedFile> read_too;
  for (const auto& row : table_.rows()) {
    if (!row.given || row.given->empty()) continue;
    if (row.role == Role::input && row.named()) {
      read_too.push_back({row.name, *row.given});
    } else if (row.role == Role::state) {
      others.push_back({row.name, *row.given});
    }
  }
  others.insert(others.end(), read_too.begin(), read_too.end());
  check_outputs(input, names(), others);
  check_folders(table_, names());
}

void OutputSet::keep(Session& session, const std::vector<std::string>& read) const {
  session.from_first_rank([&] { check_read_files(read, names()); });
}

void OutputSet::open(Session& session, const std::string& input) {
  session.from_first_rank([&] {
    for (const auto& row : table_.rows()) {
      if (row.role == Role::folder)
        folders_.try_emplace(row.name, row.name, row.given.value_or(std::string{}), input);
    }
    check(input);
    for (const auto& row : table_.rows()) {
      if (row.role == Role::output) files_.try_emplace(row.name, row.name, place_of(row), input);
    }
  });
}

bool OutputSet::wants(const std::string& option) const {
  const auto file = files_.find(option);
  const auto folder = folders_.find(option);
  return (file != files_.end() && file->second.wanted()) ||
         (folder != folders_.end() && folder->second.wanted());
}

std::ostream& OutputSet::stream(const std::string& option) {
  return files_.at(option).stream();
}

void OutputSet::put_in_place(const std::string& option) {
  files_.at(option).put_in_place();
  written_.push_back(*table_.find(option)->given);
}

Step OutputSet::file(const std::string& option, std::function<void(std::ostream&)> write) {
  return [this, option, write = std::move(write)] {
    if (!wants(option)) return;
    if (write) write(stream(option));
    put_in_place(option);
  };
}

Step OutputSet::folder(const std::string& option, std::function<void(OutputFolder&)> fill) {
  return [this, option, fill = std::move(fill)] {
    auto& folder = folders_.at(option);
    if (!folder.wanted()) return;
    fill(folder);
    if (auto name = folder.last(); !name.empty()) written_.push_back(std::move(name));
  };
}

}  // namespace kusabi::run
