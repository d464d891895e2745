// One script per shell, in its own language, without further dependencies.
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/command/command_line.hpp"
#include "run/command/help.hpp"

namespace kusabi::run {
namespace {

using Entry = CommandList::Entry;

bool is_file_option(const OptionRow& row) {
  return row.value == "FILE" || row.role == Role::input || row.role == Role::output;
}

// Quoting for a script: within single quotes.
std::string within_quotes(std::string_view text) {
  std::string quoted;
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted;
}

std::string option_names(const OptionTable& table) {
  std::string names = "--help";
  for (const auto& row : table.rows()) {
    if (row.named()) names += fmt::format(" {}", fmt::join(row.names(), " "));
  }
  return names;
}

// ---- bash

// Case of an option: "      --mu) return ;;".
std::string bash_values(const OptionTable& table) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const auto& row : table.rows()) {
    if (!row.named() || row.value.empty()) continue;
    const auto reply = !row.words.empty()    ? fmt::format("'{}'", fmt::join(row.words, " "))
                       : row.value == "DIR"  ? std::string("-d")
                       : is_file_option(row) ? std::string("-f")
                                             : std::string("''");
    fmt::format_to(out, "        {}) values={} ;;\n", fmt::join(row.names(), "|"), reply);
  }
  return text;
}

bool takes_files(const OptionTable& table) {
  for (const auto& row : table.rows()) {
    if (!row.named()) return true;
  }
  return false;
}

std::string bash_case(const Entry& entry) {
  return fmt::format(
      "    '{}')\n      words='{}'\n      files={}\n      case $before in\n{}      esac ;;\n",
      entry.name(), option_names(entry.table), takes_files(entry.table) ? "yes" : "no",
      bash_values(entry.table));
}

std::string bash(const CommandList& list) {
  std::string text = R"(# Completion of kusabi for bash, written by kusabi --completion bash.
_kusabi() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local command= words= values=none files=no at
  # bash takes --sort=margin for three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((at = 1; at < COMP_CWORD; ++at)); do
    [[ ${COMP_WORDS[at]} == -* ]] && break
    command+=${command:+ }${COMP_WORDS[at]}
    case $command in )";
  std::string groups = "help";
  for (const auto& group : list.groups()) groups += fmt::format("|{0}|'help {0}'", group.name);
  text += groups + ") ;; *) break ;; esac\n  done\n  case $command in\n";
  const auto out = std::back_inserter(text);
  const auto top = fmt::format("{}", fmt::join(list.words_after({}), " "));
  fmt::format_to(out,
                 "    '') words='{} help {}'\n      case $before in\n{}      esac ;;\n    help) "
                 "words='{}' ;;\n",
                 top, option_names(list.own()), bash_values(list.own()), top);
  for (const auto& group : list.groups()) {
    fmt::format_to(out, "    '{0}'|'help {0}') words='{1}' ;;\n", group.name,
                   fmt::join(list.words_after(group.name), " "));
  }
  for (const auto& entry : list.entries()) text += bash_case(entry);
  return text + R"(  esac
  COMPREPLY=()
  local line
  if [[ $values == none ]]; then
    values=$words
    if [[ $files == yes && $word != -* ]]; then values=-f; fi
  fi
  case $values in
    -d|-f)
      compopt -o filenames 2>/dev/null
      while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$values" -- "$word") ;;
    *)
      while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -W "$values" -- "$word") ;;
  esac
}
complete -F _kusabi kusabi
)";
}

// ---- zsh

// Text in a specification of _arguments, with brackets and colons escaped.
std::string zsh_text(std::string_view text) {
  std::string plain;
  for (const char c : within_quotes(text)) {
    if (c == '[' || c == ']' || c == ':') plain += '\\';
    plain += c;
  }
  return plain;
}

std::string zsh_action(const OptionRow& row) {
  if (!row.words.empty()) return fmt::format("({})", fmt::join(row.words, " "));
  if (row.value == "DIR") return "_files -/";
  return is_file_option(row) ? "_files" : " ";
}

std::string zsh_arguments(const OptionTable& table) {
  std::string text = "_arguments '(- *)'{-h,--help}'[print help]'";
  const auto out = std::back_inserter(text);
  for (const auto& row : table.rows()) {
    if (row.named()) {
      const auto name = row.letter.empty()
                            ? fmt::format("'{}", row.name)
                            : fmt::format("'({0} {1})'{{{0},{1}}}'", row.letter, row.name);
      fmt::format_to(out, " \\\n        {}[{}]", name, zsh_text(row.help));
      if (!row.value.empty())
        fmt::format_to(out, ":{}:{}", zsh_text(value_name(row)), zsh_action(row));
      text += '\'';
    } else {
      fmt::format_to(out, " \\\n        ':{}:{}'", zsh_text(row.help), zsh_action(row));
    }
  }
  return text;
}

std::string zsh(const CommandList& list) {
  std::string text = R"(#compdef kusabi
# Completion of kusabi for zsh, written by kusabi --completion zsh.
_kusabi() {
  local -a names
  local command="${words[2]}"
  if (( CURRENT == 2 )); then
    names=(
)";
  const auto out = std::back_inserter(text);
  const auto described = [&](std::string_view word, std::string_view purpose) {
    fmt::format_to(out, "      '{}:{}'\n", word, zsh_text(purpose));
  };
  for (const auto& entry : list.entries()) {
    if (group_of(entry.name()).empty()) described(entry.name(), entry.text.purpose);
  }
  for (const auto& group : list.groups()) described(group.name, group.purpose);
  described("help", "help on a subcommand");
  fmt::format_to(out, "    )\n    _describe subcommand names\n    {}\n    return\n  fi\n",
                 zsh_arguments(list.own()));
  text += "  shift words; (( CURRENT-- ))\n  case $command in\n";
  for (const auto& group : list.groups()) {
    fmt::format_to(
        out,
        "    {})\n      if (( CURRENT == 2 )); then\n        names=({})\n        _describe "
        "subcommand names\n        return\n      fi\n"
        "      command+=\" ${{words[2]}}\"\n      shift words; (( CURRENT-- )) ;;\n",
        group.name, fmt::join(list.words_after(group.name), " "));
  }
  fmt::format_to(out,
                 "    help)\n      names=({})\n      _describe subcommand names\n      return ;;\n",
                 fmt::join(list.words_after({}), " "));
  text += "  esac\n  case $command in\n";
  for (const auto& entry : list.entries())
    fmt::format_to(out, "    '{}')\n      {} ;;\n", entry.name(), zsh_arguments(entry.table));
  return text +
         "  esac\n}\nif [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n  _kusabi \"$@\"\n"
         "else\n  compdef _kusabi kusabi\nfi\n";
}

// ---- fish

void fish_options(std::string& text, const std::string& when, const OptionTable& table) {
  const auto out = std::back_inserter(text);
  bool files = false;
  for (const auto& row : table.rows()) {
    if (!row.named()) {
      files = true;
      continue;
    }
    fmt::format_to(out, "complete -c kusabi -n '{}' -l {}{} -d '{}'", when, row.name.substr(2),
                   row.letter.empty() ? "" : " -s " + row.letter.substr(1),
                   within_quotes(row.help));
    if (!row.words.empty()) {
      fmt::format_to(out, " -x -a '{}'", fmt::join(row.words, " "));
    } else if (row.value == "DIR") {
      text += " -x -a '(__fish_complete_directories)'";
    } else if (!row.value.empty()) {
      text += is_file_option(row) ? " -r -F" : " -x";
    }
    text += '\n';
  }
  if (files) fmt::format_to(out, "complete -c kusabi -n '{}' -F\n", when);
}

std::string fish(const CommandList& list) {
  std::string text = R"(# Completion of kusabi for fish, written by kusabi --completion fish.
# True if the words after kusabi begin with these; without arguments, if there are none.
function __kusabi_after
    set -l words (commandline -opc)
    set -e words[1]
    if test (count $argv) -eq 0
        not string match -qv -- '-*' $words
        return
    end
    test (count $words) -ge (count $argv); and test "$words[1..(count $argv)]" = "$argv"
end
# True if the words after kusabi are exactly these.
function __kusabi_at
    set -l words (commandline -opc)
    set -e words[1]
    test "$words" = "$argv"
end
complete -c kusabi -f
complete -c kusabi -s h -l help -d 'print help'
)";
  const auto out = std::back_inserter(text);
  const auto offered = [&](std::string_view when, std::string_view word, std::string_view purpose) {
    fmt::format_to(out, "complete -c kusabi -n '{}' -a {} -d '{}'\n", when, word,
                   within_quotes(purpose));
  };
  for (const auto& group : list.groups()) {
    offered("__kusabi_after", group.name, group.purpose);
    offered("__kusabi_at help", group.name, group.purpose);
  }
  offered("__kusabi_after", "help", "help on a subcommand");
  fish_options(text, "__kusabi_after", list.own());
  for (const auto& entry : list.entries()) {
    const auto group = group_of(entry.name());
    const auto purpose = entry.text.purpose;
    const auto word = last_word(entry.name());
    offered(group.empty() ? "__kusabi_after" : fmt::format("__kusabi_at {}", group), word, purpose);
    offered(group.empty() ? "__kusabi_at help" : fmt::format("__kusabi_at help {}", group), word,
            purpose);
    fish_options(text, fmt::format("__kusabi_after {}", entry.name()), entry.table);
  }
  return text;
}

}  // namespace

std::string completion(const CommandList& list, std::string_view shell) {
  if (shell == "bash") return bash(list);
  if (shell == "zsh") return zsh(list);
  if (shell == "fish") return fish(list);
  throw WrongCall(fmt::format("--completion: '{}', expected one of bash, zsh, fish", shell));
}

}  // namespace kusabi::run
