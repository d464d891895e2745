// Command by command. Only what the file says is claimed: "it cannot" needs a whole search.
#include "run/report/verdict.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "run/output/conclusions.hpp"
#include "run/output/values.hpp"
#include "run/results/alpha_unit.hpp"
#include "run/results/sweep_result.hpp"

namespace kusabi::run {
namespace {

class Concluding {
 public:
  explicit Concluding(const ResultReader& reader)
      : reader_(reader), result_(reader.at(reader.all(), "result")) {}

  Conclusion conclude() {
    status_ = reader_.text(reader_.all(), "status");
    const auto command = reader_.text(reader_.all(), "command");
    if (command == "limit") {
      limit();
    } else if (command == "sweep") {
      sweep();
    } else {
      if (status_ != "solved")
        reserve(fmt::format("The search ended early ({}): what is listed is right, but not all.",
                            status_));
      if (command == "critical") {
        critical();
      } else {
        ways(command == "rays" ? "extremal ray" : "way");
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

  // Whether it leaves anything.
  bool reserve_what_the_exact_test_leaves() {
    const auto* const exact = ResultReader::find(result_, "exact");
    if (exact == nullptr || ResultReader::find(*exact, "doubt") == nullptr) return false;
    reserve(reader_.text(*exact, "doubt"));
    return true;
  }

  // Whether the exact test was to be done and was not, or found another list.
  bool is_refuted() {
    const auto* const exact = ResultReader::find(result_, "exact");
    return exact != nullptr && ResultReader::find(*exact, "doubt") != nullptr &&
           !is_true(*exact, "done");
  }

  void ways(std::string_view thing) {
    const bool in_doubt = reserve_what_the_exact_test_leaves();
    const Sticking found{.thing = thing,
                         .friction = reader_.number(result_, "friction"),
                         .count = is_refuted() ? 0 : reader_.number(result_, "count"),
                         .doubtful = count_of("marginal") + count_of("undecided"),
                         .whole = status_ == "solved" && !in_doubt};
    all_.sentence = sticking_sentence(found);
    if (found.doubtful > 0) reserve(doubtful_sentence(found.doubtful));
    const auto* const health = ResultReader::find(result_, "health");
    if (health != nullptr && ResultReader::find(*health, "doubtful") != nullptr &&
        reader_.number(*health, "doubtful") > 0)
      reserve(unsound_sentence());
  }

  void critical() {
    const auto& bracket = reader_.at(result_, "critical_friction");
    const double lower = reader_.number(bracket, "lower");
    std::optional<double> upper;
    if (ResultReader::find(bracket, "upper") != nullptr) upper = reader_.number(bracket, "upper");
    all_.sentence = critical_sentence(lower, upper);
    if (upper && !is_true(bracket, "upper_proved"))
      reserve("The upper end is computed, not proved.");
    if (!is_true(bracket, "lower_proved")) reserve("The lower end is computed, not proved.");
    if (ResultReader::find(result_, "open") == nullptr) return;
    for (auto& sentence : reader_.names(result_, "open")) reserve(std::move(sentence));
  }

  void sweep() {
    all_.sentence = sweep_sentence(reader_);
    if (all_.sentence.empty()) {
      all_.sentence = sweeps_loads(reader_) ? carried_sentence(reader_.number(result_, "nominal"))
                                            : critical_sentence(0, {});
    }
    const auto& points = reader_.list(result_, "points");
    if (status_ != "solved" && status_ != "not-carried")
      reserve(fmt::format("The question is not answered in full ({}).", status_));
    if (sweeps_loads(reader_)) return;
    reserve_what_the_exact_test_leaves();
    if (const auto open = reader_.list(result_, "open").size(); open > 0) {
      reserve(fmt::format("Of {} it could not be told what {} above a certain coefficient.",
                          counted(open, "pattern"), open == 1 ? "it is" : "they are"));
    }
    const auto undecided = std::ranges::count_if(points, [](const ResultJson& point) {
      return ResultReader::find(point, "count") == nullptr;
    });
    if (undecided > 0) {
      reserve(
          fmt::format("At {} of the points the count is not decided: within a bracket in "
                      "which a pattern begins, or above what is open.",
                      undecided));
    }
  }

  void limit() {
    const auto* const worst = ResultReader::find(result_, "worst_case");
    if (status_ == "not-carried") {
      all_.sentence = not_carried_sentence(ResultReader::find(result_, "nominal") != nullptr);
    } else if (worst == nullptr) {
      nominal();
    } else {
      worst_case(*worst);
    }
    if (status_ != "solved" && status_ != "not-carried")
      reserve(fmt::format("The question is not answered in full ({}).", status_));
  }

  void nominal() {
    all_.sentence = carried_sentence(ResultReader::find(result_, "nominal") == nullptr
                                         ? std::nullopt
                                         : std::optional(reader_.number(result_, "nominal")));
    reserve("This is as the simplex method finds it, for the dead load exactly as given.");
  }

  void worst_case(const ResultJson& worst) {
    const auto alpha = ResultReader::find(result_, "alpha") == nullptr
                           ? std::nullopt
                           : std::optional(reader_.number(result_, "alpha"));
    if (ResultReader::find(worst, "lower") == nullptr) {
      all_.sentence = always_carried_sentence({}, alpha, unit_of_alpha(reader_));
      return;
    }
    const double lower = reader_.number(worst, "lower");
    all_.sentence = always_carried_sentence(lower, alpha, unit_of_alpha(reader_));
    if (lower < 0)
      reserve("The factor is negative: a dead load within its bounds alone collapses it.");
    if (!is_true(worst, "lower_proved")) reserve("The lower end is computed, not proved.");
    if (!is_true(worst, "upper_proved")) reserve("The upper end is computed, not proved.");
  }

  const ResultReader& reader_;
  const ResultJson& result_;
  std::string status_;
  Conclusion all_;
};

}  // namespace

Conclusion conclusion(const ResultReader& reader) {
  return Concluding(reader).conclude();
}

}  // namespace kusabi::run
