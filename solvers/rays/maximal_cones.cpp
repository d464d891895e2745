// Maximal cones by a walk over sign patterns.
#include "solvers/rays/maximal_cones.hpp"

#include <algorithm>
#include <utility>

namespace kusabi::rays {
namespace {

bool by_bits(const Cone& a, const Cone& b) {
  return std::pair(a.reaction, a.separated) < std::pair(b.reaction, b.separated);
}

bool compatible(const Cone& a, const Cone& b) {
  return (a.reaction & b.separated) == 0 && (a.separated & b.reaction) == 0;
}

/// Rays also differ in their sliding; for cones only their supports count, of which there are
/// fewer.
class Walk {
 public:
  Walk(std::vector<Cone> supports, Candidates all, const std::function<bool()>& stop)
      : supports_(std::move(supports)), all_(all), stop_(stop) {}

  // Nothing if the walk was stopped.
  std::optional<std::vector<Cone>> cones() && {
    std::vector<int> everything(supports_.size());
    for (std::size_t i = 0; i < everything.size(); ++i) everything[i] = static_cast<int>(i);
    descend(everything);
    if (stopped_) return std::nullopt;
    std::sort(found_.begin(), found_.end(), by_bits);
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  const Cone& support(int number) const { return supports_[static_cast<std::size_t>(number)]; }

  Cone together(const std::vector<int>& list) const {
    Cone sum;
    for (const int number : list) {
      sum.reaction |= support(number).reaction;
      sum.separated |= support(number).separated;
    }
    return sum;
  }

  // `list` contains all rays compatible with the choices so far. Only a candidate at which it has
  // both a reaction and a gap requires a choice.
  void descend(const std::vector<int>& list) {
    stopped_ = stopped_ || (stop_ && stop_());
    if (list.empty() || stopped_) return;
    const Cone sum = together(list);
    const Candidates disputed = sum.reaction & sum.separated;
    if (disputed == 0) {
      if (is_maximal(sum, list.size())) found_.push_back(sum);
      return;
    }
    const Candidates choice = disputed & (~disputed + 1);
    std::vector<int> rest;
    rest.reserve(list.size());
    for (const auto part : {&Cone::separated, &Cone::reaction}) {
      rest.clear();
      for (const int number : list) {
        if ((support(number).*part & choice) == 0) rest.push_back(number);
      }
      descend(rest);
    }
  }

  // True if the family is maximal, that is, if no other ray is compatible with its sum. The list
  // contains all rays compatible with the choices.
  bool is_maximal(const Cone& sum, std::size_t size) const {
    if ((sum.reaction | sum.separated) == all_) return true;
    const auto count = std::count_if(supports_.begin(), supports_.end(),
                                     [&](const Cone& each) { return compatible(each, sum); });
    return static_cast<std::size_t>(count) == size;
  }

  std::vector<Cone> supports_;
  Candidates all_;
  const std::function<bool()>& stop_;
  bool stopped_ = false;
  std::vector<Cone> found_;
};

}  // namespace

Cone cone_of(const Supports& ray) {
  return {ray.reaction(), ray.separated()};
}

void ConesOfRays::add(const Cone& ray) {
  constexpr std::size_t least = 4096;  // kept without sorting
  cones_.push_back(ray);
  if (cones_.size() > std::max(least, 2 * sorted_)) sorted();
}

const std::vector<Cone>& ConesOfRays::sorted() {
  std::sort(cones_.begin(), cones_.end(), by_bits);
  cones_.erase(std::unique(cones_.begin(), cones_.end()), cones_.end());
  sorted_ = cones_.size();
  return cones_;
}

std::vector<Cone> maximal_cones(std::span<const ZeroSet> rays, Candidates all) {
  ConesOfRays cones;
  for (const ZeroSet& zero : rays) cones.add(cone_of({zero, all}));
  return *maximal_cones(std::move(cones), all, {});
}

std::optional<std::vector<Cone>> maximal_cones(ConesOfRays rays, Candidates all,
                                               const std::function<bool()>& stop) {
  auto cones = Walk(rays.sorted(), all, stop).cones();
  if (!cones) return cones;
  std::sort(cones->begin(), cones->end(), [](const Cone& a, const Cone& b) {
    if (a.reaction != b.reaction) return before(a.reaction, b.reaction);
    return before(a.separated, b.separated);
  });
  return cones;
}

}  // namespace kusabi::rays
