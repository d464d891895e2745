// Reader of the actions and of the rule that combines them.
#include "problems/files/sections/actions_section.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/sections/action_combinations.hpp"

namespace kusabi::problems {
namespace {

// Default factors of EN 1990, table A1.2(B), and of (6.10b); national annexes differ.
constexpr double favourable = 1.0;
constexpr double unfavourable = 1.35;
constexpr double variable_factor = 1.5;
constexpr double reduction = 0.85;
constexpr double max_cases = 1000;

// Refusal of loads that no rule combines.
constexpr const char* factor_one =
    "{} beside [[actions]] would have the factor 1 in every combination; expected its forces as an "
    "action, or [[loads]] in place of [[actions]]";

// Limits of the factors of a file.
constexpr double min_factor = 1e-6;
constexpr double max_factor = 1e6;

// In place of factors `true` stands for the defaults.
bool is_true(const toml::node& node) {
  return node.value<bool>().value_or(false);
}

class ActionsReader {
 public:
  explicit ActionsReader(ProblemDraft& draft) : draft_(draft), reader_(draft.reader()) {}

  ActionCombinations read();

 private:
  void refuse_other_loads(const toml::node& actions) const;
  void read_rule(const toml::node& section);
  void read_action(const TomlTable& table);
  void read_factors(const TomlTable& table, Action& action) const;
  void read_permanent(const toml::node& factors, const TomlTable& table, Action& action) const;
  void read_variable(const toml::node& factor, const TomlTable& table, Action& action) const;
  void read_forces(const TomlTable& table, Action& action) const;
  void find_reference();
  void require_reference_in_all_cases() const;
  void limit_cases() const;

  ProblemDraft& draft_;
  const TomlReader& reader_;
  TomlText reference_name_;
  ActionCombinations all_{.reduction = reduction};
};

ActionCombinations ActionsReader::read() {
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
  refuse_other_loads(*actions);
  read_rule(*rule);
  const auto tables = reader_.groups(*actions, "actions");
  all_.actions.reserve(tables.size());
  for (const TomlTable& table : tables) read_action(table);
  find_reference();
  require_reference_in_all_cases();
  limit_cases();
  return std::move(all_);
}

// Loads that no rule combines would have the factor 1 in every combination.
void ActionsReader::refuse_other_loads(const toml::node& actions) const {
  for (const std::string_view other : {"loads", "uncertainty"}) {
    if (const toml::node* section = draft_.section(other); section != nullptr) {
      reader_.fail(*section,
                   fmt::format("{} stands beside [[actions]]; expected all loads of the file to be "
                               "actions, or none",
                               other));
    }
  }
  for (const std::string_view other : {"gravity", "temperature"}) {
    if (const toml::node* entry = draft_.section(other); entry != nullptr)
      reader_.fail(*entry, fmt::format(factor_one, other));
  }
  if (draft_.displaced().empty()) return;
  const auto& name = draft_.node_name(draft_.displaced().begin()->first);
  reader_.fail(actions, fmt::format(factor_one, "the displaced support " + name));
}

void ActionsReader::read_rule(const toml::node& section) {
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
  all_.both_rules = rule.text == "6.10ab";
  if (const toml::node* xi = table.table->get("xi"); xi != nullptr) {
    if (!all_.both_rules)
      reader_.fail(*xi, "xi is a factor of (6.10b); expected rule = \"6.10ab\", or no xi");
    all_.reduction = reader_.positive(*xi, "xi", "factor", min_factor, 1);
  }
  reference_name_ = reader_.text(
      reader_.require(table, "reference",
                      "reference = the name of the action that the load factor multiplies"),
      "reference");
}

void ActionsReader::read_action(const TomlTable& table) {
  reader_.allow_only(
      table, {"name", "permanent", "variable", "psi0", "forces", "exclusive", "either_way"});
  Action action{.name = reader_.text(
                    reader_.require(table, "name", "name = \"...\", of the action"), "name")};
  const auto same = [&](const Action& other) { return other.name.text == action.name.text; };
  if (std::ranges::any_of(all_.actions, same)) {
    reader_.fail(action.name.position,
                 fmt::format("two actions have the name {}; expected different names",
                             support::in_quotes(action.name.text)));
  }
  read_factors(table, action);
  read_forces(table, action);
  all_.actions.push_back(std::move(action));
}

void ActionsReader::read_factors(const TomlTable& table, Action& action) const {
  const toml::node* permanent = table.table->get("permanent");
  const toml::node* variable = table.table->get("variable");
  if ((permanent == nullptr) == (variable == nullptr)) {
    reader_.fail(
        action.name.position,
        fmt::format(
            "the action {} is {} permanent {} variable; expected permanent = [1.0, 1.35], its "
            "favourable and unfavourable factors, or variable = 1.5",
            support::in_quotes(action.name.text), permanent == nullptr ? "neither" : "both",
            permanent == nullptr ? "nor" : "and"));
  }
  if (permanent != nullptr) {
    read_permanent(*permanent, table, action);
  } else {
    read_variable(*variable, table, action);
  }
}

void ActionsReader::read_permanent(const toml::node& factors, const TomlTable& table,
                                   Action& action) const {
  for (const std::string_view key : {"psi0", "exclusive", "either_way"}) {
    if (const toml::node* entry = table.table->get(key); entry != nullptr) {
      reader_.fail(
          *entry,
          fmt::format("{} stands with a permanent action; expected it with a variable one", key));
    }
  }
  if (is_true(factors)) {
    action.permanent = {favourable, unfavourable};
    return;
  }
  const auto both = reader_.vector(factors, "permanent", 2);
  if (!(both(0) >= 0 && both(0) <= both(1))) {
    reader_.fail(
        factors,
        fmt::format("permanent is [{}, {}]; expected the favourable factor, 0 or more, and the "
                    "unfavourable one, no smaller",
                    both(0), both(1)));
  }
  action.permanent = {both(0), both(1)};
}

void ActionsReader::read_variable(const toml::node& factor, const TomlTable& table,
                                  Action& action) const {
  action.factor = is_true(factor)
                      ? variable_factor
                      : reader_.positive(factor, "variable", "factor", min_factor, max_factor);
  const auto& psi0 =
      reader_.require(table, "psi0", "psi0 = the factor of the action where another one leads");
  action.combination = reader_.number(psi0, "psi0");
  if (action.combination != 0 && !(action.combination >= min_factor && action.combination <= 1)) {
    reader_.fail(psi0, fmt::format("psi0 is {}; expected 0, or a factor from {:g} to 1",
                                   action.combination, min_factor));
  }
  if (const toml::node* entry = table.table->get("exclusive"); entry != nullptr) {
    action.alternatives = reader_.text(*entry, "exclusive").text;
  }
  if (const toml::node* entry = table.table->get("either_way"); entry != nullptr) {
    if (!entry->is_boolean())
      reader_.fail(*entry, "either_way is not true or false; expected one of them");
    action.either_way = is_true(*entry);
  }
}

void ActionsReader::read_forces(const TomlTable& table, Action& action) const {
  const auto& forces =
      reader_.require(table, "forces", "forces = [{ nodes = [\"a\", ...], force = [...] }, ...]");
  const auto nodes = [this](const TomlTable& entry) { return draft_.nodes_listed(entry); };
  std::map<std::pair<int, int>, ForceComponent> sums;
  for (const auto& each : force_components(reader_, forces, nodes, draft_.structure().dimension)) {
    const auto [found, is_new] = sums.try_emplace({each.node, each.axis}, each);
    if (!is_new) found->second.force += each.force;
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

void ActionsReader::find_reference() {
  const auto found = std::ranges::find(all_.actions, reference_name_.text,
                                       [](const Action& action) { return action.name.text; });
  const auto name = support::in_quotes(reference_name_.text);
  if (found == all_.actions.end() || found->permanent) {
    reader_.fail(
        reference_name_.position,
        fmt::format("reference names {}, which is {}; expected the name of a variable action", name,
                    found == all_.actions.end() ? "no action" : "permanent"));
  }
  if (!found->alternatives.empty() || found->either_way) {
    reader_.fail(
        reference_name_.position,
        fmt::format(
            "reference names {}, which is {}; expected an action that is in every combination and "
            "has one sense, since the load factor multiplies it",
            name, found->either_way ? "either way" : "exclusive"));
  }
  all_.reference = static_cast<std::size_t>(found - all_.actions.begin());
}

// Where another action leads, the load factor multiplies psi0 times the reference action.
void ActionsReader::require_reference_in_all_cases() const {
  const Action& reference = all_.actions[all_.reference];
  if (reference.combination > 0 || (all_.variable_sets() == 1 && !all_.both_rules)) return;
  reader_.fail(reference_name_.position,
               fmt::format("reference names {}, whose psi0 is 0: where another action leads, the "
                           "load factor would multiply nothing; expected an action with a psi0 "
                           "above 0, or the only variable action with rule = \"6.10\"",
                           support::in_quotes(reference.name.text)));
}

void ActionsReader::limit_cases() const {
  if (all_.cases() <= max_cases) return;
  reader_.fail(reference_name_.position,
               fmt::format("the actions make {:g} load cases; expected at most {:g}", all_.cases(),
                           max_cases));
}

}  // namespace

void read_actions(ProblemDraft& draft) {
  if (draft.section("actions") == nullptr && draft.section("combinations") == nullptr) return;
  ActionsReader(draft).read().add_to(draft.structure());
}

}  // namespace kusabi::problems
