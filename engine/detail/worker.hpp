// Worker: one rank of a search, that is the protocol (engine/detail/protocol/rank.hpp) with a typed
// local search (engine/detail/explorer.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <streambuf>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "engine/detail/explorer.hpp"
#include "engine/detail/local_search.hpp"
#include "engine/detail/protocol/rank.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"
#include "engine/transport/transport.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// The explorer of one rank and the reports of all ranks, with their types.
template <Problem P>
class LocalExplorer final : public LocalSearch {
 public:
  LocalExplorer(P& problem, const Options& options, std::function<bool()> serve)
      : problem_(problem), explorer_(problem, options, std::move(serve)) {}

  void add_root() override { explorer_.add_root(); }
  void open_nodes(unsigned count) override { explorer_.open_nodes(count); }
  [[nodiscard]] bool has_nodes() const override { return explorer_.has_nodes(); }
  [[nodiscard]] bool expanding() const override { return explorer_.expanding(); }
  [[nodiscard]] bool checking() const override { return explorer_.checking(); }
  [[nodiscard]] std::uint64_t open() const override { return explorer_.open(); }
  [[nodiscard]] double bound() const override { return explorer_.bound(); }
  [[nodiscard]] double closed() const override { return explorer_.closed(); }
  [[nodiscard]] RankStatistics& statistics() override { return explorer_.statistics(); }

  [[nodiscard]] bool can_transfer() const override { return explorer_.can_transfer(); }
  std::vector<PackedTransfer> give(std::size_t limit, std::size_t maximum) override {
    std::vector<PackedTransfer> pieces;
    for (auto& transfer : explorer_.give(limit, maximum)) {
      pieces.push_back({pack(transfer), size_of(transfer)});
      transfer = {};
    }
    return pieces;
  }
  std::uint64_t take(const Bytes& body) override {
    auto transfer = unpack<engine::Transfer<Node>>(body);
    const auto nodes = size_of(transfer);
    explorer_.take(std::move(transfer));
    return nodes;
  }

  [[nodiscard]] std::uint64_t found() const override {
    return explorer_.emits() ? explorer_.statistics().found + before().found
                             : explorer_.solutions().size();
  }
  [[nodiscard]] const Incumbent& incumbent() const override {
    return explorer_.solutions().incumbent();
  }
  [[nodiscard]] double objective() const override { return explorer_.solutions().objective(); }
  [[nodiscard]] double oriented(double value) const override { return engine::oriented<P>(value); }
  [[nodiscard]] bool just_improved() override { return explorer_.solutions().just_improved(); }
  bool learn(const Incumbent& received) override { return explorer_.solutions().learn(received); }

  [[nodiscard]] std::string node_type() const override { return typeid(typename P::Node).name(); }
  [[nodiscard]] std::string solution_type() const override {
    return typeid(typename P::Solution).name();
  }
  void save(std::streambuf& target) override {
    boost::archive::binary_oarchive archive(target, wire::archive_flags);
    auto reports = earlier_;
    reports.push_back(own_report());
    const SavedNow saved{explorer_.state(), reports};
    archive << saved;
  }
  void restore(const Bytes& state) override {
    auto saved = unpack<Saved>(state);
    explorer_.restore(std::move(saved.state));
    std::move(saved.reports.begin(), saved.reports.end(), std::back_inserter(earlier_));
  }
  [[nodiscard]] Before before() const override {
    Before before;
    for (const auto& report : earlier_) {
      before.opened += report.statistics.opened;
      before.fingerprint += report.statistics.fingerprint;
      before.found += report.statistics.found;
    }
    return before;
  }

  void report(std::size_t limit, const std::function<void(Bytes)>& send) override {
    ReportPart part;
    PackedSize<FoundSolution<P>> packed_size;
    std::size_t bytes = 0;
    explorer_.solutions().take_each([&](FoundSolution<P>&& found) {
      bytes += packed_size(found);
      if (bytes > limit && !part.found.empty()) {
        send(pack(part));
        part.found.clear();
        bytes = packed_size(found);
      }
      part.found.push_back(std::move(found));
    });
    part.last = true;
    part.rank = own_report();
    part.earlier = earlier_;
    send(pack(part));
  }
  void receive_report(int from, const Bytes& piece) override {
    auto part = unpack<ReportPart>(piece);
    explorer_.solutions().add(std::move(part.found));
    if (!part.last) return;
    std::move(part.earlier.begin(), part.earlier.end(), std::back_inserter(earlier_));
    const auto place = static_cast<std::size_t>(from);
    if (reports_.size() <= place) reports_.resize(place + 1);
    reports_[place] = std::move(part.rank);
  }

  /// Moves solutions, in the order of the outcome, and reports into the outcome.
  void hand_over(Outcome<P>& outcome) {
    auto& solutions = outcome.solutions;
    solutions.reserve(explorer_.solutions().size());
    explorer_.solutions().take_each(
        [&](FoundSolution<P>&& found) { solutions.push_back(std::move(found)); });
    const auto before = [](const auto& a, const auto& b) { return a.path < b.path; };
    // The sort copies half of them elsewhere; a single rank has found them in order.
    if (explorer_.goal() == Goal::all && !std::ranges::is_sorted(solutions, before)) {
      std::ranges::stable_sort(solutions, before);
    }
    outcome.earlier = std::move(earlier_);
    if (reports_.empty()) reports_.resize(1);
    reports_.front() = own_report();
    outcome.ranks = std::move(reports_);
  }

 private:
  using Node = StoredNode<P>;

  // A piece of a rank's report: solutions, and in the last piece the rest.
  struct ReportPart {
    std::vector<FoundSolution<P>> found;
    bool last = false;
    RankReport<P> rank;
    std::vector<RankReport<P>> earlier;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& found& last;
      if (last) archive& rank& earlier;
    }
  };

  // State that is written as `Saved`, without a copy.
  struct SavedNow {
    typename Explorer<P>::SavedState state;
    const std::vector<RankReport<P>>& reports;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive << state << reports;
    }
  };

  // Content of a checkpoint part, as it is read.
  struct Saved {
    typename Explorer<P>::State state;
    std::vector<RankReport<P>> reports;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& state& reports;
    }
  };

  RankReport<P> own_report() {
    RankReport<P> report;
    report.statistics = explorer_.statistics();
    if constexpr (Tallying<P>) report.tally = problem_.tally();
    return report;
  }

  P& problem_;
  Explorer<P> explorer_;
  std::vector<RankReport<P>> earlier_;
  std::vector<RankReport<P>> reports_;  // of all ranks, on rank 0
};

/// A rank that searches the tree of a problem. The driver calls `step` until it returns done.
template <Problem P>
class Worker {
 public:
  /// The problem, the transport and the options must outlive the worker. @throws as Rank::Rank
  Worker(P& problem, Transport& transport, const Options& options)
      : local_(problem, options, [this] { return rank_.poll(); }),
        rank_(local_, transport, options) {}

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Does a bounded amount of work.
  /// @throws ExpansionFailed if the problem's `expand` throws
  Pace step() { return rank_.step(); }

  /// Number of nodes opened on this rank.
  [[nodiscard]] std::uint64_t opened() { return local_.statistics().opened; }

  /// Number of open nodes on this rank.
  [[nodiscard]] std::uint64_t open() const { return local_.open(); }

  [[nodiscard]] double quiet_until() const { return rank_.quiet_until(); }
  [[nodiscard]] unsigned requests_at() const { return rank_.requests_at(); }

  /// @pre the last step returned done
  Outcome<P> outcome() && {
    auto ending = rank_.ending();
    Outcome<P> outcome;
    outcome.status = ending.status;
    outcome.open = ending.open;
    outcome.saved = ending.saved;
    outcome.bound = oriented<P>(std::min(ending.bound, local_.incumbent().objective));
    outcome.traces = std::move(ending.traces);
    local_.hand_over(outcome);
    return outcome;
  }

 private:
  LocalExplorer<P> local_;
  Rank rank_;
};

}  // namespace kusabi::engine
