// Names of outputs from the rows of the call.
#include "run/command/output_set.hpp"

#include <utility>

#include "run/output/output_file.hpp"

namespace kusabi::run {
namespace {

// Destination of an output; empty: none.
std::string place_of(const OptionRow& row) {
  if (row.role == Role::output && row.given == standard_output) return standard_output_file;
  return row.given.value_or(std::string{});
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
