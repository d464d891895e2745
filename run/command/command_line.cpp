// CLI11 splits the call into words and prints help; what words mean is in the tables.
#include "run/command/command_line.hpp"

#include <iterator>
#include <map>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kusabi::run {
namespace {

constexpr std::string_view purpose =
    "All wedged configurations of a structure with Coulomb friction, worst-case limit loads of "
    "trusses, and the 0-1 programs that they are.";

// What an option takes, in help: "NUMBER > 0 s".
std::string taken(const OptionRow& row) {
  std::string text = row.value;
  for (const auto* const more : {&row.range, &row.unit}) {
    if (!more->empty()) text += ' ' + *more;
  }
  return text;
}

CLI::Option* added(CLI::App& command, OptionRow& row) {
  if (row.value.empty()) {
    return command
        .add_flag_callback(
            row.name, [&row] { row.take(*(row.given = "")); }, row.help)
        ->disable_flag_override();
  }
  auto* const option = command.add_option_function<std::string>(
      row.name, [&row](const std::string& text) { row.given = text; }, row.help);
  option->check([&row](const std::string& text) { return row.take(text); }, "");
  option->type_name(taken(row))->required(row.required);
  if (!row.usual.empty()) option->default_str(row.usual);
  return option;
}

void add_options(CLI::App& command, OptionTable& table) {
  std::map<std::string, CLI::Option*> options;
  for (auto& row : table.rows()) options[row.name] = added(command, row);
  for (const auto& row : table.rows()) {
    if (!row.needs.empty()) options.at(row.name)->needs(options.at(row.needs));
  }
}

// Text of a manual page: a hyphen is one that can be copied, and no line begins with a command.
std::string roff(std::string_view text) {
  std::string escaped;
  if (text.starts_with('.') || text.starts_with('\'')) escaped = "\\&";
  for (const char c : text) {
    escaped += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  }
  return escaped;
}

std::string manual_entry(const OptionRow& row) {
  std::string text = fmt::format(".TP\n\\fB{}\\fR", roff(row.name));
  if (row.named() && !row.value.empty()) text += fmt::format(" \\fI{}\\fR", roff(row.value));
  text += fmt::format("\n{}.", roff(row.help));
  if (!row.range.empty()) text += fmt::format("\nRange: {}.", roff(row.range));
  if (!row.unit.empty()) text += fmt::format("\nUnit: {}.", roff(row.unit));
  if (!row.usual.empty()) text += fmt::format("\nUnless given: {}.", roff(row.usual));
  if (row.required) text += "\nRequired.";
  if (!row.needs.empty()) text += fmt::format("\nNeeds {}.", roff(row.needs));
  return text + '\n';
}

}  // namespace

CommandLine::CommandLine(std::vector<std::unique_ptr<Subcommand>> subcommands,
                         std::vector<Group> groups)
    : groups_(std::move(groups)) {
  for (auto& subcommand : subcommands) {
    auto& entry = entries_.emplace_back();
    entry.subcommand = std::move(subcommand);
    entry.subcommand->describe(entry.table);
  }
}

std::string CommandLine::names() const {
  std::vector<std::string_view> names;
  for (const auto& entry : entries_) names.push_back(entry.subcommand->name());
  return fmt::format("{}", fmt::join(names, ", "));
}

CommandLine::Asked CommandLine::parse(int argc, const char* const* argv) {
  CLI::App app{std::string(purpose), "kusabi"};
  app.set_version_flag("--version", "kusabi " KUSABI_VERSION);
  bool manual_wanted = false;
  app.add_flag("--manual", manual_wanted, "print the manual page, for man -l -");
  app.require_subcommand(0, 1);
  std::map<std::string_view, CLI::App*> groups;
  for (const auto& [name, its_purpose] : groups_) {
    auto& group = *app.add_subcommand(std::string(name), std::string(its_purpose));
    group.require_subcommand(1);
    groups[name] = &group;
  }
  Asked asked;
  for (auto& entry : entries_) {
    const auto name = entry.subcommand->name();
    const auto space = name.find(' ');
    const bool grouped = space != std::string_view::npos;
    auto& above = grouped ? *groups.at(name.substr(0, space)) : app;
    auto& command = *above.add_subcommand(std::string(grouped ? name.substr(space + 1) : name),
                                          std::string(entry.subcommand->purpose()));
    add_options(command, entry.table);
    command.footer(entry.subcommand->notes());
    command.callback([&asked, &entry] { asked.entry = &entry; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {nullptr, app.help()};
  } catch (const CLI::CallForAllHelp&) {
    return {nullptr, app.help("", CLI::AppFormatMode::All)};
  } catch (const CLI::CallForVersion& version) {
    return {nullptr, fmt::format("{}\n", version.what())};
  } catch (const CLI::ExtrasError& error) {
    if (!app.get_subcommands().empty())
      throw WrongCall(fmt::format("{} (try --help)", error.what()));
    throw WrongCall(fmt::format("no such subcommand; expected one of {}", names()));
  } catch (const CLI::ParseError& error) {
    throw WrongCall(fmt::format("{} (try --help)", error.what()));
  }
  if (manual_wanted) return {nullptr, manual()};
  if (asked.entry == nullptr) {
    throw WrongCall(fmt::format("a subcommand is missing; expected one of {}", names()));
  }
  return asked;
}

std::string CommandLine::manual() const {
  std::string text = fmt::format(
      R"(.TH KUSABI 1 "" "kusabi {}"
.SH NAME
kusabi \- wedged configurations and worst\-case limit loads, by parallel tree search
.SH SYNOPSIS
)",
      KUSABI_VERSION);
  auto out = std::back_inserter(text);
  for (const auto& [subcommand, table] : entries_) {
    fmt::format_to(out, ".B kusabi {}\n[options]", roff(subcommand->name()));
    for (const auto& row : table.rows()) {
      if (!row.named()) fmt::format_to(out, " \\fI{}\\fR", roff(row.name));
    }
    text += "\n.br\n";
  }
  fmt::format_to(out,
                 R"(mpirun \-np \fIranks\fR kusabi ...
.SH DESCRIPTION
{}
Each of the searches runs in one process, or on all ranks of an MPI job.
.SH SUBCOMMANDS
)",
                 roff(purpose));
  for (const auto& [subcommand, table] : entries_) {
    fmt::format_to(out, ".SS kusabi {}\n{}.\n", roff(subcommand->name()),
                   roff(subcommand->purpose()));
    for (const auto& row : table.rows()) text += manual_entry(row);
    if (const auto notes = subcommand->notes(); !notes.empty())
      text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(notes));
  }
  text += R"(.SH EXIT STATUS
.TP
0
The whole question is answered; "none" is an answer.
.TP
1
The run failed.
.TP
2
The input or the call is wrong.
.TP
3
Stopped early, or something is left open; what is said holds.
)";
  return text;
}

}  // namespace kusabi::run
