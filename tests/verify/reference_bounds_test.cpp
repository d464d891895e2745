// Bounds and cuts of random problems, found by another program, compared with the exact values over
// all patterns (tests/reference/cvxopt_bounds.py).
#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {
namespace {

using Json = nlohmann::json;

std::optional<double> number_or_nothing(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Side side_of(const Json& json) {
  return json.get<std::string>() == "contact" ? Side::contact : Side::separated;
}

support::IndexSet set_of(const Json& json) {
  support::IndexSet set;
  for (const int candidate : json) set.insert(candidate);
  return set;
}

struct Case {
  Certificate certificate;
  std::vector<bool> alone;  // of each bound: whether it can be proved without cuts
  Json greatest;            // r_n / s and u_n / s over all patterns, by side and candidate
};

Case read_case(const Json& json) {
  Case result;
  auto& certificate = result.certificate;
  certificate.dimension = json["dimension"];
  for (const auto& row : json["stiffness"])
    for (const double entry : row) certificate.stiffness.push_back(entry);
  const auto m = json["stiffness"].size() / certificate.dimension;
  for (std::size_t i = 0; i < m; ++i) certificate.names.push_back("c" + std::to_string(i));
  certificate.friction.assign(m, json["friction"].get<double>());
  certificate.blocks = {certificate.all_candidates()};
  certificate.theorems.resize(1);
  for (const auto& each : json["bounds"]) {
    certificate.bounds.push_back({.candidate = each["candidate"],
                                  .side = side_of(each["side"]),
                                  .maximum = number_or_nothing(each["most"]),
                                  .numbers = each["numbers"]});
    result.alone.push_back(each["alone"]);
  }
  for (const auto& each : json["cuts"]) {
    certificate.nodes.push_back({.claim = Claim::cut,
                                 .contact = set_of(each["contact"]),
                                 .separated = set_of(each["separated"]),
                                 .numbers = each["numbers"]});
  }
  result.greatest = json["greatest"];
  return result;
}

const std::vector<Case>& cases() {
  static const auto list = [] {
    std::ifstream file(KUSABI_SOURCE_DIR "/tests/reference/cvxopt_bounds.json");
    std::vector<Case> read;
    for (const auto& each : Json::parse(file)) read.push_back(read_case(each));
    return read;
  }();
  return list;
}

std::optional<double> greatest(const Case& problem, Side side, int candidate) {
  return number_or_nothing(problem.greatest[side_name(side)][static_cast<std::size_t>(candidate)]);
}

Side other(Side side) {
  return side == Side::contact ? Side::separated : Side::contact;
}

// Result of a change of one bound's line, with unchanged lines before it.
class Changed {
 public:
  explicit Changed(const Case& problem) : problem_(problem), proof_(problem.certificate) {}

  // Calls `visit(bound, number, refused)` at each bound, where `refused(changed)` is its result.
  template <class Visit>
  void at_each(Visit visit) {
    for (std::size_t k = 0; k < problem_.certificate.bounds.size(); ++k) {
      const auto& bound = problem_.certificate.bounds[k];
      visit(bound, k, [&](const CandidateBound& changed) {
        auto proof = proof_;
        return proof.add_bound(changed).has_value();
      });
      ASSERT_EQ(proof_.add_bound(bound), std::nullopt) << k;
    }
  }

 private:
  const Case& problem_;
  Proof proof_;
};

TEST(ReferenceBounds, AreProvedAndValid) {
  ASSERT_EQ(cases().size(), 6U);
  for (const auto& problem : cases()) {
    Proof proof(problem.certificate);
    for (const auto& bound : problem.certificate.bounds) {
      EXPECT_EQ(proof.add_bound(bound), std::nullopt);
      const auto truth = greatest(problem, bound.side, bound.candidate);
      constexpr double accuracy = 1e-6;  // of the exact values
      if (truth) {
        ASSERT_TRUE(bound.maximum);
        EXPECT_GE(*bound.maximum, *truth - accuracy);
      }
    }
    for (const auto& node : problem.certificate.nodes)
      EXPECT_EQ(proof.proof_result(node).refusal, std::nullopt);
  }
}

TEST(ReferenceBounds, BelowTheExactValueAreRefused) {
  int tried = 0;
  for (const auto& problem : cases()) {
    Changed(problem).at_each([&](const CandidateBound& bound, std::size_t, const auto& refused) {
      const auto truth = greatest(problem, bound.side, bound.candidate);
      if (!truth) return;
      for (const double share : {0.999, 0.9, 0.1}) {
        auto lower = bound;
        lower.maximum = share * *truth;
        EXPECT_TRUE(refused(lower));
        ++tried;
      }
      auto never = bound;
      never.maximum.reset();
      never.numbers.pop_back();
      EXPECT_TRUE(refused(never));
    });
  }
  EXPECT_GT(tried, 50);
}

TEST(ReferenceBounds, OfTheOtherSideAreRefusedUnlessValid) {
  int tried = 0;
  for (const auto& problem : cases()) {
    Changed(problem).at_each([&](const CandidateBound& bound, std::size_t, const auto& refused) {
      auto swapped = bound;
      swapped.side = other(bound.side);
      const auto truth = greatest(problem, swapped.side, bound.candidate);
      if (!truth || (bound.maximum && *bound.maximum > 0.999 * *truth)) return;
      EXPECT_TRUE(refused(swapped));
      ++tried;
    });
  }
  EXPECT_GT(tried, 10);
}

TEST(ReferenceBounds, WithOtherMultipliersAreRefused) {
  int cut = 0;
  for (const auto& problem : cases()) {
    const auto m = problem.certificate.candidates();
    Changed(problem).at_each([&](const CandidateBound& bound, std::size_t, const auto& refused) {
      auto changed = bound;
      if (bound.maximum) {
        changed.numbers.back() = 0;
        EXPECT_TRUE(refused(changed));
        changed.numbers.back() = -1;
        EXPECT_TRUE(refused(changed));
      }
      for (std::size_t k = m; k < 2 * m; ++k) {
        if (bound.numbers[k] == 0) continue;
        ++cut;
        changed = bound;
        changed.numbers[k] = -bound.numbers[k];
        EXPECT_TRUE(refused(changed));
        // It has an influence on all other candidates that may have a reaction, of which there are
        // some.
        changed.numbers[k] = 1e6;
        EXPECT_TRUE(refused(changed));
      }
    });
  }
  EXPECT_GT(cut, 20);
}

TEST(ReferenceBounds, ThatNeedOthersAreRefusedBeforeThem) {
  int tried = 0;
  for (const auto& problem : cases()) {
    for (std::size_t k = 0; k < problem.alone.size(); ++k) {
      if (problem.alone[k]) continue;
      Proof proof(problem.certificate);
      EXPECT_TRUE(proof.add_bound(problem.certificate.bounds[k])) << k;
      ++tried;
    }
  }
  EXPECT_GT(tried, 10);
}

TEST(ReferenceBounds, AreRequiredToProveNodesByCuts) {
  for (const auto& problem : cases()) {
    ASSERT_FALSE(problem.certificate.nodes.empty());
    const Proof none(problem.certificate);
    Proof all(problem.certificate);
    for (const auto& bound : problem.certificate.bounds)
      ASSERT_EQ(all.add_bound(bound), std::nullopt);
    for (auto node : problem.certificate.nodes) {
      EXPECT_TRUE(none.proof_result(node).refusal);
      auto negative = node;
      for (auto& number : negative.numbers) number = -number;
      EXPECT_TRUE(all.proof_result(negative).refusal);
      node.claim = Claim::infeasible;
      node.numbers.resize(problem.certificate.candidates());
      EXPECT_TRUE(all.proof_result(node).refusal);
    }
  }
}

// Gaps of a softer structure are larger, and both are larger with more friction.
TEST(ReferenceBounds, OfAnotherStructureAreRefused) {
  int tried = 0;
  for (auto problem : cases()) {
    for (auto& entry : problem.certificate.stiffness) entry /= 64;
    for (const auto& bound : problem.certificate.bounds) {
      const auto truth = greatest(problem, bound.side, bound.candidate);
      if (bound.side == Side::contact || !bound.maximum || !truth || *truth * 64 < *bound.maximum)
        continue;
      Proof proof(problem.certificate);
      EXPECT_TRUE(proof.add_bound(bound));
      ++tried;
    }
  }
  EXPECT_GE(tried, 5);
}

}  // namespace
}  // namespace kusabi::verify
