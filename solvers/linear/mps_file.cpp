// MPS reader: the sections are read one by one and combined at the end.
#include "solvers/linear/mps_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "solvers/linear/mps_lines.hpp"
#include "solvers/linear/mps_program.hpp"
#include "solvers/linear/unsupported.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using support::in_quotes;
using support::InputError;

// A name and its value: an entry, a right-hand side.
using Pairs = std::vector<std::pair<std::string_view, std::string_view>>;

// A number beyond the range of a double: infinite, or as good as zero.
double beyond_range(std::string_view word) {
  long double wide = 0;
  if (std::from_chars(word.data(), word.data() + word.size(), wide).ec == std::errc())
    return static_cast<double>(wide);
  if (word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos)
    return 0;
  return word.starts_with('-') ? -infinity : infinity;
}

// A number such as "1.5e3", in any locale with a decimal point; nothing if the word is not one.
// (Exponents with a D are refused: readers take them as 1 or as 1000.)
std::optional<double> number(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument) return {};
  return error == std::errc::result_out_of_range ? beyond_range(word) : value;
}

std::optional<bool> maximise_says(std::string_view word) {
  const auto sense = capitals(word);
  for (const char* name : {"MAX", "MAXIMIZE", "MAXIMISE"}) {
    if (sense == name) return true;
  }
  for (const char* name : {"MIN", "MINIMIZE", "MINIMISE"}) {
    if (sense == name) return false;
  }
  return {};
}

class MpsReader {
 public:
  MpsReader(std::string_view text, const std::string& file, MpsLayout layout)
      : lines_(text, layout), layout_(layout), file_(file) {}

  ProgramFile read() {
    while (section_ != MpsSection::end && lines_.next(line_)) {
      if (line_.header) {
        begin_section();
      } else {
        if (lines_.off_the_columns())
          refuse("a word between the fields", "the columns of fixed MPS");
        read_line();
      }
    }
    if (section_ != MpsSection::end) {
      line_.number = lines_.number();
      refuse("the file ends without ENDATA", "the whole file");
    }
    return program_of(std::move(content_), file_, line_.number);
  }

  /// Number of the last line read.
  [[nodiscard]] std::size_t line() const { return line_.number; }

 private:
  [[noreturn]] void refuse(std::string_view what, std::string_view expected) const {
    refuse_line(file_, line_.number, what, expected);
  }
  void warn(const std::string& what) {
    content_.warnings.push_back(fmt::format("{}:{}: {}", file_, line_.number, what));
  }

  // ---- sections ------------------------------------------------------------------------------

  void begin_section() {
    in_integers_ = false;
    const auto word = capitals(line_.fields.front());
    if (section_ == MpsSection::sense && line_.fields.size() == 1 && maximise_says(word)) {
      set_sense(word);
      return;
    }
    static constexpr std::array<std::pair<std::string_view, MpsSection>, 9> known{{
        {"NAME", MpsSection::none},
        {"OBJSENSE", MpsSection::sense},
        {"OBJNAME", MpsSection::objective_name},
        {"ROWS", MpsSection::rows},
        {"COLUMNS", MpsSection::columns},
        {"RHS", MpsSection::rhs},
        {"RANGES", MpsSection::ranges},
        {"BOUNDS", MpsSection::bounds},
        {"ENDATA", MpsSection::end},
    }};
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const auto& entry) { return entry.first == word; });
    if (found == known.end()) {
      if (const auto feature = unsupported_feature(word); !feature.empty()) {
        refuse_unsupported(file_, line_.number, line_.fields.front(), feature);
      }
      refuse(fmt::format("section {}, which is not read", in_quotes(line_.fields.front())),
             "NAME, OBJSENSE, OBJNAME, ROWS, COLUMNS, RHS, RANGES, BOUNDS or ENDATA");
    }
    const auto index = static_cast<std::size_t>(found - known.begin());
    if (seen_.at(index)) refuse(fmt::format("a second section {}", word), "each section once");
    seen_.at(index) = true;
    section_ = found->second;
    set_.reset();
    check_order(word);
    const bool takes_more = section_ == MpsSection::none || section_ == MpsSection::sense ||
                            section_ == MpsSection::objective_name;
    if (line_.fields.size() > 1 && !takes_more && section_ != MpsSection::end) {
      refuse(fmt::format("{} after {}", in_quotes(line_.fields[1]), word),
             "the name of the section alone");
    }
    if (line_.fields.size() == 1) return;
    const auto rest =
        line_.text.substr(static_cast<std::size_t>(line_.fields[1].data() - line_.text.data()));
    if (section_ == MpsSection::none) content_.name = rest;
    if (section_ == MpsSection::sense) set_sense(rest);
    if (section_ == MpsSection::objective_name) content_.objective_name = std::string(rest);
  }

  void check_order(const std::string& word) {
    const bool needs_rows = section_ == MpsSection::columns || section_ == MpsSection::rhs ||
                            section_ == MpsSection::ranges || section_ == MpsSection::end;
    const bool needs_columns = section_ == MpsSection::bounds || section_ == MpsSection::end;
    if (needs_rows && !seen(MpsSection::rows)) {
      refuse(fmt::format("{} without a section ROWS before", word), "ROWS");
    }
    if (needs_columns && !seen(MpsSection::columns)) {
      refuse(fmt::format("{} without a section COLUMNS before", word), "COLUMNS");
    }
  }

  [[nodiscard]] bool seen(MpsSection section) const {
    return seen_.at(section == MpsSection::rows ? 3 : 4);
  }

  void set_sense(std::string_view word) {
    const auto maximise = maximise_says(word);
    if (!maximise) refuse(fmt::format("the sense {}", in_quotes(word)), "MAX or MIN");
    if (sense_given_) refuse("a second sense of the objective", "MAX or MIN once");
    sense_given_ = true;
    content_.maximise = *maximise;
  }

  void read_line() {
    switch (section_) {
      case MpsSection::sense:
        return set_sense(line_.text);
      case MpsSection::objective_name:
        if (content_.objective_name) refuse("a second name of the objective", "one");
        content_.objective_name = std::string(line_.text);
        return;
      case MpsSection::rows:
        return read_row();
      case MpsSection::columns:
        return read_column();
      case MpsSection::rhs:
      case MpsSection::ranges:
        return read_right_sides();
      case MpsSection::bounds:
        return read_bound();
      case MpsSection::none:
      case MpsSection::end:
        break;
    }
    refuse("a line of no section", "ROWS");
  }

  // ---- rows ------------------------------------------------------------------------------------

  void read_row() {
    const bool good =
        layout_ == MpsLayout::fixed
            ? !line_.fields[0].empty() && !line_.fields[1].empty() && line_.fields[2].empty()
            : line_.fields.size() == 2;
    if (!good) refuse("a row of another form", "its type N, L, G or E and its name");
    const auto type = capitals(line_.fields[0]);
    if (type != "N" && type != "L" && type != "G" && type != "E") {
      refuse(fmt::format("a row of type {}", in_quotes(line_.fields[0])), "N, L, G or E");
    }
    const std::string name(line_.fields[1]);
    if (!row_of_.emplace(name, content_.rows.size()).second) {
      refuse(fmt::format("a second row {}", in_quotes(name)), "each name once");
    }
    content_.rows.push_back(
        {.type = type.front(), .name = name, .right = {}, .range = {}, .terms = {}});
    column_in_row_.push_back(-1);
  }

  std::size_t row_called(std::string_view name) const {
    const auto at = row_of_.find(std::string(name));
    if (at == row_of_.end()) {
      refuse(fmt::format("{} is not a row", in_quotes(name)), "a name of section ROWS");
    }
    return at->second;
  }

  double number_or_refuse(std::string_view word) const {
    const auto value = number(word);
    if (!value || std::isnan(*value)) {
      refuse(fmt::format("{} is not a number", in_quotes(word)), "a number like -1.5e3");
    }
    return *value;
  }

  // ---- columns ----------------------------------------------------------------------------------

  bool read_marker() {
    const auto& fields = line_.fields;
    std::string_view word;
    std::string_view what;
    if (layout_ == MpsLayout::fixed) {
      word = fields[2];
      what = fields[4].empty() ? fields[3] : fields[4];
    } else if (fields.size() == 2 || fields.size() == 3) {
      word = fields[fields.size() - 2];
      what = fields.back();
    }
    if (word != "'MARKER'" && (word != "MARKER" || number(what))) return false;
    if (what.size() > 2 && what.front() == '\'') what = what.substr(1, what.size() - 2);
    if (what == "SOSORG" || what == "SOSEND") {
      refuse_unsupported(file_, line_.number, what, "special ordered sets");
    }
    const bool begins = what == "INTORG";
    if (!begins && what != "INTEND") {
      refuse(fmt::format("a marker of {}", in_quotes(what)), "'INTORG' or 'INTEND'");
    }
    if (begins == in_integers_) {
      refuse(begins ? "a second 'INTORG'" : "'INTEND' without 'INTORG'", "them in turn");
    }
    in_integers_ = begins;
    return true;
  }

  // The name at the front, and pairs. In free MPS a line with an even number of words has no name.
  Pairs read_pairs(std::string_view& name, bool name_needed) const {
    const auto& fields = line_.fields;
    Pairs pairs;
    if (layout_ == MpsLayout::fixed) {
      name = fields[1];
      if (!fields[0].empty() || (name_needed && name.empty()) || fields[2].empty())
        refuse_pairs(name_needed);
      for (const std::size_t at : {std::size_t{2}, std::size_t{4}}) {
        if (at == 4 && fields[4].empty() && fields[5].empty()) continue;
        pairs.emplace_back(fields[at], fields[at + 1]);
      }
      return pairs;
    }
    const bool named = fields.size() % 2 == 1;
    if (fields.size() < 2 || fields.size() > 5 || (name_needed && !named))
      refuse_pairs(name_needed);
    if (named) name = fields.front();
    for (std::size_t at = named ? 1 : 0; at < fields.size(); at += 2) {
      pairs.emplace_back(fields[at], fields[at + 1]);
    }
    return pairs;
  }

  [[noreturn]] void refuse_pairs(bool column) const {
    refuse(column ? "a column of another form" : "a line of another form",
           column ? "its name, and one or two rows each with a number"
                  : "one or two rows each with a number");
  }

  void read_column() {
    if (read_marker()) return;
    std::string_view name;
    const auto pairs = read_pairs(name, true);
    if (content_.columns.empty() || content_.columns.back().name != name) {
      if (!column_of_.emplace(std::string(name), content_.columns.size()).second) {
        refuse(fmt::format("column {} comes again after another", in_quotes(name)),
               "all of a column together");
      }
      content_.columns.push_back(
          {.name = std::string(name), .is_integer = in_integers_, .line = line_.number});
    }
    const int column = static_cast<int>(content_.columns.size()) - 1;
    for (const auto& [row_name, word] : pairs) {
      const auto row = row_called(row_name);
      const double value = number_or_refuse(word);
      if (!std::isfinite(value)) refuse("an entry that is not finite", "a number");
      if (std::exchange(column_in_row_[row], column) == column) {
        refuse(fmt::format("a second entry of column {} in row {}", in_quotes(name),
                           in_quotes(row_name)),
               "one");
      }
      content_.rows[row].terms.push_back({column, value});
    }
  }

  // ---- right-hand sides, ranges -----------------------------------------------------------------

  // Several sets are refused: other solvers take the first, or mix them.
  void check_set(std::string_view name) {
    if (!set_) set_ = std::string(name);
    if (*set_ != name) {
      refuse(fmt::format("a second set {} after {}", in_quotes(name), in_quotes(*set_)), "one set");
    }
  }

  void read_right_sides() {
    std::string_view set;
    const auto pairs = read_pairs(set, false);
    const bool ranges = section_ == MpsSection::ranges;
    for (const auto& [row_name, word] : pairs) {
      auto& row = content_.rows[row_called(row_name)];
      const double value = number_or_refuse(word);
      auto& place = ranges ? row.range : row.right;
      if (place) {
        refuse(fmt::format("a second {} of row {}", ranges ? "range" : "right-hand side",
                           in_quotes(row_name)),
               "one");
      }
      if (ranges && row.type == 'N') {
        refuse(fmt::format("a range of row {}, which is of type N", in_quotes(row_name)),
               "one of a row of type L, G or E");
      }
      place = value;
      if (!ranges) check_right_side(row, value);
    }
    check_set(set);
  }

  void check_right_side(const MpsRow& row, double value) const {
    const bool finite = std::abs(value) < infinite_in_files;
    const bool good = finite || (row.type == 'L' && value > 0) || (row.type == 'G' && value < 0);
    if (!good) {
      refuse(fmt::format("the right-hand side {} of row {}", value, in_quotes(row.name)),
             "a number below 1e20");
    }
  }

  // ---- bounds -----------------------------------------------------------------------------------

  void read_bound() {
    const auto& fields = line_.fields;
    const auto type = capitals(fields.front());
    static constexpr std::array<std::string_view, 9> known{"LO", "UP", "FX", "FR", "MI",
                                                           "PL", "BV", "LI", "UI"};
    if (type == "SC" || type == "SI" || type == "SN") {
      refuse_unsupported(file_, line_.number, type, "semi-continuous columns");
    }
    if (std::find(known.begin(), known.end(), type) == known.end()) {
      refuse(fmt::format("a bound of type {}", in_quotes(fields.front())),
             "LO, UP, FX, FR, MI, PL, BV, LI or UI");
    }
    const bool valued = type != "FR" && type != "MI" && type != "PL" && type != "BV";
    std::string_view set;
    std::string_view name;
    std::string_view word;
    if (layout_ == MpsLayout::fixed) {
      set = fields[1];
      name = fields[2];
      word = fields[3];
    } else {
      std::size_t count = fields.size() - 1;
      if (!valued && count >= 2 &&
          column_of_.find(std::string(fields[count - 1])) != column_of_.end() &&
          number(fields[count])) {
        word = fields[count--];  // a value where none is required
      } else if (valued && count >= 2) {
        word = fields[count--];
      }
      if (count < 1 || count > 2) refuse_bound(valued);
      name = fields[count];
      if (count == 2) set = fields[1];
    }
    if (name.empty() || (valued && word.empty())) refuse_bound(valued);
    const auto at = column_of_.find(std::string(name));
    if (at == column_of_.end()) {
      refuse(fmt::format("{} is not a column", in_quotes(name)), "a name of section COLUMNS");
    }
    check_set(set);
    bound(content_.columns[at->second], type, valued ? number_or_refuse(word) : 0);
  }

  [[noreturn]] void refuse_bound(bool valued) const {
    refuse("a bound of another form",
           valued ? "its type, its set, a column and a number" : "its type, its set and a column");
  }

  void bound(MpsColumn& column, std::string_view type, double value) {
    if (type == "LI" || type == "UI" || type == "BV") column.is_integer = true;
    if (type == "UP" || type == "UI") {
      set_upper(column, value);
      if (value < 0 && !column.lower_given) {
        column.lower = -infinity;
        warn(fmt::format(
            "column {} has the upper bound {} and no lower bound before it; its lower bound "
            "is minus infinity, not 0",
            in_quotes(column.name), value));
      }
    } else if (type == "LO" || type == "LI") {
      set_lower(column, value);
    } else if (type == "FX") {
      set_lower(column, value);
      set_upper(column, value);
    } else if (type == "BV") {
      set_lower(column, 0);
      set_upper(column, 1);
    } else {
      if (type != "PL") set_lower(column, -infinity);
      if (type != "MI") set_upper(column, infinity);
    }
  }

  void set_lower(MpsColumn& column, double value) const {
    if (column.lower_given) refuse_second("lower", column);
    if (value >= infinite_in_files) refuse_shut(column, value);
    column.lower_given = true;
    column.lower = value <= -infinite_in_files ? -infinity : value;
  }
  void set_upper(MpsColumn& column, double value) const {
    if (column.upper_given) refuse_second("upper", column);
    if (value <= -infinite_in_files) refuse_shut(column, value);
    column.upper_given = true;
    column.upper = value >= infinite_in_files ? infinity : value;
  }
  [[noreturn]] void refuse_second(std::string_view side, const MpsColumn& column) const {
    refuse(fmt::format("a second {} bound of column {}", side, in_quotes(column.name)), "one");
  }
  [[noreturn]] void refuse_shut(const MpsColumn& column, double value) const {
    refuse(fmt::format("the bound {} leaves no value for column {}", value, in_quotes(column.name)),
           "a number below 1e20");
  }

  MpsLines lines_;
  MpsLayout layout_;
  const std::string& file_;
  MpsLine line_;
  MpsSection section_ = MpsSection::none;
  std::array<bool, 9> seen_{};
  std::optional<std::string> set_;  // set name of the current section
  bool in_integers_ = false;
  bool sense_given_ = false;
  MpsContent content_;
  std::vector<int> column_in_row_;  // the last column that had an entry in this row
  std::unordered_map<std::string, std::size_t> row_of_;
  std::unordered_map<std::string, std::size_t> column_of_;
};

}  // namespace

// Nearly all fixed MPS is valid free MPS; exceptions have names with blanks. For a file that is
// neither, the fault of the reading that came further is reported.
ProgramFile parse_mps(std::string_view text, const std::string& file) {
  MpsReader free(text, file, MpsLayout::free);
  try {
    return free.read();
  } catch (const InputError&) {
    MpsReader fixed(text, file, MpsLayout::fixed);
    try {
      return fixed.read();
    } catch (const InputError&) {
      if (fixed.line() > free.line()) throw;
    }
    throw;
  }
}

}  // namespace kusabi::linear
