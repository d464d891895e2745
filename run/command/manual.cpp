// Sections in the order of man-pages(7).
#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/command/help.hpp"
#include "run/output/terminal_page.hpp"
#include "run/session/progress_text.hpp"

namespace kusabi::run {
namespace {

constexpr std::string_view status_and_environment = R"(.SH EXIT STATUS
.TP
0
The analysis is complete; "none" is an answer.
.TP
1
The run failed, or a certificate was refused.
.TP
2
The call or the input is invalid.
.TP
3
The run stopped early or is partly undecided; all stated results hold.
.SH ENVIRONMENT
.TP
.B KUSABI_CONFIG
File with defaults of options. An empty value means no file.
.TP
.B XDG_CONFIG_HOME
Folder that contains
.IR kusabi/config.toml ,
the file with defaults if KUSABI_CONFIG is not set. Default:
.IR ~/.config .
.TP
.BR COLUMNS ", " NO_COLOR ", " TERM
Layout and colours of output on a terminal.
)";

constexpr std::string_view signals_and_files = R"(.SH SIGNALS
.TP
.BR SIGTERM ", " SIGINT ", " SIGHUP ", " SIGXCPU ", " SIGUSR2
The run ends as at its time limit: bounds and partial results are printed and
written, the state of
.B \-\-resume
is saved, and the exit status is 3.
.TP
.B SIGUSR1
The state of
.B \-\-resume
is saved, and the run continues.
.SH FILES
.TP
.I *.toml
Problem files: nodes, members, elements or a mesh, supports, contact candidates
and loads.
.TP
.IR STATE ", " STATE.search* ", " STATE.status
Files of
.BR "\-\-resume STATE" :
finished searches, the current search, and one line with the status of the last
run.
.TP
.I ~/.config/kusabi/config.toml
Defaults of options: a table for each subcommand, whose keys are the options
without their dashes. Options on the command line override the file.
.TP
.I /usr/share/doc/kusabi/
Documentation and examples, if they are installed.
)";

// Text of a manual page: hyphens are ASCII hyphens, and no line begins with a macro.
std::string verbatim(std::string_view text) {
  std::string escaped;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) escaped += "\\&";
    escaped += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    line_begins = c == '\n';
  }
  return escaped;
}

// Such a text in lines of at most 80 characters, unless it has more than eight hyphens a line.
std::string roff(std::string_view text) {
  constexpr std::size_t longest_line = 72;
  return verbatim(folded(text, longest_line));
}

std::string paragraph(const OptionRow& row) {
  auto names = shown_names(row);
  for (auto& name : names) name = fmt::format("\\fB{}\\fR", roff(name));
  auto text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (row.named() && !row.value.empty()) text += fmt::format(" \\fI{}\\fR", roff(value_name(row)));
  text += fmt::format("\n{}.\n", roff(row.help));
  if (const auto rules = option_rules(row); !rules.empty()) text += roff(rules) + '\n';
  if (row.required) text += "Required.\n";
  return text;
}

std::string title(std::string name) {
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return fmt::format(".TH {} 1 {} \"kusabi {}\" \"Kusabi\"\n", roff(name), release_date(),
                     KUSABI_VERSION);
}

std::string page_name(std::string_view command) {
  auto name = fmt::format("kusabi-{}", command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string synopsis(const CommandList::Entry& entry) {
  return fmt::format(".B kusabi {}\n{}\n", roff(entry.name()), roff(usage(entry.table).substr(1)));
}

// A call in one line, to be copied.
std::string example(const CommandList::Entry& entry) {
  return fmt::format(".nf\n.B kusabi {} {}\n.fi\n", verbatim(entry.name()),
                     verbatim(entry.text.example));
}

std::string options(const CommandList::Entry& entry) {
  std::string text;
  for (const auto& row : entry.table.rows()) {
    text += paragraph(row);
  }
  return text;
}

std::string described(const CommandList::Entry& entry) {
  const auto text = entry.text.description;
  return text.empty() ? fmt::format("{}.", entry.text.purpose) : std::string(text);
}

}  // namespace

std::string manual(const CommandList& list) {
  auto text = title("kusabi");
  text +=
      ".SH NAME\nkusabi \\- wedged configurations and worst\\-case limit loads, by tree search\n"
      ".SH SYNOPSIS\n";
  const auto out = std::back_inserter(text);
  for (const auto& entry : list.entries()) text += synopsis(entry) + ".br\n";
  text += R"(mpirun \-np \fIranks\fR kusabi ...
.br
.B kusabi help
[\fIsubcommand\fR]
.SH DESCRIPTION
All wedged configurations of a structure with Coulomb friction,
worst\-case limit loads of trusses, and mixed zero\-one linear programs.
Each search runs in one process, or on all ranks of an MPI job.
.SH OPTIONS
)";
  for (const auto& row : list.own().rows()) text += paragraph(row);
  text +=
      ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint all subcommands; after a subcommand, its "
      "options.\n";
  text += ".SH SUBCOMMANDS\nEach has a page of its own.\n";
  std::string examples, pages;
  for (const auto& chapter : list.chapters()) {
    fmt::format_to(out, ".SS {}\n", roff(chapter.title));
    for (const auto name : chapter.names) {
      const auto& entry = *list.find(name);
      const auto purpose = roff(entry.text.purpose);
      fmt::format_to(out, ".TP\n.BR {} (1)\n{}\n", roff(page_name(entry.name())), purpose);
      examples += fmt::format(".TP\n{}:\n{}", purpose, example(entry));
      pages +=
          fmt::format("{}.BR {} (1)", pages.empty() ? "" : ",\n", roff(page_name(entry.name())));
    }
  }
  return fmt::format("{}{}.SH EXAMPLES\n{}{}.SH SEE ALSO\n{},\n.BR mpirun (1)\n", text,
                     status_and_environment, examples, signals_and_files, pages);
}

std::string manual(const CommandList& list, const CommandList::Entry& entry) {
  const auto name = page_name(entry.name());
  auto text = title(name);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}", roff(name), roff(entry.text.purpose),
                 synopsis(entry));
  fmt::format_to(out, ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}{}", roff(described(entry)),
                 options(entry), status_and_environment);
  fmt::format_to(out, ".SH EXAMPLES\n{}", example(entry));
  if (const auto progress = entry.text.progress; progress != ProgressLines::none) {
    fmt::format_to(out, ".SH PROGRESS\n.nf\n{}\n.fi\n",
                   verbatim(progress_explained(progress == ProgressLines::bounds)));
  }
  text += signals_and_files;
  text += ".SH SEE ALSO\n.BR kusabi (1)";
  for (const auto& chapter : list.chapters()) {
    if (std::ranges::find(chapter.names, entry.name()) == chapter.names.end()) continue;
    for (const auto other : chapter.names) {
      if (other == entry.name()) continue;
      fmt::format_to(out, ",\n.BR {} (1)", roff(page_name(other)));
    }
  }
  return text + '\n';
}

std::string manual(const CommandList& list, const CommandList::Group& group) {
  const auto name = page_name(group.name);
  auto text = title(name);
  fmt::format_to(std::back_inserter(text), ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", roff(name),
                 roff(group.purpose));
  std::string described, pages;
  for (const auto& entry : list.entries()) {
    if (group_of(entry.name()) != group.name) continue;
    text += (described.empty() ? "" : ".br\n") + synopsis(entry);
    const auto page = roff(page_name(entry.name()));
    described += fmt::format(".TP\n.BR {} (1)\n{}\n", page, roff(entry.text.purpose));
    pages += fmt::format(",\n.BR {} (1)", page);
  }
  return fmt::format("{}.SH DESCRIPTION\n{}.SH SEE ALSO\n.BR kusabi (1){}\n", text, described,
                     pages);
}

}  // namespace kusabi::run
