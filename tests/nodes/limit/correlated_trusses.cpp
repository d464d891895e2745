// Random trusses, parameter by parameter.
#include "tests/nodes/limit/correlated_trusses.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace kusabi::limit::test {
namespace {

using problems::Load;
using problems::UncertainParameter;

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : bits_(seed) {}
  int below(int count) { return static_cast<int>(bits_() % static_cast<unsigned>(count)); }
  bool one_in(int count) { return below(count) == 0; }
  double between(double from, double to) {
    return from + (to - from) * (static_cast<double>(bits_()) * 0x1p-32);
  }

 private:
  std::mt19937 bits_;
};

/// Builder of a truss, parameter by parameter.
class Maker {
 public:
  explicit Maker(std::uint32_t seed) : draw_(seed) { truss_.dimension = seed % 2 == 0 ? 2 : 3; }

  CorrelatedTruss made(std::uint32_t seed);

 private:
  int d() const { return truss_.dimension; }
  void nodes_and_members();
  void loads();
  UncertainParameter single();
  UncertainParameter spread();
  UncertainParameter turned();
  UncertainParameter combined();
  double reference(int node, int axis) const;
  void add(UncertainParameter parameter);

  Draw draw_;
  problems::Structure truss_;
};

void Maker::nodes_and_members() {
  const int nodes = d() == 2 ? 5 + draw_.below(2) : 6;
  truss_.units = {"m", "kN"};
  truss_.coordinates.resize(d(), nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < d(); ++axis) truss_.coordinates(axis, node) = draw_.between(0, 3);
    truss_.node_names.push_back(std::to_string(node));
    truss_.fixed.push_back(node < d() ? std::array{true, true, true} : std::array<bool, 3>{});
  }
  if (draw_.one_in(4)) truss_.fixed[static_cast<std::size_t>(d())][0] = true;  // a roller
  for (int first = 0; first < nodes; ++first) {
    for (int second = first + 1; second < nodes; ++second) {
      if (draw_.between(0, 1) > 0.85) continue;
      const double tension = draw_.between(0.3, 1);
      const double compression = draw_.one_in(3) ? tension * draw_.between(0.2, 1) : tension;
      truss_.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{tension, compression}});
    }
  }
}

void Maker::loads() {
  const int last = static_cast<int>(truss_.node_names.size()) - 1;
  const auto load = [&](Load::Kind kind, int node, double size) {
    Eigen::VectorXd force(d());
    for (double& each : force) each = draw_.between(-size, size);
    truss_.loads.push_back({kind, node, force});
  };
  load(Load::Kind::reference, last, 1);
  truss_.loads.back().force(0) = 0;  // one free component there has none
  load(Load::Kind::reference, last - 1, 1);
  if (draw_.one_in(2)) load(Load::Kind::dead, last - 2, 0.2);
}

double Maker::reference(int node, int axis) const {
  double sum = 0;
  for (const auto& load : truss_.loads) {
    if (load.kind == Load::Kind::reference && load.node == node) sum += load.force(axis);
  }
  return sum;
}

UncertainParameter Maker::single() {
  const int node = d() + draw_.below(static_cast<int>(truss_.node_names.size()) - d() - 2);
  const double weight = draw_.one_in(2) ? 1 : draw_.between(0.2, 2);
  return {{}, {{node, 1, weight}}};
}

// On all free components of some nodes, without its part along the reference load.
UncertainParameter Maker::spread() {
  UncertainParameter load;
  double work = 0;
  double square = 0;
  const int nodes = static_cast<int>(truss_.node_names.size());
  for (int node = d(); node < nodes; ++node) {
    for (int axis = 0; axis < d(); ++axis) {
      const double referred = reference(node, axis);
      if (referred == 0 && draw_.one_in(2)) continue;
      load.components.push_back({node, axis, draw_.between(-1, 1)});
      work += load.components.back().weight * referred;
      square += referred * referred;
    }
  }
  for (auto& [node, axis, weight] : load.components)
    weight -= work / square * reference(node, axis);
  return load;
}

// The reference load of a node, rotated by 90 degrees.
UncertainParameter Maker::turned() {
  const int node = static_cast<int>(truss_.node_names.size()) - 2;
  const int axis = draw_.below(d() - 1);
  const double size = draw_.between(0.3, 1);
  return {{},
          {{node, axis, size * reference(node, axis + 1)},
           {node, axis + 1, -size * reference(node, axis)}}};
}

// A combination of two parameters, on which it is linearly dependent.
UncertainParameter Maker::combined() {
  UncertainParameter load;
  for (const double share : {draw_.between(-1, 1), draw_.one_in(2) ? 0.0 : draw_.between(-1, 1)}) {
    const auto& other = (*truss_.uncertain)[static_cast<std::size_t>(
        draw_.below(static_cast<int>(truss_.uncertain->size())))];
    for (const auto& [node, axis, weight] : other.components) {
      const auto same = std::ranges::find_if(load.components, [&](const auto& each) {
        return each.node == node && each.axis == axis;
      });
      if (same != load.components.end()) {
        same->weight += share * weight;
      } else {
        load.components.push_back({node, axis, share * weight});
      }
    }
  }
  return load;
}

void Maker::add(UncertainParameter parameter) {
  std::erase_if(parameter.components,
                [](const auto& each) { return std::abs(each.weight) < 1e-6; });
  if (parameter.components.empty()) return;
  const bool plain = parameter.components.size() == 1 && parameter.components[0].weight > 0;
  const bool taken = std::ranges::any_of(*truss_.uncertain, [&](const auto& other) {
    return plain && other.name.empty() && other.components[0].node == parameter.components[0].node;
  });
  if (!plain || taken) parameter.name = "load " + std::to_string(truss_.uncertain->size());
  truss_.uncertain->push_back(std::move(parameter));
}

CorrelatedTruss Maker::made(std::uint32_t seed) {
  truss_.name = "correlated " + std::to_string(seed);
  nodes_and_members();
  loads();
  truss_.uncertain.emplace();
  const auto m = static_cast<std::size_t>(2 + draw_.below(5));
  add(spread());
  while (truss_.uncertain->size() < m) {
    switch (draw_.below(4)) {
      case 0:
        add(single());
        break;
      case 1:
        add(spread());
        break;
      case 2:
        add(turned());
        break;
      default:
        add(combined());
        break;
    }
  }
  return {truss_, draw_.between(0.01, 0.2)};
}

}  // namespace

CorrelatedTruss correlated_truss(std::uint32_t seed) {
  return Maker(seed).made(seed);
}

}  // namespace kusabi::limit::test
