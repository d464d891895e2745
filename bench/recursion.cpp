// Plain recursions for the searches of examples/engine: the same instances, orders and bounds, one
// process, nodes changed in place. They show what the engine costs.
//
//   bench_recursion queens 12          bench_recursion knapsack 50 7
//   bench_recursion salesman 14 7      bench_recursion clique GRAPH
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

std::uint64_t nodes = 0;

struct Queens {
  int size;
  std::vector<int> columns;
  std::uint64_t found = 0;

  bool attacked(int column) const {
    int distance = static_cast<int>(columns.size());
    for (const int other : columns) {
      if (other == column || std::abs(other - column) == distance) return true;
      --distance;
    }
    return false;
  }
  void open() {
    ++nodes;
    if (static_cast<int>(columns.size()) == size) {
      ++found;
      return;
    }
    for (int column = 0; column < size; ++column) {
      if (attacked(column)) continue;
      columns.push_back(column);
      open();
      columns.pop_back();
    }
  }
};

struct Knapsack {
  struct Item {
    int value, weight;
  };
  std::vector<Item> items;
  int best = -1;

  double bound(std::size_t decided, double value, double room) const {
    for (; decided < items.size() && room > 0; ++decided) {
      const double share = std::min(1.0, room / items[decided].weight);
      value += share * items[decided].value;
      room -= share * items[decided].weight;
    }
    return value;
  }
  void open(std::size_t decided, int value, int room) {
    if (bound(decided, value, room) <= best) return;
    ++nodes;
    if (decided == items.size()) {
      best = value;
      return;
    }
    const auto [more, weight] = items[decided];
    if (weight <= room) open(decided + 1, value + more, room - weight);
    open(decided + 1, value, room);
  }
};

struct Salesman {
  std::vector<std::vector<double>> distance;
  std::vector<int> tour{0};
  std::vector<char> visited;
  double best = std::numeric_limits<double>::infinity();

  double bound(double length) const {
    for (std::size_t from = 0; from < distance.size(); ++from) {
      if (from != static_cast<std::size_t>(tour.back()) && visited[from] != 0) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t to = 0; to < distance.size(); ++to) {
        if (to != from && (to == 0 || visited[to] == 0))
          nearest = std::min(nearest, distance[from][to]);
      }
      length += nearest;
    }
    return length;
  }
  void open(double length) {
    const double minimum = bound(length);
    if (minimum > best || (minimum == best && best < std::numeric_limits<double>::infinity()))
      return;
    ++nodes;
    if (tour.size() == distance.size()) {
      best = std::min(best, length + distance[static_cast<std::size_t>(tour.back())][0]);
      return;
    }
    for (std::size_t town = 1; town < distance.size(); ++town) {
      if (visited[town] != 0) continue;
      const double step = distance[static_cast<std::size_t>(tour.back())][town];
      visited[town] = 1;
      tour.push_back(static_cast<int>(town));
      open(length + step);
      tour.pop_back();
      visited[town] = 0;
    }
  }
};

struct Clique {
  std::set<std::pair<int, int>> edges;
  std::size_t best = 0;

  bool joined(int one, int other) const { return edges.count(std::minmax(one, other)) > 0; }

  std::size_t colour(std::vector<int>& candidates) const {
    std::vector<std::vector<int>> classes;
    for (const int vertex : candidates) {
      const auto fits = std::find_if(classes.begin(), classes.end(), [&](const auto& others) {
        return std::none_of(others.begin(), others.end(),
                            [&](int other) { return joined(vertex, other); });
      });
      (fits == classes.end() ? classes.emplace_back() : *fits).push_back(vertex);
    }
    candidates.clear();
    for (const auto& some : classes) candidates.insert(candidates.end(), some.begin(), some.end());
    return classes.size();
  }
  void open(std::size_t size, std::vector<int> candidates, std::size_t colours) {
    if (best > 0 && size + colours <= best) return;
    ++nodes;
    if (candidates.empty()) {
      best = size;
      return;
    }
    const int vertex = candidates.back();
    candidates.pop_back();
    auto with = candidates;
    std::erase_if(with, [&](int other) { return !joined(vertex, other); });
    const auto colours_with = colour(with);
    open(size + 1, std::move(with), colours_with);
    const auto colours_without = colour(candidates);
    open(size, std::move(candidates), colours_without);
  }
};

double knapsack(int size, unsigned seed) {
  std::mt19937 random(seed);
  Knapsack problem;
  int capacity = 0;
  for (int i = size; i > 0; --i) {
    const int weight = 100 + static_cast<int>(random() % 900);
    problem.items.push_back({weight + static_cast<int>(random() % 100), weight});
    capacity += weight;
  }
  std::sort(problem.items.begin(), problem.items.end(), [](const auto& one, const auto& other) {
    return one.value * other.weight > other.value * one.weight;
  });
  problem.open(0, 0, capacity / 2);
  return problem.best;
}

double salesman(int towns, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < towns; ++i) {
    x.push_back(static_cast<double>(random()) / 4294967296.0);
    y.push_back(static_cast<double>(random()) / 4294967296.0);
  }
  Salesman problem;
  for (std::size_t i = 0; i < x.size(); ++i) {
    problem.distance.emplace_back();
    for (std::size_t j = 0; j < x.size(); ++j)
      problem.distance[i].push_back(std::hypot(x[i] - x[j], y[i] - y[j]));
  }
  problem.visited.assign(x.size(), 0);
  problem.visited[0] = 1;
  problem.open(0);
  return problem.best;
}

double clique(const char* name) {
  Clique problem;
  std::set<int> vertices;
  std::ifstream file(name);
  for (std::string line; std::getline(file, line);) {
    int one = 0;
    int other = 0;
    if (std::sscanf(line.c_str(), "e %d %d", &one, &other) != 2) continue;
    problem.edges.insert(std::minmax(one, other));
    vertices.insert({one, other});
  }
  std::vector<int> candidates(vertices.begin(), vertices.end());
  const auto colours = problem.colour(candidates);
  problem.open(0, std::move(candidates), colours);
  return static_cast<double>(problem.best);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 2 ? argv[1] : "";
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  double answer = 0;
  if (name == "queens") {
    Queens queens{std::atoi(argv[2]), {}};
    queens.open();
    answer = static_cast<double>(queens.found);
  } else if (name == "knapsack") {
    answer = knapsack(std::atoi(argv[2]), seed);
  } else if (name == "salesman") {
    answer = salesman(std::atoi(argv[2]), seed);
  } else if (name == "clique") {
    answer = clique(argv[2]);
  } else {
    std::fputs("expected queens, knapsack, salesman or clique, and the words of the example\n",
               stderr);
    return 2;
  }
  std::printf("%.6g: %llu nodes, %.3f CPU s\n", answer, static_cast<unsigned long long>(nodes),
              static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
  return 0;
}
