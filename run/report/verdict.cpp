// Command by command. Only what the file says is claimed: "it cannot" needs a whole search.
#include "run/report/verdict.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

// @param way -1 down, 1 up
std::string rounded_to(double number, int way) {
  if (number == 0) return "0";
  constexpr int digits = 5;
  const int places = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(number))));
  if (places < 0 || places > 3 * digits) return fmt::format("{}", number);
  const double unit = std::pow(10, -places);
  auto text = fmt::format("{:.{}f}", number, places);
  const double shown = std::stod(text);
  if (way * (number - shown) > 0) text = fmt::format("{:.{}f}", shown + way * unit, places);
  return text;
}

class Concluding {
 public:
  explicit Concluding(const ResultReader& reader)
      : reader_(reader), result_(reader.at(reader.all(), "result")) {}

  Conclusion conclude() {
    status_ = reader_.text(reader_.all(), "status");
    const auto command = reader_.text(reader_.all(), "command");
    if (command == "limit") {
      limit();
    } else {
      if (status_ != "solved")
        reserve(fmt::format("The search ended early ({}): what is listed is right, but not all.",
                            status_));
      if (command == "critical") {
        critical();
      } else {
        ways(command == "rays" ? "extremal rays" : "ways");
      }
    }
    return std::move(all_);
  }

 private:
  void reserve(std::string text) { all_.reservations.push_back(std::move(text)); }

  [[nodiscard]] double count_of(const char* key) const {
    return ResultReader::find(result_, key) == nullptr ? 0 : reader_.number(result_, key);
  }

  [[nodiscard]] static bool is_true(const ResultJson& object, const char* key) {
    const auto* const value = ResultReader::find(object, key);
    return value != nullptr && value->is_boolean() && value->get<bool>();
  }

  void ways(std::string_view things) {
    const auto where = fmt::format("friction coefficient {}", reader_.number(result_, "friction"));
    const double count = reader_.number(result_, "count");
    const double doubtful = count_of("marginal") + count_of("undecided");
    if (count > 0) {
      auto some = std::string(things);
      if (count == 1) some.pop_back();
      all_.sentence = fmt::format("It can stick: {}{:.0f} {} at {}.",
                                  status_ == "solved" ? "" : "at least ", count, some, where);
    } else if (doubtful == 0 && status_ == "solved") {
      all_.sentence = fmt::format("It cannot stick at {}.", where);
    } else {
      all_.sentence = fmt::format("It is not known whether it can stick at {}.", where);
    }
    if (doubtful > 0) {
      reserve(
          fmt::format("Of {:.0f} sign pattern(s) it could not be decided whether they hold a "
                      "wedged configuration; they are not counted.",
                      doubtful));
    }
    const auto* const health = ResultReader::find(result_, "health");
    if (health != nullptr && ResultReader::find(*health, "doubtful") != nullptr &&
        reader_.number(*health, "doubtful") > 0)
      reserve("Some numbers are too near to zero to tell: the lists may be wrong.");
  }

  void critical() {
    const auto& bracket = reader_.at(result_, "critical_friction");
    const double lower = reader_.number(bracket, "lower");
    if (ResultReader::find(bracket, "upper") == nullptr) {
      all_.sentence =
          fmt::format("It cannot stick up to friction coefficient {}.", rounded_down(lower));
    } else {
      const double upper = reader_.number(bracket, "upper");
      all_.sentence =
          lower > 0 ? fmt::format("It cannot stick below friction coefficient {}; at {} it can.",
                                  rounded_down(lower), rounded_up(upper))
                    : fmt::format("It can stick at friction coefficient {}.", rounded_up(upper));
      if (!is_true(bracket, "upper_proved")) reserve("The upper end is computed, not proved.");
    }
    if (!is_true(bracket, "lower_proved")) reserve("The lower end is computed, not proved.");
    if (ResultReader::find(result_, "open") == nullptr) return;
    for (auto& sentence : reader_.names(result_, "open")) reserve(std::move(sentence));
  }

  void limit() {
    const auto* const worst = ResultReader::find(result_, "worst_case");
    if (status_ == "not-carried") {
      all_.sentence =
          ResultReader::find(result_, "nominal") == nullptr
              ? "It does not carry its dead load at any load factor."
              : "There is a dead load within ± α that it does not carry at any load factor.";
    } else if (worst == nullptr) {
      nominal();
    } else {
      worst_case(*worst);
    }
    if (status_ != "solved" && status_ != "not-carried")
      reserve(fmt::format("The question is not answered in full ({}).", status_));
  }

  void nominal() {
    all_.sentence = ResultReader::find(result_, "nominal") == nullptr
                        ? "No load factor was found at which it carries its dead load."
                        : fmt::format("It carries {} times the reference load, and no more.",
                                      rounded_down(reader_.number(result_, "nominal")));
    reserve("This is as the simplex method finds it, for the dead load exactly as given.");
  }

  void worst_case(const ResultJson& worst) {
    const auto alpha = fmt::format("{} {}", reader_.number(result_, "alpha"), force());
    if (ResultReader::find(worst, "lower") == nullptr) {
      all_.sentence = fmt::format(
          "No load was found that it carries whatever the dead load is within ± {}.", alpha);
      return;
    }
    const double lower = reader_.number(worst, "lower");
    all_.sentence = fmt::format(
        "It carries at least {} times the reference load, whatever the dead load is "
        "within ± {}.",
        rounded_down(lower), alpha);
    if (lower < 0) reserve("The factor is negative: a dead load within ± α alone collapses it.");
    if (!is_true(worst, "lower_proved")) reserve("The lower end is computed, not proved.");
    if (!is_true(worst, "upper_proved")) reserve("The upper end is computed, not proved.");
  }

  [[nodiscard]] std::string force() const {
    const auto& problem = reader_.at(reader_.all(), "problem");
    return reader_.text(reader_.at(problem, "units"), "force");
  }

  const ResultReader& reader_;
  const ResultJson& result_;
  std::string status_;
  Conclusion all_;
};

}  // namespace

std::string rounded_down(double number) {
  return rounded_to(number, -1);
}

std::string rounded_up(double number) {
  return rounded_to(number, 1);
}

Conclusion conclusion(const ResultReader& reader) {
  return Concluding(reader).conclude();
}

}  // namespace kusabi::run
