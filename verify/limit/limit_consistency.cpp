// Members are compared first, then loads.
#include "verify/limit/limit_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "support/one_line.hpp"
#include "verify/limit/exact_truss.hpp"
#include "verify/structure/assembly.hpp"

namespace kusabi::verify {
namespace {

std::string bar_name(const Structure& structure, const Bar& bar) {
  return structure.names[bar.first] + "-" + structure.names[bar.second];
}

// The middle of an enclosure, and its distance from the bounds.
Approximate middle(const Enclosure& value) {
  const auto sum = (value.lower() + value.upper()).scaled(-1);
  return {sum, value.distance(sum)};
}

// The exact column of the bar of a member; nothing if the recorded one is not a rounding of it.
std::optional<std::vector<std::pair<std::size_t, Approximate>>> true_column(
    const Sparse& column, const Structure& structure, const Freedom& freedom, const Bar& bar) {
  std::map<std::size_t, double> recorded;
  for (const auto& [place, value] : column) {
    if (!recorded.emplace(place, value).second) return {};
  }
  const auto cosines = direction(structure, bar).cosines;
  std::vector<std::pair<std::size_t, Approximate>> exact;
  for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
    if (!cosines[axis].finite()) return {};
    for (const auto node : {bar.first, bar.second}) {
      const auto number = freedom.number[node][axis];
      if (number == Freedom::none) continue;
      const auto entry = node == bar.first ? -cosines[axis] : cosines[axis];
      const auto found = recorded.find(number);
      const double value = found == recorded.end() ? 0.0 : found->second;
      if (found != recorded.end()) recorded.erase(found);
      if (entry.distance(Dyadic(value)) > Dyadic(cosine_tolerance)) return {};
      if (!entry.is_zero()) exact.emplace_back(number, middle(entry));
    }
  }
  for (const auto& [place, value] : recorded) {
    if (value != 0) return {};
  }
  return exact;
}

// The exact load. The recorded one is a sum of forces in double precision, with few rounding errors
// relative to their sizes. @return nothing if it is not
std::optional<std::vector<Approximate>> true_load(const std::vector<double>& recorded,
                                                  std::vector<Force> forces,
                                                  const Structure& structure,
                                                  const Freedom& freedom) {
  constexpr long roundings = -40;
  const auto load = sum_of<Enclosure>(forces, structure, freedom);
  for (auto& force : forces) {
    for (double& component : force.components) component = std::abs(component);
  }
  const auto sizes = sum_of<Enclosure>(forces, structure, freedom);
  std::vector<Approximate> exact;
  for (std::size_t e = 0; e < load.size(); ++e) {
    if (load[e].distance(Dyadic(recorded[e])) > sizes[e].upper().scaled(roundings)) return {};
    exact.push_back(middle(load[e]));
  }
  return exact;
}

/// Half-width and name of a recorded column.
struct Recorded {
  double half_width = 0;
  std::string name;
};

// Columns of T, each by displacement.
using Columns = std::multimap<Sparse, Recorded>;

Columns columns_of(const LimitCertificate& certificate) {
  Columns columns;
  for (std::size_t j = 0; j < certificate.uncertain.size(); ++j) {
    auto column = certificate.uncertain[j];
    std::ranges::sort(column);
    columns.emplace(std::move(column),
                    Recorded{certificate.alpha[j],
                             certificate.names.empty() ? std::string() : certificate.names[j]});
  }
  return columns;
}

// Removes a column from those of a certificate, preferably one with the given name; of equal
// columns any one. @param half_width nothing: any
// @return its half-width, if there is such a column
std::optional<double> take(Columns& columns, Sparse column, const std::string& name,
                           std::optional<double> half_width) {
  std::ranges::sort(column);
  const auto [first, last] = columns.equal_range(column);
  auto found = last;
  for (auto each = first; each != last; ++each) {
    if (half_width && each->second.half_width != *half_width) continue;
    if (found == last || each->second.name == name) found = each;
    if (found->second.name == name) break;
  }
  if (found == last) return {};
  const double taken = found->second.half_width;
  columns.erase(found);
  return taken;
}

std::string load_name(const Structure& structure, std::size_t parameter) {
  return structure.load_names.empty() ? std::string() : structure.load_names[parameter];
}

// The columns of T. Loads on a support act on the ground. Without uncertain loads in the file, one
// for each displacement whose loads have the sum zero in double precision.
std::vector<Sparse> uncertain_columns(const Structure& structure, const Freedom& freedom) {
  std::vector<Sparse> columns;
  if (structure.uncertain) {
    for (const auto& parameter : *structure.uncertain) {
      auto& column = columns.emplace_back();
      for (const auto& [node, axis, weight] : parameter) {
        const auto number = freedom.number[node][axis];
        if (number != Freedom::none) column.emplace_back(number, weight);
      }
    }
  } else {
    const auto dead = sum_of<double>(structure.dead, structure, freedom);
    const auto reference = sum_of<double>(structure.reference, structure, freedom);
    for (std::size_t e = 0; e < freedom.count; ++e) {
      if (dead[e] == 0 && reference[e] == 0) columns.push_back({{e, 1.0}});
    }
  }
  return columns;
}

// The half-width of each column of a truss, or the fault of the recorded ones. Equal columns with
// specified half-widths are matched first.
std::variant<std::vector<double>, std::string> half_widths_of(const LimitCertificate& certificate,
                                                              const Structure& structure,
                                                              const std::vector<Sparse>& columns) {
  const std::string others = "the recorded uncertain loads are not those of the truss";
  auto recorded = columns_of(certificate);
  const auto in_file = [&](std::size_t j) {
    return structure.half_widths.empty() ? std::nullopt : structure.half_widths[j];
  };
  std::vector<double> half_widths(columns.size());
  for (const bool said : {true, false}) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (in_file(j).has_value() != said) continue;
      const auto name = support::on_one_line(load_name(structure, j));
      if (const auto taken = take(recorded, columns[j], name, in_file(j))) {
        half_widths[j] = *taken;
        continue;
      }
      return said && take(recorded, columns[j], name, {})
                 ? "the recorded half-width of an uncertain load is not that of the truss"
                 : others;
    }
  }
  if (!recorded.empty()) return others;
  return half_widths;
}

std::optional<std::string> other_bars(const LimitCertificate& certificate,
                                      const Structure& structure, const Freedom& freedom,
                                      LimitTruss& truss) {
  for (std::size_t i = 0; i < structure.bars.size(); ++i) {
    const auto& bar = structure.bars[i];
    if (certificate.tension[i] != bar.tension || certificate.compression[i] != bar.compression) {
      return "the recorded yield forces of member " + bar_name(structure, bar) +
             " are not those of the truss";
    }
    auto column = true_column(certificate.columns[i], structure, freedom, bar);
    if (!column) {
      return "the recorded direction of member " + bar_name(structure, bar) +
             " is not that of the truss";
    }
    truss.columns.push_back(*std::move(column));
    truss.members.push_back(bar_name(structure, bar));
  }
  return {};
}

}  // namespace

std::variant<LimitTruss, std::string> limit_consistency(const LimitCertificate& certificate,
                                                        const Structure& structure) {
  const Freedom freedom(structure);
  if (!freedom.masters.empty() || !structure.ties.empty())
    return "the structure has multi-point constraints, inclined supports or contact pairs; "
           "limit analysis does not support these";
  if (certificate.displacements != freedom.count ||
      certificate.members() != structure.bars.size()) {
    return "the certificate has " + std::to_string(certificate.displacements) +
           " displacements and " + std::to_string(certificate.members()) +
           " members, the truss has " + std::to_string(freedom.count) + " and " +
           std::to_string(structure.bars.size());
  }
  LimitTruss truss;
  if (auto why = other_bars(certificate, structure, freedom, truss)) return *why;
  auto true_dead = true_load(certificate.dead, structure.dead, structure, freedom);
  auto true_reference = true_load(certificate.reference, structure.reference, structure, freedom);
  if (!true_dead) return "the recorded dead load is not that of the truss";
  if (!true_reference) return "the recorded reference load is not that of the truss";
  truss.dead = *std::move(true_dead);
  truss.reference = *std::move(true_reference);
  auto half_widths = half_widths_of(certificate, structure, uncertain_columns(structure, freedom));
  if (auto* const why = std::get_if<std::string>(&half_widths)) return std::move(*why);
  truss.half_widths = std::get<std::vector<double>>(std::move(half_widths));
  return truss;
}

Structure with_reversed_reference(Structure structure) {
  for (auto& force : structure.reference) {
    for (double& component : force.components) component = -component;
  }
  return structure;
}

}  // namespace kusabi::verify
