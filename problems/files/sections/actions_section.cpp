// The actions are read first; then each case is written from them.
#include "problems/files/sections/actions_section.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/structure/checks/structure_check.hpp"

namespace kusabi::problems {
namespace {

using Rational = boost::multiprecision::cpp_rational;

// The defaults are those of EN 1990, table A1.2(B), and of (6.10b); national annexes differ.
constexpr double favourable = 1.0;
constexpr double unfavourable = 1.35;
constexpr double variable_factor = 1.5;
constexpr double reduction = 0.85;
constexpr std::size_t most_cases = 1000;

// The range of the factor of an action in one combination.
struct FactorRange {
  double lower;
  double upper;
};

struct Component {
  int node;
  int axis;
  double force;
  support::SourcePosition position;
};

struct Action {
  TomlText name;
  std::optional<FactorRange> permanent{};  // gamma_inf, gamma_sup; nothing: it is variable
  double factor = 0;                       // gamma_Q
  double combination = 0;                  // psi_0
  bool either_way = false;
  std::string alternatives{};  // those with the same text exclude each other
  std::vector<Component> components{};
};

enum class Rule { general, without_leading, reduced };  // (6.10), (6.10a), (6.10b)

// One load case: the variable actions that may act, and the leading one among them.
struct Combination {
  Rule rule;
  const Action* leading;  // null: (6.10a)
  std::vector<const Action*> variable;
  std::string name;
};

double positive(const TomlReader& reader, const toml::node& node, std::string_view called) {
  return reader.positive(node, called, "factor", 1e-6, 1e6);
}

class Actions {
 public:
  explicit Actions(ProblemDraft& draft) : draft_(draft), reader_(draft.reader()) {}

  void read();
  void expand();

 private:
  void read_rule(const toml::node& section);
  void read_action(const TomlTable& table);
  void read_factors(const TomlTable& table, Action& action) const;
  void read_forces(const TomlTable& table, Action& action) const;
  void find_reference();
  [[nodiscard]] std::vector<std::vector<const Action*>> choices() const;
  [[nodiscard]] std::vector<Combination> combinations() const;
  [[nodiscard]] FactorRange range(const Action& action, const Combination& combination) const;
  void add(const Combination& combination);
  void add_bounded(const Action& action, FactorRange factors, const std::string& load_case);
  void add_load(Load::Kind kind, const Component& component, double force,
                const std::string& load_case);

  ProblemDraft& draft_;
  const TomlReader& reader_;
  bool both_rules_ = false;
  double reduction_ = reduction;
  TomlText reference_name_;
  std::vector<Action> actions_;
  const Action* reference_ = nullptr;
};

void Actions::read() {
  const toml::node* rule = draft_.section("combinations");
  const toml::node* actions = draft_.section("actions");
  if (rule == nullptr) {
    reader_.fail(*actions,
                 "[[actions]] stand without [combinations]; expected [combinations] with rule = "
                 "\"6.10\" and reference = the name of a variable action");
  }
  if (actions == nullptr) {
    reader_.fail(*rule,
                 "[combinations] stands without [[actions]]; expected the actions to combine");
  }
  for (const std::string_view other : {"loads", "uncertainty"}) {
    if (const toml::node* section = draft_.section(other); section != nullptr) {
      reader_.fail(*section,
                   fmt::format("{} stands beside [[actions]]; expected all loads of the file to be "
                               "actions, or none",
                               other));
    }
  }
  read_rule(*rule);
  const auto tables = reader_.groups(*actions, "actions");
  actions_.reserve(tables.size());
  for (const TomlTable& table : tables) read_action(table);
  find_reference();
}

void Actions::read_rule(const toml::node& section) {
  const TomlTable table = reader_.table(section, "[combinations]");
  reader_.allow_only(table, {"rule", "reference", "xi"});
  const TomlText rule =
      reader_.text(reader_.require(table, "rule", "rule = \"6.10\" or \"6.10ab\""), "rule");
  if (rule.text != "6.10" && rule.text != "6.10ab") {
    reader_.fail(
        rule.position,
        fmt::format("rule is {}; expected \"6.10\", or \"6.10ab\" for the worse of (6.10a) "
                    "and (6.10b)",
                    support::in_quotes(rule.text)));
  }
  both_rules_ = rule.text == "6.10ab";
  if (const toml::node* xi = table.table->get("xi"); xi != nullptr) {
    if (!both_rules_)
      reader_.fail(*xi, "xi is a factor of (6.10b); expected rule = \"6.10ab\", or no xi");
    reduction_ = reader_.positive(*xi, "xi", "factor", 1e-6, 1);
  }
  reference_name_ = reader_.text(
      reader_.require(table, "reference",
                      "reference = the name of the action that the load factor multiplies"),
      "reference");
}

void Actions::read_action(const TomlTable& table) {
  reader_.allow_only(
      table, {"name", "permanent", "variable", "psi0", "forces", "exclusive", "either_way"});
  Action action{.name = reader_.text(
                    reader_.require(table, "name", "name = \"...\", of the action"), "name")};
  const auto same = [&](const Action& other) { return other.name.text == action.name.text; };
  if (std::ranges::any_of(actions_, same)) {
    reader_.fail(action.name.position,
                 fmt::format("two actions have the name {}; expected names of their own",
                             support::in_quotes(action.name.text)));
  }
  read_factors(table, action);
  read_forces(table, action);
  actions_.push_back(std::move(action));
}

void Actions::read_factors(const TomlTable& table, Action& action) const {
  const auto find = [&](std::string_view key) { return table.table->get(key); };
  const toml::node* permanent = find("permanent");
  const toml::node* variable = find("variable");
  if ((permanent == nullptr) == (variable == nullptr)) {
    reader_.fail(
        action.name.position,
        fmt::format(
            "the action {} is {} permanent {} variable; expected permanent = [1.0, 1.35], its "
            "favourable and unfavourable factors, or variable = 1.5",
            support::in_quotes(action.name.text), permanent == nullptr ? "neither" : "both",
            permanent == nullptr ? "nor" : "and"));
  }
  // `true` stands for the values of table A1.2(B).
  const auto by_default = [](const toml::node& node) { return node.value<bool>().value_or(false); };
  if (permanent != nullptr) {
    for (const std::string_view key : {"psi0", "exclusive", "either_way"}) {
      if (const toml::node* entry = find(key); entry != nullptr) {
        reader_.fail(
            *entry,
            fmt::format("{} stands with a permanent action; expected it with a variable one", key));
      }
    }
    if (by_default(*permanent)) {
      action.permanent = {favourable, unfavourable};
      return;
    }
    const auto factors = reader_.vector(*permanent, "permanent", 2);
    if (!(factors(0) >= 0 && factors(0) <= factors(1))) {
      reader_.fail(
          *permanent,
          fmt::format("permanent is [{}, {}]; expected the favourable factor, 0 or more, and the "
                      "unfavourable one, no smaller",
                      factors(0), factors(1)));
    }
    action.permanent = {factors(0), factors(1)};
    return;
  }
  action.factor =
      by_default(*variable) ? variable_factor : positive(reader_, *variable, "variable");
  action.combination = reader_.positive(
      reader_.require(table, "psi0", "psi0 = the factor of the action where another one leads"),
      "psi0", "factor", 1e-6, 1);
  if (const toml::node* entry = find("exclusive"); entry != nullptr) {
    action.alternatives = reader_.text(*entry, "exclusive").text;
  }
  if (const toml::node* entry = find("either_way"); entry != nullptr) {
    if (!entry->is_boolean())
      reader_.fail(*entry, "either_way is not true or false; expected one of them");
    action.either_way = by_default(*entry);
  }
}

void Actions::read_forces(const TomlTable& table, Action& action) const {
  std::map<std::pair<int, int>, Component> sums;
  const auto& forces =
      reader_.require(table, "forces", "forces = [{ nodes = [\"a\", ...], force = [...] }, ...]");
  for (const toml::node* each : reader_.elements(forces, "forces")) {
    const TomlTable entry = reader_.table(*each, "one of the forces");
    reader_.allow_only(entry, {"nodes", "except", "every", "force"});
    reader_.require(entry, "nodes", "nodes = [\"a\", ...]");
    const int dimension = draft_.structure().dimension;
    const auto force =
        reader_.vector(reader_.require(entry, "force", "force = [...], at each of the nodes"),
                       "the force", dimension);
    for (const ListedNode& listed : draft_.nodes_listed(entry)) {
      for (int axis = 0; axis < dimension; ++axis) {
        const auto at = std::pair(listed.node, axis);
        sums.try_emplace(at, Component{listed.node, axis, 0, listed.position})
            .first->second.force += force(axis);
      }
    }
  }
  for (const auto& [at, component] : sums) {
    if (component.force != 0) action.components.push_back(component);
  }
  if (action.components.empty()) {
    reader_.fail(action.name.position,
                 fmt::format("the action {} is zero; expected a force that is not",
                             support::in_quotes(action.name.text)));
  }
}

void Actions::find_reference() {
  const auto found = std::ranges::find(actions_, reference_name_.text,
                                       [](const Action& action) { return action.name.text; });
  const auto name = support::in_quotes(reference_name_.text);
  if (found == actions_.end() || found->permanent) {
    reader_.fail(
        reference_name_.position,
        fmt::format("reference names {}, which is {}; expected the name of a variable action", name,
                    found == actions_.end() ? "no action" : "permanent"));
  }
  if (!found->alternatives.empty() || found->either_way) {
    reader_.fail(
        reference_name_.position,
        fmt::format(
            "reference names {}, which is {}; expected an action of every combination with one "
            "sense, since the load factor multiplies it",
            name, found->either_way ? "either way" : "exclusive"));
  }
  reference_ = &*found;
}

// The variable actions that act together: one of each set of alternatives, and all others.
std::vector<std::vector<const Action*>> Actions::choices() const {
  std::vector<std::vector<const Action*>> chosen(1);
  std::set<std::string> seen;
  for (const Action& action : actions_) {
    if (action.permanent) continue;
    std::vector<const Action*> options{&action};
    if (!action.alternatives.empty()) {
      if (!seen.insert(action.alternatives).second) continue;
      options.clear();
      for (const Action& other : actions_) {
        if (!other.permanent && other.alternatives == action.alternatives)
          options.push_back(&other);
      }
    }
    std::vector<std::vector<const Action*>> longer;
    longer.reserve(chosen.size() * options.size());
    for (const auto& so_far : chosen) {
      for (const Action* option : options) {
        longer.push_back(so_far);
        longer.back().push_back(option);
      }
    }
    if (longer.size() > most_cases) {
      reader_.fail(action.name.position,
                   fmt::format("exclusive actions make more than {} load cases; expected fewer",
                               most_cases));
    }
    chosen = std::move(longer);
  }
  return chosen;
}

std::vector<Combination> Actions::combinations() const {
  std::vector<Combination> all;
  for (const auto& variable : choices()) {
    std::vector<std::string> alternatives;
    for (const Action* action : variable) {
      if (!action->alternatives.empty()) alternatives.push_back(action->name.text);
    }
    const auto with =
        alternatives.empty() ? "" : fmt::format(", {}", fmt::join(alternatives, ", "));
    if (both_rules_) all.push_back({Rule::without_leading, nullptr, variable, "6.10a" + with});
    for (const Action* leading : variable) {
      const auto rule = both_rules_ ? Rule::reduced : Rule::general;
      all.push_back(
          {rule, leading, variable,
           fmt::format("{} {} leads{}", both_rules_ ? "6.10b" : "6.10", leading->name.text, with)});
    }
  }
  return all;
}

FactorRange Actions::range(const Action& action, const Combination& combination) const {
  if (action.permanent) {
    const auto [lower, upper] = *action.permanent;
    if (combination.rule != Rule::reduced) return {lower, upper};
    const double reduced = reduction_ * upper;
    return {std::min(lower, reduced), std::max(lower, reduced)};
  }
  const double most =
      &action == combination.leading ? action.factor : action.factor * action.combination;
  return {action.either_way ? -most : 0, most};
}

void Actions::add(const Combination& combination) {
  for (const Action& action : actions_) {
    if (action.permanent) add_bounded(action, range(action, combination), combination.name);
  }
  for (const Action* action : combination.variable) {
    const FactorRange factors = range(*action, combination);
    if (action != reference_) {
      add_bounded(*action, factors, combination.name);
      continue;
    }
    for (const Component& each : action->components) {
      add_load(Load::Kind::reference, each, factors.upper * each.force, combination.name);
    }
  }
}

// The nominal load is in the middle of the range, rounded; the half-width is rounded up, so that
// the loads at both ends of the range are within it.
void Actions::add_bounded(const Action& action, FactorRange factors, const std::string& load_case) {
  double largest = 0;
  for (const auto& each : action.components) largest = std::max(largest, std::abs(each.force));
  // A power of two, by which weights and half-width are exact; none for forces of usual size.
  const int exponent = largest > 1e-3 && largest < 1e5 ? 0 : std::ilogb(largest);
  UncertainParameter parameter{action.name.text, {}, {}, {}, load_case};
  Rational half_width = 0;
  std::vector<support::SourcePosition> positions;
  for (const Component& each : action.components) {
    const double middle = (factors.lower / 2 + factors.upper / 2) * each.force;
    add_load(Load::Kind::dead, each, middle, load_case);
    for (const double end : {factors.lower, factors.upper}) {
      const Rational distance = abs(Rational(end) * Rational(each.force) - Rational(middle));
      half_width = std::max(half_width, Rational(distance / abs(Rational(each.force))));
    }
    parameter.components.push_back({each.node, each.axis, std::scalbn(each.force, -exponent)});
    positions.push_back(each.position);
  }
  if (factors.lower == factors.upper) return;
  auto up = static_cast<double>(half_width);
  while (Rational(up) < half_width)
    up = std::nextafter(up, std::numeric_limits<double>::infinity());
  parameter.half_width = std::scalbn(up, exponent);
  Structure& structure = draft_.structure();
  structure.uncertain->push_back(std::move(parameter));
  structure.sources.uncertain.insert(structure.sources.uncertain.end(), positions.begin(),
                                     positions.end());
}

void Actions::add_load(Load::Kind kind, const Component& component, double force,
                       const std::string& load_case) {
  Structure& structure = draft_.structure();
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(structure.dimension);
  vector(component.axis) = force;
  structure.loads.push_back({kind, component.node, std::move(vector), load_case});
  structure.sources.loads.push_back(component.position);
}

void Actions::expand() {
  draft_.structure().uncertain.emplace();
  const auto all = combinations();
  if (all.size() > most_cases) {
    reader_.fail(
        reference_name_.position,
        fmt::format("the actions make {} load cases; expected at most {}", all.size(), most_cases));
  }
  for (const Combination& combination : all) add(combination);
}

}  // namespace

void read_actions(ProblemDraft& draft) {
  if (draft.section("actions") == nullptr && draft.section("combinations") == nullptr) return;
  Actions actions(draft);
  actions.read();
  actions.expand();
}

}  // namespace kusabi::problems
