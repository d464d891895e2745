// Names of members from those of nodes.
#include "run/limit/loss_options.hpp"

#include <cstddef>
#include <set>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "run/command/listed_names.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;

// Names of the nodes and members of a truss, and the members that each stands for.
class MemberNames {
 public:
  MemberNames(const problems::Structure& truss, const LimitProblem& problem);

  std::vector<std::string> names;
  std::vector<std::vector<int>> members;  ///< of each name

 private:
  void add(const std::string& name, int member);

  std::unordered_map<std::string, std::size_t> places_;
};

MemberNames::MemberNames(const problems::Structure& truss, const LimitProblem& problem) {
  std::vector<std::vector<std::string>> of_node;
  for (const auto& name : truss.node_names) of_node.push_back({name});
  for (const auto& [name, node] : truss.more_names)
    of_node[static_cast<std::size_t>(node)].push_back(name);
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    for (const auto& first : of_node[static_cast<std::size_t>(bar.first)]) {
      for (const auto& second : of_node[static_cast<std::size_t>(bar.second)]) {
        for (const auto& name : {first, second, first + '-' + second, second + '-' + first})
          add(name, i);
      }
    }
  }
}

void MemberNames::add(const std::string& name, int member) {
  const auto [place, is_new] = places_.try_emplace(name, names.size());
  if (is_new) {
    names.push_back(name);
    members.emplace_back();
  }
  members[place->second].push_back(member);
}

// Members that are named, and those at named nodes.
std::vector<int> kept_members(const problems::Structure& truss, const LimitProblem& problem,
                              const std::string& text) {
  const MemberNames all(truss, problem);
  const auto [found, unknown] = names_in_list(text, all.names);
  if (!unknown.empty()) {
    throw WrongInput(fmt::format(
        "--keep '{}': no such node or member; expected names separated by blanks or commas, a "
        "member as NODE-NODE",
        unknown));
  }
  std::set<int> members;
  for (const auto i : found) members.insert(all.members[i].begin(), all.members[i].end());
  return {members.begin(), members.end()};
}

}  // namespace

void LossOptions::describe(OptionTable& table) {
  table.number(
      "--lose", &maximum, between(1, 1000),
      "least load factor after the loss of up to this number of members; with half-widths of "
      "uncertain loads, also over these loads");
  table
      .number("--at-least", &at_least, Range{},
              "decide whether the limit load factor is at least this after every such loss")
      .needs("--lose");
  table
      .text("--keep", kept, "NAMES",
            "members (NODE-NODE) that cannot be lost, and nodes all of whose members cannot; "
            "separated by blanks or commas")
      .needs("--lose");
  table
      .number("--sudden", &sudden, between(1, 100),
              "dynamic factor by which a sudden loss multiplies all loads: 1 for a slow loss or "
              "unlimited ductility, 2 for an elastic structure")
      .needs("--lose");
}

std::optional<limit::LossParameters> LossOptions::parameters(const problems::Structure& truss,
                                                             const LimitProblem& problem) const {
  if (maximum == 0) return std::nullopt;
  return limit::LossParameters{maximum, at_least, kept_members(truss, problem, kept), sudden};
}

}  // namespace kusabi::run
