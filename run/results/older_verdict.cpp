// Verdict from the keys that all versions have.
#include <algorithm>

#include <fmt/format.h>

#include "run/results/alpha_unit.hpp"
#include "run/results/result_verdict.hpp"
#include "run/results/sweep_result.hpp"

namespace kusabi::run {
namespace {

class OlderVerdict {
 public:
  explicit OlderVerdict(const ResultReader& reader)
      : reader_(reader),
        problem_(reader.at(reader.all(), "problem")),
        result_(reader.at(reader.all(), "result")),
        status_(reader.text(reader.all(), "status")) {}

  [[nodiscard]] Verdict verdict() const {
    Verdict verdict{.ended = ended_as(reader_, status_)};
    const auto command = reader_.text(reader_.all(), "command");
    if (command == "limit") {
      verdict.answer = load_interval();
    } else if (command == "critical") {
      verdict.answer = critical();
    } else if (command != "sweep") {
      verdict.answer = sticking(command == "rays" ? "extremal ray" : "way");
    } else if (sweeps_loads(reader_)) {
      verdict.answer = load_steps();
    } else {
      verdict.answer = friction_steps();
    }
    return verdict;
  }

  /// Bounds of the least factor that is carried under all admissible loads, of a sweep.
  [[nodiscard]] Bracket min_factor() const {
    const auto& points = reader_.list(result_, "points");
    const auto* const interval =
        points.empty() ? nullptr : ResultReader::find(points.back(), "guaranteed_interval");
    if (interval == nullptr) return {};
    const auto& minimum = reader_.at(*interval, "lower");
    return {bound(minimum, "lower", is_true(minimum, "lower_proved")),
            bound(minimum, "upper", is_true(minimum, "upper_proved"))};
  }

 private:
  [[nodiscard]] static bool has(const ResultJson& object, const char* key) {
    return ResultReader::find(object, key) != nullptr;
  }
  [[nodiscard]] static bool is_true(const ResultJson& object, const char* key) {
    const auto* const value = ResultReader::find(object, key);
    return value != nullptr && value->is_boolean() && value->get<bool>();
  }
  [[nodiscard]] std::uint64_t count(const ResultJson& object, const char* key) const {
    const auto* const value = ResultReader::find(object, key);
    return value == nullptr ? 0 : count(*value);
  }
  [[nodiscard]] std::uint64_t count(const ResultJson& value) const {
    if (!value.is_number_unsigned()) reader_.refuse(value.dump().substr(0, 40) + " is not a count");
    return value.get<std::uint64_t>();
  }
  [[nodiscard]] std::optional<Bound> bound(const ResultJson& object, const char* key,
                                           bool proved) const {
    if (!has(object, key)) return std::nullopt;
    return Bound{reader_.number(object, key), proved ? Standing::proved : Standing::computed};
  }
  [[nodiscard]] bool factor() const {
    return !std::ranges::all_of(reader_.list(problem_, "contact"), [this](const auto& each) {
      return !has(each, "friction") || reader_.number(each, "friction") == 1;
    });
  }

  // Product over the blocks: before 0.2 the count in the file was a 64-bit product that could
  // overflow.
  [[nodiscard]] support::ExactCount count_of_ways() const {
    if (!has(result_, "blocks")) return reader_.count(result_, "count");
    constexpr double safe_digits = 19;  // of a product in 64 bits
    std::vector<std::uint64_t> factors;
    for (const auto& block : reader_.list(result_, "blocks")) {
      const auto cones = reader_.count(block, "count").number();
      if (cones && *cones != 0) factors.push_back(*cones);
    }
    const auto product = support::ExactCount::product(factors);
    return product.log10() < safe_digits ? reader_.count(result_, "count") : product;
  }

  // Nodes closed by cut-offs, of a list of patterns.
  [[nodiscard]] bool has_degenerate_nodes() const {
    const auto* const tree = ResultReader::find(result_, "tree");
    return count(result_, "flat") + count(result_, "marginal") + count(result_, "undecided") > 0 ||
           (tree != nullptr && count(*tree, "faces") + count(*tree, "flat_nodes") > 0);
  }

  [[nodiscard]] Sticking sticking(const char* thing) const {
    const auto* const health = ResultReader::find(result_, "health");
    return {
        .thing = thing,
        .friction = reader_.number(result_, "friction"),
        .factor = factor(),
        .count = count_of_ways(),
        .undecided = count(result_, "marginal") + count(result_, "undecided"),
        .standing = health != nullptr || has_degenerate_nodes() || has(problem_, "rigid_motions")
                        ? Standing::computed
                        : Standing::proved,
        .ambiguous = health != nullptr && count(*health, "doubtful") > 0};
  }

  [[nodiscard]] CriticalBracket critical() const {
    const auto& bracket = reader_.at(result_, "critical_friction");
    const auto& options = reader_.at(reader_.all(), "options");
    CriticalBracket found{.bracket = {bound(bracket, "lower", is_true(bracket, "lower_proved")),
                                      bound(bracket, "upper", is_true(bracket, "upper_proved"))},
                          .factor = factor()};
    auto& lower = found.bracket.lower;
    if (lower && lower->value <= 0) lower.reset();
    constexpr double default_max_friction = 1000;
    found.maximum =
        has(options, "mu_max") ? reader_.number(options, "mu_max") : default_max_friction;
    found.width = has(options, "width") ? reader_.number(options, "width") : 0;
    // A bracket of more than twice the requested width, with rounding.
    constexpr double wide = 2.5;
    const auto& upper = found.bracket.upper;
    found.wide = upper && upper->value - (lower ? lower->value : 0) > wide * found.width;
    found.patterns_open = upper && reader_.list(result_, "patterns").empty();
    return found;
  }

  [[nodiscard]] FrictionSteps friction_steps() const {
    FrictionSteps found{.maximum = reader_.number(reader_.at(reader_.all(), "options"), "mu_max"),
                        .factor = factor(),
                        .open_patterns = reader_.list(result_, "open").size()};
    if (const auto* const last = ResultReader::find(result_, "at_mu_max")) {
      double infeasible = found.maximum;
      for (const char* const key : {"patterns", "open"}) {
        for (const auto& each : reader_.list(result_, key))
          infeasible = std::min(infeasible, reader_.number(each, "lower"));
      }
      found.infeasible = Bound{infeasible, Standing::computed};
      found.count = reader_.count(*last, "known");
      found.open_at_most = count(*last, "open");
    }
    const auto& points = reader_.list(result_, "points");
    found.undecided_points = static_cast<std::uint64_t>(
        std::ranges::count_if(points, [](const auto& each) { return !has(each, "count"); }));
    return found;
  }

  [[nodiscard]] LoadInterval load_interval() const {
    LoadInterval found{.incomplete = status_ == "open"};
    const bool none = status_ == "not-carried";
    const auto* const worst = ResultReader::find(result_, "worst_case");
    if (worst == nullptr) {
      if (none) found.carried_at_none = Standing::proved;
      found.maximum.lower = bound(result_, "nominal", false);
      found.maximum.upper = found.maximum.lower;
      return found;
    }
    LoadRange loads;
    if (has(result_, "alpha")) loads.half_width = reader_.number(result_, "alpha");
    loads.force = unit_of_alpha(reader_);
    found.uncertain = loads;
    if (none) found.carried_at_none = Standing::proved;
    found.if_big_m = has(*worst, "from") && reader_.text(*worst, "from") == "zero-one" &&
                     !is_true(*worst, "proved");
    found.maximum = {bound(*worst, "lower", is_true(*worst, "lower_proved")),
                     bound(*worst, "upper", is_true(*worst, "upper_proved"))};
    return found;
  }

  [[nodiscard]] LoadSteps load_steps() const {
    const auto& points = reader_.list(result_, "points");
    LoadSteps found{
        .nominal = bound(result_, "nominal", false),
        .force = unit_of_alpha(reader_),
        .points = points.size(),
        .points_asked = reader_.list(reader_.at(reader_.all(), "options"), "alpha").size(),
        .open = status_ == "open"};
    if (!found.nominal && status_ == "not-carried") found.nominal_at_none = Standing::proved;
    if (points.empty()) return found;
    const auto& last = points.back();
    found.half_width = reader_.number(last, "alpha");
    const bool proved = is_true(last, "proved");
    if (reader_.text(last, "state") == "not-carried") {
      found.worst_at_none = proved ? Standing::proved : Standing::computed;
    } else {
      found.worst = {bound(last, "lower", proved), bound(last, "upper", proved)};
      found.minimum = min_factor();
    }
    return found;
  }

  const ResultReader& reader_;
  const ResultJson& problem_;
  const ResultJson& result_;
  std::string status_;
};

}  // namespace

Bracket min_factor_of_last_point(const ResultReader& reader) {
  return OlderVerdict(reader).min_factor();
}

Verdict older_verdict(const ResultReader& reader) {
  return OlderVerdict(reader).verdict();
}

}  // namespace kusabi::run
