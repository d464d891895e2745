// Numbers separated by colons or commas.
#include "run/command/sweep_points.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "run/output/number_in.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

constexpr std::size_t max_points = 10000;

class PointsReader {
 public:
  PointsReader(const std::string& option, const std::string& text) : option_(option), text_(text) {}

  [[nodiscard]] std::vector<double> numbers(char between) const {
    std::vector<double> list;
    for (std::size_t from = 0; from <= text_.size();) {
      const auto to = std::min(text_.find(between, from), text_.size());
      const auto value = number_in(text_.substr(from, to - from));
      if (!value) {
        wrong("expected START:END:STEP, such as 0.1:1.0:0.05, or numbers separated by commas");
      }
      list.push_back(*value);
      from = to + 1;
    }
    return list;
  }

  [[nodiscard]] std::vector<double> range() const {
    const auto three = numbers(':');
    if (three.size() != 3 || !(three[2] > 0) || !(three[0] <= three[1])) {
      wrong("expected START:END:STEP with START not above END and STEP above 0");
    }
    if ((three[1] - three[0]) / three[2] >= static_cast<double>(max_points)) too_many();
    std::vector<double> points;
    for (int step = 0;; ++step) {
      // The decimals of START and STEP, without the rounding errors of the sum.
      const double point =
          step == 0 ? three[0] : *number_in(fmt::format("{:.12g}", three[0] + step * three[2]));
      if (point > three[1]) return points;
      points.push_back(point);
    }
  }

  [[noreturn]] void wrong(const std::string& expected) const {
    throw WrongInput(fmt::format("{} '{}': {}", option_, text_, expected));
  }
  [[noreturn]] void too_many() const {
    wrong(fmt::format("expected no more than {} points", max_points));
  }

 private:
  const std::string& option_;
  const std::string& text_;
};

}  // namespace

std::vector<double> sweep_points(const std::string& option, const std::string& text, bool zero) {
  const PointsReader reader(option, text);
  const bool is_range = text.find(':') != std::string::npos;
  auto points = is_range ? reader.range() : reader.numbers(',');
  if (points.size() > max_points) reader.too_many();
  if (std::ranges::adjacent_find(points, std::greater_equal()) != points.end())
    reader.wrong("expected numbers that increase");
  if (zero ? points.front() < 0 : points.front() <= 0)
    reader.wrong(zero ? "expected numbers that are not negative" : "expected numbers above 0");
  return points;
}

}  // namespace kusabi::run
