// Data lines of *CONTACT PAIR and *TIE: SURFACE OF THE NODES, OTHER SURFACE.
#include "problems/files/abaqus/abaqus_contact.hpp"

#include <utility>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

/// A parameter that is a length, not the name of a set of nodes.
std::optional<double> length_of(const AbaqusCard& card, std::string_view name) {
  const std::string* value = card.find(name);
  return value == nullptr ? std::nullopt : number_in(*value);
}

std::string upper_value(const AbaqusCard& card, std::string_view name) {
  const std::string* value = card.find(name);
  return value == nullptr ? std::string() : capitals(*value);
}

}  // namespace

bool AbaqusContact::read(AbaqusText& text, const AbaqusCard& card, const AbaqusModel& assembly) {
  const std::string& keyword = card.keyword;
  if (keyword == "*SURFACE INTERACTION") {
    latest_ = &interactions_[capitals(required(text, card, "NAME"))];
    while (text.next_data()) continue;
  } else if (keyword == "*SURFACE BEHAVIOR") {
    const bool tied = upper_value(card, "PRESSURE-OVERCLOSURE") == "TIED";
    if (latest_ != nullptr && tied) latest_->tied = true;
    while (text.next_data()) continue;
  } else if (keyword == "*FRICTION") {
    read_friction(text, card);
  } else if (keyword == "*CONTACT PAIR" || keyword == "*TIE") {
    read_pairs(text, card, assembly);
  } else {
    return false;
  }
  return true;
}

void AbaqusContact::read_friction(AbaqusText& text, const AbaqusCard& card) {
  const bool rough = card.find("ROUGH") != nullptr;
  if (rough) text.warn("*FRICTION, ROUGH has no coefficient and is left out", card.at);
  bool first = true;
  while (text.next_data()) {
    const bool given = !text.line().field(0).empty();
    const double coefficient = given ? text.line().real(0, "a friction coefficient") : 0;
    if (coefficient < 0) text.line().fail(0, "a negative friction coefficient; expected 0 or more");
    if (std::exchange(first, false) && latest_ != nullptr && !rough)
      latest_->friction = coefficient;
  }
}

void AbaqusContact::read_pairs(AbaqusText& text, const AbaqusCard& card,
                               const AbaqusModel& assembly) {
  const bool tie = card.keyword == "*TIE";
  if (card.find("CYCLIC SYMMETRY") != nullptr || card.find("MULTISTAGE") != nullptr) {
    text.warn("*TIE of a cyclic symmetry is left out: the structure is without it", card.at);
    while (text.next_data()) continue;
    return;
  }
  const auto tolerance = length_of(card, tie ? "POSITION TOLERANCE" : "ADJUST");
  while (text.next_data()) {
    const MeshText& line = text.line();
    if (line.fields() < 2 || line.field(1).empty() || line.field(0) == line.field(1)) {
      text.warn(fmt::format("{} of one surface with itself is left out", card.keyword),
                text.here());
      continue;
    }
    const MeshPair pair{assembly.groups.surface_name(line, 0),
                        assembly.groups.surface_name(line, 1),
                        std::nullopt,
                        tie,
                        tolerance,
                        text.here()};
    if (pair.nodes.empty()) {
      line.fail(0,
                "an analytical rigid surface has no nodes; expected the surface of a body first");
    }
    pairs_.push_back({pair, upper_value(card, "INTERACTION")});
  }
}

void AbaqusContact::finish(AbaqusText& text, MeshData& mesh) const {
  for (Pair each : pairs_) {
    const auto interaction = interactions_.find(each.interaction);
    if (interaction != interactions_.end()) {
      each.pair.friction = interaction->second.friction;
      each.pair.tied = each.pair.tied || interaction->second.tied;
    } else if (!each.interaction.empty()) {
      text.warn(fmt::format("interaction {} does not exist, and its pair is without friction",
                            each.interaction),
                each.pair.at);
    }
    mesh.pairs.push_back(std::move(each.pair));
  }
}

}  // namespace kusabi::problems
