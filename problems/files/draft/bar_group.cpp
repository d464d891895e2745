// Stiffness and yield forces from either set of keys.
#include "problems/files/draft/bar_group.hpp"

#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "problems/files/draft/body_properties.hpp"
#include "problems/structure/checks/structure_check.hpp"

namespace kusabi::problems {
namespace {

class BarKeys {
 public:
  BarKeys(const TomlReader& reader, const TomlTable& group)
      : reader_(reader),
        group_(group),
        whole_stiffness_(find("EA")),
        modulus_(find("E")),
        area_(find("A")),
        force_(find("yield")),
        stress_(find("fy")),
        buckling_(find("buckling")),
        density_(find("density")) {}

  [[nodiscard]] BarGroup read() const;

 private:
  [[nodiscard]] const toml::node* find(std::string_view key) const {
    return group_.table->get(key);
  }
  void refuse_both_and_half() const;
  [[nodiscard]] double positive(const toml::node& node, std::string_view called,
                                std::string_view what) const;
  [[nodiscard]] double axial_stiffness() const;
  [[nodiscard]] YieldForces pair(const toml::node& node, std::string_view called,
                                 std::string_view what) const;
  [[nodiscard]] std::optional<double> residual(const TomlTable& table) const;
  [[nodiscard]] YieldForces stresses() const;
  [[nodiscard]] CompressedBar compressed() const;

  const TomlReader& reader_;
  const TomlTable& group_;
  const toml::node* whole_stiffness_;
  const toml::node* modulus_;
  const toml::node* area_;
  const toml::node* force_;
  const toml::node* stress_;
  const toml::node* buckling_;
  const toml::node* density_;
};

void BarKeys::refuse_both_and_half() const {
  if (whole_stiffness_ != nullptr && modulus_ != nullptr) {
    reader_.fail(*modulus_, "E stands beside EA; expected EA, or E and A");
  }
  if (force_ != nullptr && stress_ != nullptr) {
    reader_.fail(*stress_, "fy stands beside yield; expected yield, or fy and A");
  }
  if (area_ == nullptr && modulus_ != nullptr) {
    reader_.fail(*modulus_, "E stands without A; expected A = an area beside it, or EA");
  }
  if (area_ == nullptr && stress_ != nullptr) {
    reader_.fail(*stress_, "fy stands without A; expected A = an area beside it, or yield");
  }
  if (area_ == nullptr && density_ != nullptr) {
    reader_.fail(*density_, "density stands without A; expected E and A in place of EA");
  }
  if (area_ != nullptr && modulus_ == nullptr && stress_ == nullptr) {
    reader_.fail(*area_, "A stands alone; expected E, for E A, or fy, for A fy, beside it");
  }
}

double BarKeys::positive(const toml::node& node, std::string_view called,
                         std::string_view what) const {
  return reader_.positive(node, called, what, smallest_magnitude, largest_magnitude);
}

// Zero stands for "not given", since valid numbers are positive.
double BarKeys::axial_stiffness() const {
  if (modulus_ != nullptr) {
    return positive(*modulus_, "E", "modulus") * positive(*area_, "A", "area");
  }
  if (whole_stiffness_ == nullptr) return 0;
  const double value = reader_.number(*whole_stiffness_, "EA");
  if (value == 0) reader_.fail(*whole_stiffness_, axial_stiffness_fault(0));
  return value;
}

// One number for both, or one each for tension and compression.
YieldForces BarKeys::pair(const toml::node& node, std::string_view called,
                          std::string_view what) const {
  if (node.is_number()) {
    const double both = reader_.number(node, called);
    return {both, both};
  }
  if (!node.is_table()) {
    reader_.fail(node, fmt::format("{0} is neither a number nor a table; expected {0} = 800 or "
                                   "{0} = {{ tension = 800, compression = 500 }}",
                                   called));
  }
  const TomlTable table = reader_.table(node, called);
  if (called == "yield") {
    reader_.allow_only(table, {"tension", "compression", "residual"});
  } else {
    reader_.allow_only(table, {"tension", "compression"});
  }
  const auto number = [&](std::string_view key) {
    return reader_.number(reader_.require(table, key, what), key);
  };
  return {number("tension"), number("compression")};
}

// The share of the compression strength that remains after buckling.
std::optional<double> BarKeys::residual(const TomlTable& table) const {
  const toml::node* entry = table.table->get("residual");
  if (entry == nullptr) return {};
  const double share = reader_.number(*entry, "residual");
  if (!(share >= 0 && share <= 1)) {
    reader_.fail(*entry, fmt::format("residual is {:g}; expected a share of the compression "
                                     "strength, between 0 and 1",
                                     share));
  }
  return share;
}

YieldForces BarKeys::stresses() const {
  const auto stress = pair(*stress_, "fy", "a yield stress");
  for (const double each : {stress.tension, stress.compression}) {
    if (each < 0) {
      reader_.fail(*stress_, fmt::format("a yield stress is {:g}; expected 0 or more", each));
    }
  }
  return stress;
}

CompressedBar BarKeys::compressed() const {
  if (modulus_ == nullptr || stress_ == nullptr || !stress_->is_number()) {
    reader_.fail(*buckling_,
                 "buckling stands without E, A and fy; expected all three, fy as one number");
  }
  const TomlTable table = reader_.table(*buckling_, "buckling");
  reader_.allow_only(table, {"curve", "i", "length", "gamma_M1", "residual"});
  const auto number = [&](std::string_view key, std::string_view what, double otherwise) {
    const toml::node* entry = table.table->get(key);
    return entry == nullptr ? otherwise : reader_.positive(*entry, key, what, 1e-6, 1e6);
  };
  const TomlText curve = reader_.text(reader_.require(table, "curve", "curve = \"a\""), "curve");
  const auto imperfection = imperfection_factor(curve.text);
  if (!imperfection) {
    reader_.fail(curve.position,
                 fmt::format("curve is {}; expected a0, a, b, c or d (EN 1993-1-1, table 6.1)",
                             support::in_quotes(curve.text)));
  }
  const double radius = positive(reader_.require(table, "i", "i = the radius of gyration"), "i",
                                 "radius of gyration");
  return {.modulus = positive(*modulus_, "E", "modulus"),
          .area = positive(*area_, "A", "area"),
          .yield_stress = positive(*stress_, "fy", "yield stress"),
          .radius = radius,
          .length = number("length", "factor of the length", 1),
          .imperfection = *imperfection,
          .partial = number("gamma_M1", "partial factor", 1)};
}

BarGroup BarKeys::read() const {
  refuse_both_and_half();
  const auto position = [&](const toml::node* entry, const toml::node* other) {
    if (entry == nullptr) entry = other;
    return reader_.position(entry == nullptr ? *group_.table : *entry);
  };
  BarGroup bars{{}, position(whole_stiffness_, modulus_), position(force_, stress_)};
  bars.bar.axial_stiffness = axial_stiffness();
  const auto [density, expansion] = body_properties(reader_, group_);
  if (density != 0) bars.bar.mass = density * positive(*area_, "A", "area");
  bars.bar.expansion = expansion;
  if (force_ != nullptr) {
    bars.bar.yield = pair(*force_, "yield", "a yield force");
    if (force_->is_table()) bars.residual = residual(reader_.table(*force_, "yield"));
  }
  if (stress_ != nullptr) {
    const double area = positive(*area_, "A", "area");
    const auto stress = stresses();
    bars.bar.yield = YieldForces{area * stress.tension, area * stress.compression};
  }
  if (buckling_ != nullptr) {
    bars.compressed = compressed();
    bars.residual = residual(reader_.table(*buckling_, "buckling"));
  }
  return bars;
}

}  // namespace

std::optional<YieldForces> BarGroup::yield_at(double length) const {
  auto forces = bar.yield;
  if (compressed) {
    CompressedBar here = *compressed;
    here.length *= length;
    forces->compression = buckling_resistance(here);
  }
  if (residual) forces->residual = forces->compression * *residual;
  return forces;
}

BarGroup bars_in(const TomlReader& reader, const TomlTable& group) {
  return BarKeys(reader, group).read();
}

}  // namespace kusabi::problems
