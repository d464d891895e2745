// Centres that are far from each other, and the centre next to each candidate.
#include "nodes/wedged/primal/clusters.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace kusabi::wedged {
namespace {

// 1 - the correlation of two normal displacements under uncorrelated reactions.
double distance(const problems::WedgedProblem& block, Eigen::Index i, Eigen::Index j) {
  const Eigen::Index d = block.dimension;
  const auto& f = block.compliance.matrix;
  return 1 - f(d * i, d * j) / std::sqrt(f(d * i, d * i) * f(d * j, d * j));
}

Eigen::Index stiffest(const problems::WedgedProblem& block) {
  Eigen::Index row = 0;
  block.compliance.matrix.diagonal()(Eigen::seq(0, Eigen::last, block.dimension)).minCoeff(&row);
  return row;
}

std::vector<int> cluster_numbers(const problems::WedgedProblem& block, int count) {
  const auto m = static_cast<Eigen::Index>(block.contact_names.size());
  std::vector<int> numbers(static_cast<std::size_t>(m), 0);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(m, std::numeric_limits<double>::infinity());
  Eigen::Index centre = stiffest(block);
  for (int cluster = 0; cluster < count; ++cluster) {
    for (Eigen::Index i = 0; i < m; ++i) {
      const double own = i == centre ? -1 : distance(block, i, centre);
      if (own >= nearest[i]) continue;
      nearest[i] = own;
      numbers[static_cast<std::size_t>(i)] = cluster;
    }
    nearest.maxCoeff(&centre);
  }
  return numbers;
}

}  // namespace

support::IndexSet Clusters::members(const support::IndexSet& clusters) const {
  support::IndexSet candidates;
  for (std::size_t i = 0; i < cluster_of.size(); ++i)
    if (clusters.contains(cluster_of[i])) candidates.insert(static_cast<int>(i));
  return candidates;
}

Clusters clusters_of(const problems::WedgedProblem& block, int count) {
  Clusters result{cluster_numbers(block, count), {}};
  const auto m = static_cast<Eigen::Index>(block.contact_names.size());
  const Eigen::Index d = block.dimension;
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(count);
  for (const int cluster : result.cluster_of) sizes[cluster] += 1;
  Eigen::MatrixXd share = Eigen::MatrixXd::Zero(d * m, d * count);
  Eigen::VectorXd friction = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto number = static_cast<std::size_t>(i);
    const int cluster = result.cluster_of[number];
    for (Eigen::Index k = 0; k < d; ++k) share(d * i + k, d * cluster + k) = 1 / sizes[cluster];
    friction[cluster] += (block.friction.empty() ? 1 : block.friction[number]) / sizes[cluster];
  }
  auto& problem = result.problem;
  problem.dimension = block.dimension;
  problem.compliance.matrix = share.transpose() * block.compliance.matrix * share;
  problem.compliance.matrix =
      ((problem.compliance.matrix + problem.compliance.matrix.transpose()) / 2).eval();
  problem.modes.matrix = share.transpose() * block.modes.matrix;
  problem.modes.error = block.modes.error;
  problem.friction.assign(friction.begin(), friction.end());
  for (int cluster = 0; cluster < count; ++cluster)
    problem.contact_names.push_back(std::to_string(cluster));
  return result;
}

}  // namespace kusabi::wedged
