// Cost of one node of the wedged problem: microseconds and iterations of the cone solver per node
// program, for a certified sign and for full accuracy of the value.
//
//   bench_cones INSTANCE...                  table, one row per instance
//   bench_cones --json INSTANCE...           table, and data for bench/cones.py
//   bench_cones --walk ROWS DEPTH BAYS MU    writes an instance
//   bench_cones --equations                  normal equations of random columns: GFlop/s by size
//
// An instance is a space truss (problems/families/space_truss) with nodes of its tree from random
// walks: 200, or 24 with more than 60 candidates. The best of several rounds counts; run it on an
// idle machine.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "problems/families/space_truss.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/node_solver.hpp"
#include "solvers/conic/normal_equations.hpp"
#include "solvers/conic/pack.hpp"
#include "support/index_set.hpp"

namespace {

using namespace kusabi;
using conic::Sign;
using nlohmann::json;

constexpr int dimension = 3;

// Instances of more than `max_small` candidates have fewer nodes and fewer rounds.
constexpr int max_small = 60;
constexpr std::size_t node_count = 200, large_node_count = 24;
constexpr int rounds = 15, large_rounds = 3;

using support::IndexSet;

struct Node {
  IndexSet contact, separated;
};

// A set in the format of instances: hexadecimal digits, or decimals where they suffice.
IndexSet set_of(const json& word) {
  if (word.is_number()) return IndexSet(word.get<std::uint64_t>());
  const auto digits = word.get<std::string>();
  IndexSet set;
  for (std::size_t place = 0; place < digits.size(); ++place) {
    const int digit = std::stoi(digits.substr(digits.size() - 1 - place, 1), nullptr, 16);
    for (int bit = 0; bit < 4; ++bit)
      if ((digit >> bit & 1) != 0) set.insert(static_cast<int>(4 * place) + bit);
  }
  return set;
}

json word_of(const IndexSet& set, int m) {
  if (m <= max_small) return set.word(0);
  return support::hexadecimal(set);
}

struct Instance {
  problems::SpaceTrussSize size;
  double friction;
  std::vector<Node> nodes;
};

Instance read(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  const auto data = json::parse(stream);
  Instance instance{{data.at("rows"), data.at("depth"), data.at("bays")}, data.at("friction"), {}};
  for (const auto& node : data.at("nodes"))
    instance.nodes.push_back({set_of(node.at(0)), set_of(node.at(1))});
  return instance;
}

// F of the truss, scaled as in the tree.
Eigen::MatrixXd scaled_compliance(const problems::SpaceTrussSize& size) {
  const auto problem = problems::wedged_problem(checked(problems::space_truss(size)));
  return problem.compliance.matrix / problems::mean_normal_compliance(problem);
}

conic::NodeSolver<dimension> solver_of(const Eigen::MatrixXd& compliance, double friction) {
  const auto m = static_cast<std::size_t>(compliance.rows()) / dimension;
  return {compliance, std::vector<double>(m, friction)};
}

// Nodes of random walks from the root: a walk ends at an infeasible node or at a leaf. It branches
// where u_n r_n is largest (Remark 5.5 of the wedged paper) and takes a random child.
std::vector<Node> walked_nodes(conic::NodeSolver<dimension>& solver, int m) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(m));
  const IndexSet all = IndexSet::below(m);
  std::vector<Node> nodes;
  Node node;
  while (nodes.size() < (m <= max_small ? node_count : large_node_count)) {
    nodes.push_back(node);
    const IndexSet open = all - (node.contact | node.separated);
    if (solver.solve(node.contact, node.separated).sign == Sign::infeasible || open.empty()) {
      node = {};
      continue;
    }
    int split = 0;
    double maximum = -1;
    for (const int i : open) {
      const Eigen::Index normal = dimension * i;
      const double product = solver.displacement()[normal] * solver.reaction()[normal];
      if (product <= maximum) continue;
      maximum = product;
      split = i;
    }
    (generator() % 2 == 0 ? node.contact : node.separated).insert(split);
  }
  return nodes;
}

struct Figures {
  double microseconds = 1e300, iterations = 0;
  int feasible = 0, infeasible = 0, marginal = 0;
};

Figures measure(conic::NodeSolver<dimension>& solver, const std::vector<Node>& nodes,
                conic::StopEarly stop) {
  Figures best;
  const int turns = nodes.size() == node_count ? rounds : large_rounds;
  for (int round = 0; round < turns; ++round) {
    Figures figures;
    const auto start = std::chrono::steady_clock::now();
    for (const Node& node : nodes) {
      const auto answer = solver.solve(node.contact, node.separated, stop);
      figures.iterations += answer.iterations;
      ++(answer.sign == Sign::feasible     ? figures.feasible
         : answer.sign == Sign::infeasible ? figures.infeasible
                                           : figures.marginal);
    }
    const std::chrono::duration<double, std::micro> elapsed =
        std::chrono::steady_clock::now() - start;
    figures.microseconds = elapsed.count() / static_cast<double>(nodes.size());
    figures.iterations /= static_cast<double>(nodes.size());
    if (figures.microseconds < best.microseconds) best = figures;
  }
  return best;
}

constexpr conic::StopEarly never{.when_infeasible = false, .when_feasible = false};

void show(const Instance& instance) {
  auto solver = solver_of(scaled_compliance(instance.size), instance.friction);
  const auto full = measure(solver, instance.nodes, never);
  const auto sign = measure(solver, instance.nodes, {});
  fmt::print("{:>3} | {:>8.1f} {:>11.1f} | {:>8.1f} {:>11.1f} | {:>5} {:>4} {:>8}\n",
             instance.size.rows * instance.size.depth, full.microseconds, full.iterations,
             sign.microseconds, sign.iterations, sign.feasible, sign.infeasible, sign.marginal);
}

json data_of(const Instance& instance) {
  const auto compliance = scaled_compliance(instance.size);
  auto solver = solver_of(compliance, instance.friction);
  json data{{"friction", instance.friction}};
  for (const auto& row : compliance.rowwise())
    data["compliance"].push_back(std::vector<double>(row.begin(), row.end()));
  for (const auto& [contact, separated] : instance.nodes) {
    const int m = instance.size.rows * instance.size.depth;
    data["nodes"].push_back({word_of(contact, m), word_of(separated, m)});
    const auto answer = solver.solve(contact, separated, never);
    data["brackets"].push_back({answer.lower, answer.upper});
  }
  const auto full = measure(solver, instance.nodes, never);
  const auto sign = measure(solver, instance.nodes, {});
  data["full"] = {full.microseconds, full.iterations};
  data["sign"] = {sign.microseconds, sign.iterations};
  return data;
}

void walk(const problems::SpaceTrussSize& size, double friction) {
  auto solver = solver_of(scaled_compliance(size), friction);
  auto nodes = json::array();
  for (const auto& node : walked_nodes(solver, size.rows * size.depth))
    nodes.push_back({word_of(node.contact, size.rows * size.depth),
                     word_of(node.separated, size.rows * size.depth)});
  fmt::print(R"({{"rows": {}, "depth": {}, "bays": {}, "friction": {}, "nodes": {}}})"
             "\n",
             size.rows, size.depth, size.bays, friction, nodes.dump());
}

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Assembly and factorisation of m rows with as many cones: 3 m^3 and m^3 / 3 operations.
void show_equations(int m) {
  const int height = conic::padded(m);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(height, dimension * height);
  for (int d = 0; d < dimension; ++d) columns.block(0, d * height, m, m).setRandom();
  conic::NormalEquations<> equations(m);
  const double cube = std::pow(m, 3);
  double assembly = 1e300, factorisation = 1e300;
  for (int round = 0; round < std::max(3.0, 1e8 / cube); ++round) {
    assembly = std::min(assembly, seconds_of([&] {
                          equations.assemble({columns.data(), height, dimension, m, height});
                        }));
    for (int i = 0; i < m; ++i) equations.add_to_diagonal(i, 1);
    Eigen::VectorXd first = Eigen::VectorXd::Zero(height), second = first;
    factorisation = std::min(factorisation,
                             seconds_of([&] { equations.factorise(first.data(), second.data()); }));
  }
  fmt::print("{:>5} | {:>10.0f} {:>8.1f} | {:>10.0f} {:>8.1f}\n", m, assembly * 1e6,
             3e-9 * cube / assembly, factorisation * 1e6, 1e-9 / 3 * cube / factorisation);
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> call(words + 1, words + count);
  if (call.size() == 5 && call[0] == "--walk") {
    walk({std::stoi(call[1]), std::stoi(call[2]), std::stoi(call[3])}, std::stod(call[4]));
    return EXIT_SUCCESS;
  }
  if (call.size() == 1 && call[0] == "--equations") {
    fmt::print("    m | assembly: us GFlop/s | factor: us  GFlop/s\n");
    for (const int m : {30, 64, 128, 233, 512, 800, 1000}) show_equations(m);
    return EXIT_SUCCESS;
  }
  if (call.empty()) {
    fmt::print(stderr, "bench_cones [--json] INSTANCE...; expected files of bench/instances\n");
    return EXIT_FAILURE;
  }
  const bool as_json = call[0] == "--json";
  if (!as_json)
    fmt::print("  m | full: us  iterations | sign: us  iterations | alive dead marginal\n");
  for (std::size_t i = as_json ? 1 : 0; i < call.size(); ++i) {
    if (as_json)
      fmt::print("{}\n", data_of(read(call[i])).dump());
    else
      show(read(call[i]));
  }
}
