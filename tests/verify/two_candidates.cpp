#include "two_candidates.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace kusabi::verify {

std::string numbers(const std::vector<double>& list) {
  std::string text;
  for (const double number : list) text += fmt::format(" {:a}", number);
  return text + "\n";
}

Draft two_candidates(double mu, int dimension) {
  const std::vector<std::vector<double>> plane = {
      {2, 0, -1, 1}, {0, 1, 0, 0}, {-1, 0, 2, -1}, {1, 0, -1, 1}};
  Draft draft;
  draft.header = {"kusabi certificate 5 contact\n",
                  fmt::format("dimension {}\n", dimension),
                  "candidates 2\n",
                  "name a\n",
                  "name b\n",
                  "friction" + numbers({mu, mu}),
                  "blocks 1\n",
                  "block 3\n",
                  "stiffness\n"};
  for (int i = 0; i < 2 * dimension; ++i) {
    std::vector<double> row;
    for (int j = 0; j <= i; ++j) {
      const bool in_plane = i % dimension < 2 && j % dimension < 2;
      const auto at = [&](int k) {
        return static_cast<std::size_t>(2 * (k / dimension) + k % dimension);
      };
      row.push_back(in_plane ? plane[at(i)][at(j)] : i == j ? 1 : 0);
    }
    draft.header.push_back(numbers(row).substr(1));
  }
  draft.header.emplace_back("motions 0\n");
  // Without b: u_nb = 0. With 4 u_nb + r_nb <= r_na + r_nb, a in contact has 4 r_nb + 3 r_na <= 0.
  draft.bounds = {"bound 1 1 separated" + numbers({0.25, 0, 1, 0, 0, 1}),
                  "never 1 0 contact" + numbers({-4, -4, 0, 1}),
                  "bound 1 0 separated" + numbers({1.25, 1, 1, 0, 0, 1})};
  std::vector<double> reactions(static_cast<std::size_t>(dimension - 1), 0);
  reactions[0] = -1;
  draft.nodes = {"cut 1 1 0" + numbers({-4, -4, 0, 1}), "wedged 1 2 1" + numbers(reactions),
                 "infeasible 1 0 3" + numbers({0, 0})};
  return draft;
}

}  // namespace kusabi::verify
