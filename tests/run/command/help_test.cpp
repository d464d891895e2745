// Help, manual pages and completion, generated from the option tables; messages for wrong calls.
#include "run/command/help.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/command/command_line.hpp"
#include "run/command/command_list.hpp"

namespace {

using namespace kusabi::run;
using testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

void expect_readable(const std::string& text) {
  for (const auto& line : lines_of(text)) EXPECT_LE(line.size(), 80U) << line;
  std::size_t digits = 0;
  for (const char c : text) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    EXPECT_LE(digits, 12U) << text;
  }
  for (const auto* const number : {"e+308", "e+30", "inf", "nan"})
    EXPECT_EQ(text.find(std::string(" ") + number), std::string::npos) << text;
}

TEST(Help, FitsIntoEightyColumns) {
  const auto list = command_list();
  expect_readable(overview(list));
  for (const auto& group : list.groups()) expect_readable(help(list, group));
  for (const auto& entry : list.entries()) expect_readable(help(entry));
}

// The name of an option, or the placeholder of a positional argument.
std::string in_help(const OptionRow& row) {
  auto name = row.name;
  if (!row.named())
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

TEST(Help, HasAllOptionsAndTheirChoices) {
  const auto list = command_list();
  for (const auto& entry : list.entries()) {
    auto text = help(entry);
    EXPECT_THAT(text, HasSubstr("Example: kusabi " + std::string(entry.name()) + " "));
    for (const auto& row : entry.table.rows()) {
      const auto letter = row.letter.empty() ? row.letter : row.letter + ", ";
      EXPECT_THAT(text, HasSubstr("\n  " + letter + in_help(row)));
    }
    // Choices may take several lines.
    std::ranges::replace(text, '\n', ' ');
    const auto both_spaces = [](char a, char b) { return a == ' ' && b == ' '; };
    text.erase(std::unique(text.begin(), text.end(), both_spaces), text.end());
    for (const auto& row : entry.table.rows()) {
      if (row.words.empty()) continue;
      EXPECT_THAT(text, HasSubstr("O" + row.expected.substr(1) + "."));
    }
  }
}

TEST(Help, ListsEachSubcommandOnceInOneLine) {
  const auto list = command_list();
  const auto lines = lines_of(overview(list));
  for (const auto& entry : list.entries()) {
    const auto begin = "  " + std::string(entry.name()) + "  ";
    const auto is_its = [&](const auto& line) { return line.starts_with(begin); };
    ASSERT_EQ(std::ranges::count_if(lines, is_its), 1) << entry.name();
    EXPECT_TRUE(std::ranges::find_if(lines, is_its)->ends_with(entry.text.purpose));
    EXPECT_FALSE(entry.text.example.empty());
  }
}

TEST(Help, ExamplesAreValidCalls) {
  const auto names = command_list();
  for (const auto& entry : names.entries()) {
    std::istringstream words("kusabi " + std::string(entry.name()) + " " +
                             std::string(entry.text.example));
    std::vector<std::string> call;
    for (std::string word; words >> word;) call.push_back(word);
    std::vector<const char*> argv;
    for (const auto& word : call) argv.push_back(word.c_str());
    auto list = command_list();
    const auto asked = parse(list, static_cast<int>(argv.size()), argv.data());
    ASSERT_NE(asked.entry, nullptr) << entry.name();
    EXPECT_EQ(asked.entry->name(), entry.name());
    EXPECT_NO_THROW(require_options(*asked.entry)) << entry.name();
  }
}

std::string roff(std::string name) {
  std::string text;
  for (const char c : name) text += c == '-' ? std::string("\\-") : std::string(1, c);
  return text;
}

TEST(Manual, HasAllOptionsOfAllSubcommands) {
  const auto list = command_list();
  const auto whole = manual(list);
  for (const auto& entry : list.entries()) {
    const auto page = manual(list, entry);
    EXPECT_THAT(whole, HasSubstr(roff(std::string(entry.text.purpose))));
    EXPECT_TRUE(page.starts_with(".TH KUSABI\\-")) << page;
    const auto example = "\n.nf\n.B kusabi " + roff(std::string(entry.name())) + ' ' +
                         roff(std::string(entry.text.example)) + "\n.fi\n";
    EXPECT_THAT(page, HasSubstr(example));  // not filled
    EXPECT_THAT(whole, HasSubstr(example));
    for (const auto& row : entry.table.rows()) {
      EXPECT_THAT(page, HasSubstr("\\fB" + roff(in_help(row)) + "\\fR"));
    }
  }
  for (const auto* const section : {"EXIT STATUS", "EXAMPLES", "SIGNALS", "FILES", "SEE ALSO"})
    EXPECT_THAT(whole, HasSubstr(std::string(".SH ") + section + "\n"));
}

TEST(Completion, HasAllOptionsForEachShell) {
  const auto list = command_list();
  for (const auto* const shell : {"bash", "zsh", "fish"}) {
    const auto script = completion(list, shell);
    for (const auto& entry : list.entries()) {
      EXPECT_THAT(script, HasSubstr(std::string(entry.name())));
      for (const auto& row : entry.table.rows()) {
        if (!row.named()) continue;
        const auto found = std::string(shell) == "fish" ? "-l " + row.name.substr(2) : row.name;
        EXPECT_THAT(script, HasSubstr(found)) << shell;
        for (const auto& word : row.words) EXPECT_THAT(script, HasSubstr(word)) << shell;
      }
    }
  }
}

}  // namespace
