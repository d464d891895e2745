// The choice between MPI and a single process, and the one broadcast that the command needs.
#include "run/session/session.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <span>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "engine/transport/mpi.hpp"
#include "engine/transport/single_process.hpp"
#include "run/session/launch.hpp"
#include "support/input_error.hpp"

namespace kusabi::run {
namespace {

bool serial_wanted(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  return std::any_of(arguments.begin(), arguments.end(), [](const char* argument) {
    return std::string_view(argument).starts_with("--serial");
  });
}

}  // namespace

struct Session::Mpi {
  Mpi(int& argc, char**& argv) : environment(argc, argv) {}
  engine::MpiEnvironment environment;
  engine::MpiTransport transport;
};

Session::Session(int& argc, char**& argv) {
  if (engine::MpiEnvironment::launched() && !serial_wanted(argc, argv)) {
    mpi_ = std::make_unique<Mpi>(argc, argv);
  } else {
    alone_ = std::make_unique<engine::SingleProcess>();
  }
}

Session::~Session() = default;

engine::Transport& Session::transport() {
  if (mpi_) return mpi_->transport;
  return *alone_;
}

std::optional<std::string> Session::fault_of_launch(bool serial) {
  const auto launch = launch_told_by([](const char* name) { return std::getenv(name); });
  auto fault = run::fault_of_launch(launch, static_cast<unsigned>(ranks()), serial);
  if (fault && launch->number != 0) fault->clear();
  return fault;
}

std::string Session::on_first_rank(const std::function<std::string()>& prepare) {
  constexpr char good = '+';
  constexpr char wrong = '-';
  engine::Bytes message;
  const auto tell = [&](char verdict, std::string_view text) {
    message.assign(1, verdict);
    message.insert(message.end(), text.begin(), text.end());
  };
  if (speaks()) {
    try {
      tell(good, prepare());
    } catch (const WrongInput& error) {
      tell(wrong, error.what());
    } catch (const support::InputError& error) {
      tell(wrong, error.what());
    }
  }
  if (mpi_) mpi_->transport.broadcast(message);
  std::string text(message.begin() + 1, message.end());
  if (message.front() == wrong) throw WrongInput(text);
  return text;
}

void Session::agree(std::uint64_t fingerprint) {
  const std::string first = on_first_rank([&] { return std::to_string(fingerprint); });
  // A survey counts, and here it counts the ranks that have something else.
  const auto all = meet({.ranks = 1, .found = first == std::to_string(fingerprint) ? 0U : 1U});
  if (all.found == 0) return;
  throw Disagreement(fmt::format(
      "{} of {} ranks have worked out another problem from the same file than rank 0: expected "
      "machines of one kind and the same build of kusabi on each",
      all.found, all.ranks));
}

engine::Survey Session::meet(const engine::Survey& own) {
  transport().join_survey(own);
  for (;;) {
    if (const auto all = transport().survey()) return *all;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

}  // namespace kusabi::run
