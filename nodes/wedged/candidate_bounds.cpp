// The bounds, one program at a time.
#include "nodes/wedged/candidate_bounds.hpp"

#include <algorithm>
#include <cstdlib>
#include <cmath>

namespace kusabi::wedged {

using support::IndexSet;

namespace {
const double floor_share = std::getenv("FLOOR") ? std::atof(std::getenv("FLOOR")) : 1e-2;
}

CandidateBounding::CandidateBounding(const problems::WedgedProblem& problem,
                                     std::span<const double> friction, conic::Tolerances tolerances)
    : count_(static_cast<int>(friction.size())),
      least_gap_(0),
      solver_(problem, friction, {.sign = tolerances.sign, .value = std::getenv("VALUE") ? std::atof(std::getenv("VALUE")) : 1e-8, .iterations = tolerances.iterations}, count_ + 1) {
  bounds_.resize(friction.size());
  const Eigen::Index d = problem.dimension;
  for (int i = 0; i < count_; ++i) {
    double most = 0;
    for (int k = 0; k < count_; ++k) {
      if (k == i) continue;
      const auto row = problem.compliance.row(d * i).segment(d * k, d);
      most = std::max(most, row[0] + friction[static_cast<std::size_t>(k)] * row.tail(d - 1).norm());
    }
    bounds_[static_cast<std::size_t>(i)].gap = most / solver_.unit();
  }
  trivial_ = bounds_;
}

double CandidateBounding::improved(int candidate, bool touching) {
  auto& own = bounds_[static_cast<std::size_t>(candidate)];
  double& bound = touching ? own.reaction : own.gap;
  if (bound <= 0) return bound;
  IndexSet contact, separated, free;
  for (int i = 0; i < count_; ++i) {
    const auto& other = bounds_[static_cast<std::size_t>(i)];
    if (i == candidate) (touching ? contact : separated).insert(i);
    else if (other.gap <= 0) contact.insert(i);
    else if (other.reaction <= 0) separated.insert(i);
    else free.insert(i);
  }
  auto cuts = cuts_of(free, bounds_);
  cuts.push_back({.candidate = candidate, .share = -bound, .displacement = touching ? 0.0 : -1.0,
                  .reaction = touching ? -1.0 : 0.0, .level = std::getenv("LEVEL") ? std::atof(std::getenv("LEVEL")) : 1000});
  ++programs_;
  const auto answer = solver_.solve_with(cuts, contact, separated, {.when_dead = false, .when_alive = false});
  if (answer.upper < -1e-9) { }
  const double most = bound + solver_.most_of(cuts.size() - 1);
  return most;
}

void CandidateBounding::sweep() {
  const int group = std::getenv("GROUP") ? std::atoi(std::getenv("GROUP")) : 1;
  for (int first = 0; first < count_; first += group) {
  std::vector<double> found2;
  for (int i = first; i < std::min(count_, first + group); ++i) { found2.push_back(improved(i, false)); found2.push_back(improved(i, true)); }
  for (int i = first; i < std::min(count_, first + group); ++i) {
    auto& own = bounds_[static_cast<std::size_t>(i)];
    const auto& trivial = trivial_[static_cast<std::size_t>(i)];
    for (const bool touching : {false, true}) {
      double& bound = touching ? own.reaction : own.gap;
      const double least = floor_share * (touching ? trivial.reaction : trivial.gap);
      const double found = found2[static_cast<std::size_t>(2 * (i - first) + touching)];
      if (found < 0) bound = -1;
      else if (found < bound) bound = std::max(found, std::min(bound, least));
    }
  }
  }
  return;
  for (int i = 0; i < count_; ++i) {
    auto& own = bounds_[static_cast<std::size_t>(i)];
    const auto& trivial = trivial_[static_cast<std::size_t>(i)];
    for (const bool touching : {false, true}) {
      double& bound = touching ? own.reaction : own.gap;
      const double least = floor_share * (touching ? trivial.reaction : trivial.gap);
      const double found = improved(i, touching);
      if (found < 0) bound = -1;
      else if (found < bound) bound = std::max(found, std::min(bound, least));
    }
  }
}

std::vector<conic::Cut> cuts_of(const IndexSet& free, std::span<const CandidateBounds> bounds) {
  std::vector<conic::Cut> cuts;
  for (const int i : free) {
    const auto& own = bounds[static_cast<std::size_t>(i)];
    if (own.gap <= 0 || own.reaction <= 0) continue;
    const double scale = 1 / std::max({1.0, 1 / own.gap, 1 / own.reaction});
    cuts.push_back({.candidate = i, .share = scale, .displacement = scale / own.gap,
                    .reaction = scale / own.reaction, .level = scale});
  }
  return cuts;
}

}  // namespace kusabi::wedged
