// The transport of a search that runs alone: one rank, no messages, no MPI. It is what a debugger,
// valgrind and most tests want.
#pragma once

#include <chrono>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

class SingleProcess final : public Transport {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }

  [[nodiscard]] double now() const override {
    const auto since_epoch = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since_epoch).count();
  }

  void send(int /*to*/, Tag /*tag*/, Bytes /*body*/) override {
    ensure(false, "a rank that is alone sends nothing");
  }
  std::optional<Message> receive() override { return std::nullopt; }

  void join_survey(const Survey& own) override { wave_ = own; }
  std::optional<Survey> survey() override { return std::exchange(wave_, std::nullopt); }

  void broadcast(Bytes& /*bytes*/) override {}

  void abandon(const std::string& /*reason*/) override {}

 private:
  std::optional<Survey> wave_;
};

}  // namespace kusabi::engine
