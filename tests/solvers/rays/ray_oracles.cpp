// Brute-force enumeration of rays, and the Bron-Kerbosch algorithm.
#include "ray_oracles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "dense.hpp"

namespace kusabi::rays::test {
namespace {

// Tolerance far above rounding and far below the numbers of the small examples.
constexpr double tolerance = 1e-9;

struct Inequalities {
  Eigen::MatrixXd friction;  // p and q of each candidate, 2m x 2m
  Eigen::MatrixXd gaps;      // u_n of each, m x 2m
};

void add_if_new(Reactions& list, const Eigen::VectorXd& ray) {
  const bool known = std::any_of(list.begin(), list.end(), [&](const auto& each) {
    return (each - ray).cwiseAbs().maxCoeff() < tolerance;
  });
  if (!known) list.push_back(ray);
}

// Rays of one pattern: `equal` are its equalities, `inequalities` may become equalities.
void add_rays_of_pattern(const Eigen::MatrixXd& equal, const Eigen::MatrixXd& inequalities,
                         const Inequalities& all, Reactions& list) {
  const Eigen::Index size = equal.cols();
  const Eigen::Index more = size - 1 - dense::rank(equal);
  if (more < 0) return;
  std::vector<bool> chosen(static_cast<std::size_t>(inequalities.rows()), false);
  if (more > inequalities.rows()) return;
  std::fill(chosen.begin(), chosen.begin() + more, true);
  do {
    Eigen::MatrixXd system(equal.rows() + more, size);
    system.topRows(equal.rows()) = equal;
    Eigen::Index at = equal.rows();
    for (std::size_t row = 0; row < chosen.size(); ++row) {
      if (chosen[row]) system.row(at++) = inequalities.row(static_cast<Eigen::Index>(row));
    }
    const Eigen::MatrixXd kernel = dense::kernel(system, 1e-11);
    if (kernel.cols() != 1) continue;
    Eigen::VectorXd ray = kernel;
    double normal_sum = 0;
    for (Eigen::Index i = 0; i < size; i += 2) normal_sum += ray(i);
    if (std::abs(normal_sum) < tolerance) continue;
    ray /= normal_sum;
    const bool holds =
        (all.friction * ray).minCoeff() > -tolerance && (all.gaps * ray).minCoeff() > -tolerance;
    if (holds) add_if_new(list, ray);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
}

void expand(const std::vector<std::set<int>>& neighbours, std::set<int> clique,
            std::set<int> candidates, std::set<int> excluded, std::set<std::set<int>>& found) {
  if (candidates.empty() && excluded.empty()) {
    found.insert(clique);
    return;
  }
  const auto joined = [&](const std::set<int>& set, int vertex) {
    std::set<int> result;
    const auto& near = neighbours[static_cast<std::size_t>(vertex)];
    std::set_intersection(set.begin(), set.end(), near.begin(), near.end(),
                          std::inserter(result, result.end()));
    return result;
  };
  int pivot = -1;
  std::size_t maximum = 0;
  for (const auto* set : {&candidates, &excluded}) {
    for (const int vertex : *set) {
      const auto count = joined(candidates, vertex).size() + 1;
      if (count > maximum) {
        maximum = count;
        pivot = vertex;
      }
    }
  }
  const auto beside_pivot = joined(candidates, pivot);
  for (const int vertex : std::set<int>(candidates)) {
    if (beside_pivot.contains(vertex)) continue;
    auto larger = clique;
    larger.insert(vertex);
    expand(neighbours, larger, joined(candidates, vertex), joined(excluded, vertex), found);
    candidates.erase(vertex);
    excluded.insert(vertex);
  }
}

}  // namespace

Reactions rays_by_brute_force(const Eigen::MatrixXd& compliance, std::span<const double> friction) {
  const auto m = static_cast<Eigen::Index>(friction.size());
  Inequalities all{Eigen::MatrixXd::Zero(2 * m, 2 * m), Eigen::MatrixXd(m, 2 * m)};
  for (Eigen::Index i = 0; i < m; ++i) {
    const double mu = friction[static_cast<std::size_t>(i)];
    all.friction.block<2, 2>(2 * i, 2 * i) << mu, -1, mu, 1;
    all.gaps.row(i) = compliance.row(2 * i);
  }
  Reactions list;
  for (unsigned contact = 1; contact < (1U << static_cast<unsigned>(m)); ++contact) {
    std::vector<Eigen::Index> touching;
    std::vector<Eigen::Index> separated;
    for (Eigen::Index i = 0; i < m; ++i) {
      (((contact >> static_cast<unsigned>(i)) & 1U) != 0 ? touching : separated).push_back(i);
    }
    const auto u = static_cast<Eigen::Index>(touching.size());
    Eigen::MatrixXd equal = Eigen::MatrixXd::Zero(u + 2 * (m - u), 2 * m);
    Eigen::MatrixXd inequalities(2 * u + (m - u), 2 * m);
    Eigen::Index at = 0;
    Eigen::Index place = 0;
    for (const Eigen::Index i : touching) {
      equal.row(at++) = all.gaps.row(i);
      inequalities.row(place++) = all.friction.row(2 * i);
      inequalities.row(place++) = all.friction.row(2 * i + 1);
    }
    for (const Eigen::Index i : separated) {
      equal(at++, 2 * i) = 1;
      equal(at++, 2 * i + 1) = 1;
      inequalities.row(place++) = all.gaps.row(i);
    }
    add_rays_of_pattern(equal, inequalities, all, list);
  }
  return list;
}

bool same_rays(const Reactions& a, const Reactions& b) {
  if (a.size() != b.size()) return false;
  return std::all_of(a.begin(), a.end(), [&](const Eigen::VectorXd& ray) {
    return std::any_of(b.begin(), b.end(), [&](const Eigen::VectorXd& other) {
      return (ray - other).cwiseAbs().maxCoeff() < tolerance;
    });
  });
}

std::set<std::set<int>> maximal_cliques(const std::vector<std::set<int>>& neighbours) {
  std::set<int> everything;
  for (std::size_t vertex = 0; vertex < neighbours.size(); ++vertex) {
    everything.insert(static_cast<int>(vertex));
  }
  std::set<std::set<int>> found;
  if (!everything.empty()) expand(neighbours, {}, everything, {}, found);
  return found;
}

Eigen::MatrixXd random_compliance(int m, std::mt19937& bits) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const Eigen::MatrixXd half =
      Eigen::MatrixXd::NullaryExpr(2 * m, 2 * m, [&]() { return entry(bits); });
  return half * half.transpose() + 0.1 * Eigen::MatrixXd::Identity(2 * m, 2 * m);
}

}  // namespace kusabi::rays::test
