// Run time of the rays of plane trusses: by double description, whole and divided, pattern by
// pattern on one rank, and, if installed, by lrs and cddexec, which enumerate all rays of C_r,
// complementary or not.
//
//   bench_rays [MU [FIRST_ROWS [LAST_ROWS [SECONDS]]]]
//
// A column ends when a size took longer than a quarter of SECONDS (the next may take four times as
// long); lrs and cddexec are stopped after SECONDS. Times of Kusabi are CPU seconds of one core.
// Rays, peaks and pairs are the same on any machine.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/search.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_tree.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace {

using namespace kusabi;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double cpu_seconds_of(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Measured {
  double seconds = 0;
  std::size_t rays = 0;
  rays::Cost cost;
  rays::Health health;
};

Measured double_description(const rays::ReactionCone& cone) {
  rays::Enumeration found;
  const double time = cpu_seconds_of([&] { found = rays::complementary_rays(cone); });
  return {time, found.rays.size(), found.cost, found.health};
}

// Rays by a tree, of the kind that `plant` makes.
Measured search(const auto& plant) {
  Measured result;
  result.seconds = cpu_seconds_of([&] {
    auto tree = plant();
    const auto outcome = engine::search(tree);
    for (const auto& leaf : outcome.solutions) result.rays += leaf.solution.rays.size();
    result.cost = tree.tally().cost;
    result.health = tree.tally().health;
  });
  return result;
}

// C_r in the format of lrs and cddlib.
void write_inequalities(const rays::ReactionCone& cone, const std::string& file) {
  const auto& gaps = cone.gaps();
  std::ofstream out(file);
  out << fmt::format("cone\nH-representation\nbegin\n{} {} rational\n", gaps.rows() + gaps.cols(),
                     gaps.cols() + 1);
  for (Eigen::Index k = 0; k < gaps.cols(); ++k) {
    out << '0';
    for (Eigen::Index j = 0; j < gaps.cols(); ++j) out << (j == k ? " 1" : " 0");
    out << '\n';
  }
  for (Eigen::Index i = 0; i < gaps.rows(); ++i) {
    const long double size = gaps.row(i).cwiseAbs().maxCoeff();
    out << '0';
    for (Eigen::Index j = 0; j < gaps.cols(); ++j) {
      out << fmt::format(" {}/1000000", std::llround(1e6L * gaps(i, j) / size));
    }
    out << '\n';
  }
  out << "end\n";
}

// Time of another program for the same cone, as a cell.
std::string other(const std::string& program, const std::string& file, double limit) {
  if (std::system(
          fmt::format("command -v {} > /dev/null", program.substr(0, program.find(' '))).c_str()) !=
      0)
    return "-";
  int code = 0;
  const double time = seconds_of([&] {
    code =
        std::system(fmt::format("timeout {} {} {} > /dev/null 2>&1", limit, program, file).c_str());
  });
  if (time >= limit) return fmt::format("> {:.0f}", limit);
  return code == 0 ? fmt::format("{:.3f}", time) : "fails";
}

std::string cells(const std::optional<Measured>& measured) {
  if (!measured) return fmt::format("{:>10} {:>9} {:>13}", "-", "-", "-");
  return fmt::format("{:>10.4f} {:>9} {:>13}", measured->seconds, measured->cost.peak_rays,
                     measured->cost.pairs);
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int place, double otherwise) {
    return argc > place ? std::atof(argv[place]) : otherwise;
  };
  const double mu = number(1, 0.65);
  const int last = static_cast<int>(number(3, 19));
  const double limit = number(4, 100);
  const std::string file =
      (std::filesystem::temp_directory_path() / fmt::format("bench_rays.{}.ine", getpid()))
          .string();
  fmt::print("mu = {}\n{:>4} {:>8}  {:<34}  {:<34}  {:<34}  {:>8} {:>8}  {}\n", mu, "N", "rays",
             "double description: s, peak, pairs", "divided: s, peak, pairs",
             "tree: s, peak, pairs", "lrs", "cddexec", "largest zero, least other");
  std::string lrs;
  std::string cddexec;
  bool first_ends = false;
  bool second_ends = false;
  bool third_ends = false;
  for (int rows = static_cast<int>(number(2, 5));
       rows <= last && !(first_ends && second_ends && third_ends); ++rows) {
    const auto truss = problems::plane_truss({.rows = rows});
    const std::vector<double> friction(static_cast<std::size_t>(rows), mu);
    const rays::ReactionCone cone(
        problems::precise_compliance(problems::wedged_problem(checked(truss))), friction);
    std::optional<Measured> whole;
    std::optional<Measured> by_parts;
    std::optional<Measured> by_pattern;
    const auto patterns = [&] {
      return wedged::SignPatternTree(problems::wedged_problem(checked(truss)), friction);
    };
    if (!first_ends) whole = double_description(cone);
    if (!second_ends) {
      by_parts =
          search([&] { return wedged::RayListTree(patterns(), cone, rays::first_list(cone)); });
    }
    if (!third_ends) by_pattern = search([&] { return wedged::RayTree(patterns(), cone); });
    first_ends = first_ends || whole->seconds > limit / 4;
    second_ends = second_ends || by_parts->seconds > limit / 4;
    third_ends = third_ends || by_pattern->seconds > limit / 4;
    write_inequalities(cone, file);
    if (!lrs.starts_with('>')) lrs = other("lrs", file, limit);
    if (!cddexec.starts_with('>')) cddexec = other("cddexec --rep <", file, limit);
    const auto& known = by_parts ? *by_parts : whole ? *whole : *by_pattern;
    const auto differs = [&](const auto& other) { return other && other->rays != known.rays; };
    fmt::print("{:>4} {:>8}  {}  {}  {}  {:>8} {:>8}  {:.0e} {:.0e}{}\n", rows, known.rays,
               cells(whole), cells(by_parts), cells(by_pattern), lrs, cddexec,
               known.health.largest_zero, known.health.smallest_nonzero,
               differs(whole) || differs(by_pattern) ? "  DIFFERENT" : "");
    std::fflush(stdout);
  }
  std::filesystem::remove(file);
}
