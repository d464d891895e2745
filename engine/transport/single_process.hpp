// SingleProcess: transport of a search with one rank, without messages and MPI, for debuggers,
// valgrind and most tests.
#pragma once

#include <chrono>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

class SingleProcess : public Transport {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }

  [[nodiscard]] double now() const override {
    const auto since_epoch = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since_epoch).count();
  }

  void send(int /*to*/, MessageTag /*tag*/, Bytes /*body*/) override {
    ensure(false, "a rank that is alone sends nothing");
  }
  std::optional<Message> receive() override { return std::nullopt; }

  void join_reduction(const Reduction& own) override { wave_ = own; }
  std::optional<Reduction> reduction() override { return std::exchange(wave_, std::nullopt); }

  void broadcast(Bytes& /*bytes*/) override {}

  void abandon(const std::string& /*reason*/) override {}

 private:
  std::optional<Reduction> wave_;
};

}  // namespace kusabi::engine
