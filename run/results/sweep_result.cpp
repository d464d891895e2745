// Text and curve of sweeps of friction and of loads.
#include "run/results/sweep_result.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "run/results/alpha_unit.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using pictures::Chart;
using pictures::ChartSeries;
using pictures::Stroke;

// The linear pieces of a curve of load factors, with a gap where they do not meet.
ChartSeries series_of(const ResultReader& reader, const ResultJson& pieces,
                      const std::string& name) {
  ChartSeries curve{.name = name + ", linear between its breakpoints"};
  double end = 0;
  for (const auto& piece : pieces) {
    const double from = reader.number(piece, "from");
    if (curve.lines.empty() || from != end)
      curve.lines.push_back({{from, reader.number(piece, "factor_from")}});
    end = reader.number(piece, "to");
    curve.lines.back().emplace_back(end, reader.number(piece, "factor_to"));
  }
  return curve;
}

/// Parts common to both.
class SweepPage {
 public:
  SweepPage(const ResultReader& reader, std::string sentence)
      : reader_(reader),
        sentence_(std::move(sentence)),
        problem_(reader.at(reader.all(), "problem")),
        result_(reader.at(reader.all(), "result")) {}

 protected:
  [[nodiscard]] std::string problem_name() const { return reader_.text(problem_, "name"); }
  // Text before the unit of alpha, if there is one.
  [[nodiscard]] std::string alpha_in(const char* before) const {
    const auto unit = unit_of_alpha(reader_);
    return unit ? before + *unit : std::string();
  }
  [[nodiscard]] const ResultJson& list(const char* key) const { return reader_.list(result_, key); }
  [[nodiscard]] double number(const ResultJson& object, const char* key) const {
    return reader_.number(object, key);
  }
  [[nodiscard]] static bool has(const ResultJson& object, const char* key) {
    return ResultReader::find(object, key) != nullptr;
  }

  const ResultReader& reader_;
  std::string sentence_;
  const ResultJson& problem_;
  const ResultJson& result_;
};

class SweptFriction : public SweepPage {
 public:
  using SweepPage::SweepPage;

  [[nodiscard]] std::optional<Chart> chart() const {
    if (list("staircase").empty()) return {};
    // Maximum number of digits that fit at an axis.
    constexpr double max_digits = 8;
    const bool many = std::ranges::any_of(list("staircase"), [&](const ResultJson& step) {
      return known_between(step).log10() > max_digits;
    });
    Chart chart{.title = problem_name(),
                .description = sentence_,
                .lines = {"sign patterns of wedged configurations", sentence_},
                .x_name = answer::friction_name(has_own_friction(reader_)),
                .y_name = many ? "log10 (1 + sign patterns)" : "sign patterns",
                .whole_numbers = !many,
                .series = {}};
    chart.series.push_back(stairs(many));
    auto asked = points(many);
    if (!asked.marks.empty()) chart.series.push_back(std::move(asked));
    return chart;
  }

 private:
  // Steps are joined where the coefficient between them is known better than can be seen.
  [[nodiscard]] ChartSeries stairs(bool as_logarithms) const {
    constexpr double visible = 1e-3;
    const bool some_open = !list("open").empty();
    ChartSeries stairs{.name = some_open ? "number of sign patterns known; some are open"
                                         : "number of sign patterns, constant between its steps",
                       .stroke = some_open ? Stroke::dashed : Stroke::curve};
    const auto& steps = list("staircase");
    const double width = number(steps.back(), "to") - number(steps.front(), "from");
    for (const auto& step : steps) {
      const double from = number(step, "from");
      const double count = height(known_between(step), as_logarithms);
      if (stairs.lines.empty() || from - stairs.lines.back().back().x() > visible * width)
        stairs.lines.emplace_back();
      stairs.lines.back().emplace_back(from, count);
      stairs.lines.back().emplace_back(number(step, "to"), count);
    }
    return stairs;
  }
  [[nodiscard]] ChartSeries points(bool as_logarithms) const {
    ChartSeries asked{.name = "at the given points"};
    for (const auto& point : list("points")) {
      if (!has(point, "count")) continue;
      const double mu = number(point, "mu");
      const auto count = known(point, mu);
      asked.marks.push_back({mu, height(count, as_logarithms),
                             fmt::format("{} at {}", answer::counted(count, "sign pattern"), mu)});
    }
    return asked;
  }

  // Product over the blocks of the numbers of requested patterns.
  [[nodiscard]] support::ExactCount product_of(
      const std::function<bool(const ResultJson&)>& asked) const {
    std::map<std::string, std::uint64_t> of_block;
    for (const auto& pattern : list("patterns")) {
      if (!asked(pattern)) continue;
      const auto* const block = ResultReader::find(pattern, "block");
      ++of_block[block == nullptr ? "" : block->dump()];
    }
    std::vector<std::uint64_t> factors;
    factors.reserve(of_block.size());
    for (const auto& [block, count] : of_block) factors.push_back(count);
    return factors.empty() ? support::ExactCount() : support::ExactCount::product(factors);
  }
  /// The count of the file, except for a 64-bit product (0.1) that has overflowed.
  [[nodiscard]] support::ExactCount known(const ResultJson& counted, double friction) const {
    if (could_not_wrap_) return reader_.count(counted, "known");
    return product_of([&](const ResultJson& pattern) {
      const auto* const absorbed = ResultReader::find(pattern, "absorbed");
      return number(pattern, "upper") <= friction &&
             (absorbed == nullptr || friction <= number(*absorbed, "lower"));
    });
  }
  [[nodiscard]] support::ExactCount known_between(const ResultJson& step) const {
    return known(step, std::midpoint(number(step, "from"), number(step, "to")));
  }
  [[nodiscard]] static double height(const support::ExactCount& count, bool as_logarithm) {
    const auto small = count.number();
    if (!as_logarithm && small) return static_cast<double>(*small);
    return small ? std::log10(1 + static_cast<double>(*small)) : count.log10();
  }
  const bool could_not_wrap_ =
      product_of([](const ResultJson&) { return true; }).log10() < 64 * std::log10(2.0);
};

class SweptLoads : public SweepPage {
 public:
  using SweepPage::SweepPage;

  [[nodiscard]] std::optional<Chart> chart() const {
    auto line = series_of(reader_, list("curve"), "worst case");
    auto asked = points();
    if (line.lines.empty() && asked.lines.empty()) return {};
    Chart chart{.title = problem_name() + ": worst-case limit load factor",
                .description = sentence_,
                .lines = {sentence_},
                .x_name = "uncertainty alpha of each load" + alpha_in(", "),
                .y_name = "limit load factor",
                .whole_numbers = false,
                .series = {}};
    if (!line.lines.empty()) chart.series.push_back(std::move(line));
    if (!asked.lines.empty()) chart.series.push_back(std::move(asked));
    return chart;
  }

 private:
  // From the lower to the upper bound; the mark is at the upper one.
  [[nodiscard]] ChartSeries points() const {
    constexpr double visible = 1e-3;  // relative
    constexpr int digits = 10;
    ChartSeries asked{.name = "at the given points"};
    for (const auto& point : list("points")) {
      const auto& ends = reader_.at(point, "maximum");
      if (!has(ends, "upper") || reader_.text(point, "state") == "not-carried") continue;
      const double alpha = number(point, "alpha");
      const double upper = *reader_.bound(ends, "upper");
      const double lower = reader_.bound(ends, "lower").value_or(-HUGE_VAL);
      if (upper - lower > visible * std::abs(upper))
        asked.name = "at the given points: from the lower bound to the upper one";
      asked.lines.push_back({{alpha, lower}, {alpha, upper}});
      const auto shown = support::in_sentence(lower, upper, digits);
      const auto standing = [&](const char* key) {
        return has(ends, key) ? reader_.text(reader_.at(ends, key), "standing") : "";
      };
      asked.marks.push_back(
          {alpha, upper,
           std::isinf(lower)
               ? fmt::format("at most {} at alpha = {}, {}", support::rounded_up(upper, digits),
                             alpha, standing("upper"))
               : fmt::format("{} ({}) to {} ({}) at alpha = {}", shown.lower, standing("lower"),
                             shown.upper, standing("upper"), alpha)});
    }
    return asked;
  }
};

}  // namespace

bool is_sweep(const ResultReader& reader) {
  const auto* const command = ResultReader::find(reader.all(), "command");
  return command != nullptr && *command == "sweep";
}

bool sweeps_loads(const ResultReader& reader) {
  return ResultReader::find(reader.at(reader.all(), "options"), "alpha") != nullptr;
}

std::optional<pictures::Chart> load_curve_chart(const ResultReader& reader, const char* key,
                                                const std::string& name) {
  auto line = series_of(reader, reader.list(reader.at(reader.all(), "result"), key), name);
  if (line.lines.empty()) return {};
  return Chart{.title = name,
               .description = fmt::format("Load factor as a function of beta: {}", name),
               .lines = {},
               .x_name = "beta",
               .y_name = "limit load factor",
               .whole_numbers = false,
               .series = {std::move(line)}};
}

std::optional<pictures::Chart> sweep_chart(const ResultReader& reader,
                                           const std::string& sentence) {
  return sweeps_loads(reader) ? SweptLoads(reader, sentence).chart()
                              : SweptFriction(reader, sentence).chart();
}

}  // namespace kusabi::run
