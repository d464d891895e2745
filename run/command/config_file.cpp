// Configuration file: its place, its permitted keys, and the values used.
#include "run/command/config_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include <boost/serialization/vector.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/files/structure_file.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "support/input_error.hpp"
#include "support/nearest.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;
using problems::TomlReader;

constexpr std::size_t largest_config = 1 << 20;

// Default place, used without --config and KUSABI_CONFIG; empty: none.
fs::path usual_place() {
  if (const char* const home = std::getenv("XDG_CONFIG_HOME");
      home != nullptr && fs::path(home).is_absolute())
    return fs::path(home) / "kusabi/config.toml";
  const char* const home = std::getenv("HOME");
  return home == nullptr || *home == '\0' ? fs::path{}
                                          : fs::path(home) / ".config/kusabi/config.toml";
}

// The file to read; empty: none.
std::string config_place(const ConfigChoice& choice) {
  if (choice.none) return {};
  if (!choice.file.empty()) return choice.file;
  if (const char* const named = std::getenv("KUSABI_CONFIG")) return named;
  std::error_code unseen;
  const auto place = usual_place();
  return !place.empty() && fs::exists(place, unseen) ? place.string() : std::string{};
}

// Name and text of the file; nothing if there is none.
std::vector<std::string> config_text(const ConfigChoice& choice) {
  const auto place = config_place(choice);
  if (place.empty()) return {};
  return {place, problems::file_text(place, "defaults in TOML", largest_config)};
}

support::SourcePosition position_of(const toml::key& key) {
  const auto& begin = key.source().begin;
  return {static_cast<int>(begin.line), static_cast<int>(begin.column)};
}

[[noreturn]] void unknown(const TomlReader& reader, const toml::key& key, std::string_view what,
                          const std::vector<std::string_view>& names) {
  auto message = fmt::format("unknown {} {}; expected one of {}", what,
                             support::in_quotes(key.str()), fmt::join(names, ", "));
  message += support::did_you_mean(key.str(), names);
  reader.fail(position_of(key), message);
}

// Reason why an option cannot have a default; empty: it can.
std::string_view no_default(const OptionRow& row) {
  if (row.name == "--serial" || row.name == "--config" || row.name == "--no-config")
    return "applies before this file is read; expected in the call only";
  if (row.role != Role::plain) return "names a file of one run; expected in the call only";
  return {};
}

// The key must be an option of the subcommand that may have a default.
void check_key(const TomlReader& reader, const toml::key& key, const OptionTable& table) {
  const auto* const row = table.find("--" + std::string(key.str()));
  if (row == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& each : table.rows()) {
      if (each.named() && no_default(each).empty())
        names.push_back(std::string_view(each.name).substr(2));
    }
    unknown(reader, key, "option", names);
  }
  if (const auto why = no_default(*row); !why.empty())
    reader.fail(position_of(key), fmt::format("{} {}", key.str(), why));
}

// The value in the syntax of a call; nothing for a switch that is off.
std::optional<std::string> value_of(const TomlReader& reader, const toml::key& key,
                                    const toml::node& node, const OptionRow& row) {
  const auto wrong = [&](std::string_view expected) {
    reader.fail(node, fmt::format("{}: expected {}", key.str(), expected));
  };
  if (row.value.empty()) {
    if (!node.is_boolean()) wrong("true or false");
    return node.as_boolean()->get() ? std::optional<std::string>("") : std::nullopt;
  }
  if (const auto* const text = node.as_string()) return text->get();
  if (const auto* const whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* const number = node.as_floating_point()) return fmt::format("{}", number->get());
  wrong(row.expected);
  return std::nullopt;
}

// A value of the file for an option that is not in the call.
struct Wanted {
  OptionRow* row;
  std::string text;
  const toml::node* node;
  std::string_view key;
};

class ConfigReader {
 public:
  ConfigReader(const std::string& text, const std::string& file, const CommandList& list,
               CommandList::Entry& entry)
      : reader_(text, file), list_(list), entry_(entry) {}

  std::vector<std::pair<std::string, std::string>> take() {
    for (const auto& [key, node] : *reader_.root().table) {
      const auto name = std::string(key.str());
      if (list_.group(name) != nullptr) {
        for (const auto& [word, inner] : table_of(node, name)) look(word, inner, name);
      } else {
        look(key, node, {});
      }
    }
    std::vector<std::pair<std::string, std::string>> taken;
    for (const auto& wanted : wanted_) {
      if (!makes_sense(*wanted.row)) continue;
      if (const auto wrong = wanted.row->store(wanted.text); !wrong.empty())
        reader_.fail(*wanted.node, fmt::format("{}: {}", wanted.key, wrong));
      wanted.row->given = wanted.text;
      taken.emplace_back(wanted.row->name, wanted.text);
    }
    return taken;
  }

 private:
  [[nodiscard]] const toml::table& table_of(const toml::node& node, std::string_view name) const {
    const auto* const table = node.as_table();
    if (table == nullptr) reader_.fail(node, fmt::format("{}: expected a table, [{}]", name, name));
    return *table;
  }

  // The table of a subcommand: all keys are checked; those of the current subcommand are used.
  void look(const toml::key& key, const toml::node& node, const std::string& group) {
    const auto name =
        group.empty() ? std::string(key.str()) : fmt::format("{} {}", group, key.str());
    const auto* const entry = list_.find(name);
    if (entry == nullptr) {
      unknown(reader_, key, group.empty() ? "table" : fmt::format("table of {}", group),
              list_.words_after(group));
    }
    for (const auto& [option, value] : table_of(node, name)) {
      check_key(reader_, option, entry->table);
      if (entry != &entry_) continue;
      auto& row = *std::ranges::find(entry_.table.rows(), "--" + std::string(option.str()),
                                     &OptionRow::name);
      auto text = value_of(reader_, option, value, row);
      if (text && !row.given) wanted_.push_back({&row, *std::move(text), &value, option.str()});
    }
  }

  // False if the option requires another one that is absent or has another value.
  [[nodiscard]] bool makes_sense(const OptionRow& row) const {
    return row.needs.empty() || row.is_met_by(entry_.table.find(row.needs)->given) ||
           std::ranges::any_of(wanted_, [&](const auto& other) {
             return other.row->name == row.needs && row.is_met_by(other.text);
           });
  }

  TomlReader reader_;
  const CommandList& list_;
  CommandList::Entry& entry_;
  std::vector<Wanted> wanted_;
};

}  // namespace

Defaults take_defaults(Session& session, const CommandList& list, CommandList::Entry& entry) {
  const auto read = session.from_first_rank([&] { return config_text(entry.config); });
  if (read.empty()) return {};
  const auto& file = read.front();
  auto taken = ConfigReader(read.back(), file, list, entry).take();
  if (taken.empty()) return {};
  return {file, std::move(taken)};
}

}  // namespace kusabi::run
