// Choice between MPI and a single process; errors broadcast to all ranks.
#include "run/session/session.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
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

// Message of rank 0.
struct Prepared {
  engine::Bytes bytes;
  std::string wrong;  // error in the call or its input; empty: none

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& bytes& wrong;
  }
};

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
  const auto launch = launch_from([](const char* name) { return std::getenv(name); });
  auto fault = run::fault_of_launch(launch, static_cast<unsigned>(ranks()), serial);
  if (fault && launch->number != 0) fault->clear();
  return fault;
}

engine::Bytes Session::broadcast(const std::function<engine::Bytes()>& prepare) {
  auto prepared = engine::from_first_rank(transport(), [&] {
    Prepared own;
    try {
      own.bytes = prepare();
    } catch (const WrongInput& error) {
      own.wrong = error.what();
    } catch (const support::InputError& error) {
      own.wrong = error.what();
    }
    return own;
  });
  if (!prepared.wrong.empty()) throw WrongInput(prepared.wrong);
  return std::move(prepared.bytes);
}

}  // namespace kusabi::run
