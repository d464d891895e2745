// Sets of least total cost that together contain all elements: random sets, with the linear
// relaxation solved by GLPK at each node.
//
//   cover 40                      40 elements, 80 sets
//   mpirun -np 2 cover 60 7       60 elements, random seed 7
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <boost/serialization/vector.hpp>
#include <glpk.h>

#include "engine/run.hpp"

namespace engine = kusabi::engine;

struct Cover {
  glp_prob* relaxation = glp_create_prob();  // a column for each set, a row for each element
  enum Choice : signed char { free, out_of, in };

  struct Node {
    std::vector<signed char> sets;  // a Choice for each
    double cost = 0;                // no cover below this node costs less
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& sets& cost;
    }
  };
  using Solution = Node;

  Node root() const {
    return {std::vector<signed char>(static_cast<std::size_t>(glp_get_num_cols(relaxation))), 0};
  }
  double objective(const Solution& solution) const { return solution.cost; }
  double bound(const Node& node) const { return node.cost; }

  void expand(Node&& node, engine::Expansion<Cover>& out) {
    const int sets = glp_get_num_cols(relaxation);
    for (int set = 1; set <= sets; ++set) {
      const int choice = node.sets[set - 1];
      glp_set_col_bnds(relaxation, set, choice == free ? GLP_DB : GLP_FX, choice == in ? 1 : 0, 1);
    }
    glp_std_basis(relaxation);  // the result must depend on the node alone
    glp_smcp silent;
    glp_init_smcp(&silent);
    silent.msg_lev = GLP_MSG_OFF;
    if (glp_simplex(relaxation, &silent) != 0 || glp_get_status(relaxation) != GLP_OPT) return;
    node.cost = std::ceil(glp_get_obj_val(relaxation) - 1e-6);  // costs are whole numbers
    if (out.ruled_out(node.cost)) return;
    int most_fractional = 1;
    const auto fraction = [&](int set) {
      const double value = glp_get_col_prim(relaxation, set);
      return std::min(value, 1 - value);
    };
    for (int set = 2; set <= sets; ++set)
      if (fraction(set) > fraction(most_fractional)) most_fractional = set;
    if (fraction(most_fractional) < 1e-6) {
      for (int set = 1; set <= sets; ++set)
        node.sets[set - 1] = glp_get_col_prim(relaxation, set) > 0.5 ? in : out_of;
      return out.solution(std::move(node));
    }
    for (const auto choice : {in, out_of}) {
      node.sets[most_fractional - 1] = choice;
      out.branch(node);
    }
  }
};

int main(int argc, char** argv) {
  const auto words = engine::own_words(argc, argv);
  const int elements = words.empty() ? 40 : std::stoi(words[0]);
  std::mt19937 random(words.size() > 1 ? std::stoul(words[1]) : 1);
  Cover problem;
  glp_add_rows(problem.relaxation, elements);
  for (int element = 1; element <= elements; ++element)
    glp_set_row_bnds(problem.relaxation, element, GLP_LO, 1, 0);
  for (int set = glp_add_cols(problem.relaxation, 2 * elements); set <= 2 * elements; ++set) {
    std::vector<int> rows{0};  // GLPK counts from 1
    for (int element = 1; element <= elements; ++element)
      if (random() % 10 == 0 || set == element) rows.push_back(element);
    const std::vector<double> ones(rows.size(), 1);
    glp_set_mat_col(problem.relaxation, set, static_cast<int>(rows.size()) - 1, rows.data(),
                    ones.data());
    glp_set_obj_coef(problem.relaxation, set, 5 + random() % 20 + rows.size());
  }
  return engine::run(argc, argv, problem, [](const auto& outcome) {
    for (const auto& found : outcome.solutions) std::cout << "cost " << found.solution.cost << '\n';
  });
}
