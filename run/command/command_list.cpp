// The tables are filled once, in the constructor.
#include "run/command/command_list.hpp"

#include <algorithm>
#include <utility>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::string_view group_of(std::string_view name) {
  const auto space = name.find(' ');
  return space == std::string_view::npos ? std::string_view{} : name.substr(0, space);
}

std::string_view last_word(std::string_view name) {
  return name.substr(name.rfind(' ') + 1);  // npos + 1 is 0
}

CommandList::CommandList(const std::vector<Registration>& subcommands, std::vector<Group> groups)
    : groups_(std::move(groups)) {
  own_.flag("--version", switched_, "print version, commit, compiler and libraries");
  own_.flag("--manual", switched_,
            "print the manual page of a subcommand or, without one, of kusabi, for man -l -");
  own_.choice<std::string>("--completion", shell_,
                           {{"bash", "bash"}, {"zsh", "zsh"}, {"fish", "fish"}},
                           "print a completion script for this shell");
  for (const auto& [text, make] : subcommands) {
    auto& entry = entries_.emplace_back();
    entry.text = text;
    entry.subcommand = make();
    entry.subcommand->describe(entry.table);
    entry.table.config(entry.config);
    const auto chapter = std::ranges::find(chapters_, text.chapter, &Chapter::title);
    if (chapter == chapters_.end()) {
      chapters_.push_back({text.chapter, {text.name}});
    } else {
      chapter->names.push_back(text.name);
    }
  }
}

const CommandList::Entry* CommandList::find(std::string_view name) const {
  const auto found = std::ranges::find(entries_, name, &Entry::name);
  return found == entries_.end() ? nullptr : &*found;
}

const CommandList::Group* CommandList::group(std::string_view name) const {
  const auto found = std::ranges::find(groups_, name, &Group::name);
  return found == groups_.end() ? nullptr : &*found;
}

std::vector<std::string_view> CommandList::words_after(std::string_view group) const {
  std::vector<std::string_view> words;
  for (const auto& entry : entries_) {
    const auto its_group = group_of(entry.name());
    const auto word = its_group == group ? last_word(entry.name()) : its_group;
    if (its_group != group && !group.empty()) continue;
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  return words;
}

CommandList command_list() {
  return {{patterns_subcommand,
           rays_subcommand,
           critical_subcommand,
           hold_subcommand,
           limit_subcommand,
           sweep_subcommand,
           mip_subcommand,
           verify_subcommand,
           show_subcommand,
           draw_subcommand,
           report_subcommand,
           example_space_truss_subcommand,
           example_plane_truss_subcommand,
           example_grid_subcommand,
           example_dome_subcommand,
           example_tower_subcommand,
           import_subcommand,
           export_mps_subcommand,
           export_cbf_subcommand,
           export_matrix_subcommand,
           bench_scaling_subcommand,
           bench_schedules_subcommand,
           bench_uts_subcommand},
          {{"example", "problem files of parametric families"},
           {"export", "programs and matrices as files for other solvers"},
           {"bench", "measurements and tests of the search engine"}}};
}

}  // namespace kusabi::run
