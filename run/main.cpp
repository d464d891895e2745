// The command `kusabi`: reads the call, runs the subcommand, and turns any error into one line and
// an exit code.
#include <cstdio>
#include <exception>
#include <string>

#include "answer/exit_code.hpp"
#include "engine/collectives.hpp"
#include "engine/transport/reason.hpp"
#include "run/command/command_line.hpp"
#include "run/command/command_list.hpp"
#include "run/command/command_run.hpp"
#include "run/command/config_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/session.hpp"
#include "support/input_error.hpp"

namespace {

using namespace kusabi::run;
namespace answer = kusabi::answer;

int refuse(Session& session, const std::string& message) {
  if (session.is_first()) {
    std::fflush(stdout);
    print_message("{}\n", message);
  }
  return answer::wrong_input;
}

int run(Session& session, int argc, char** argv) {
  auto list = command_list();
  const auto asked = parse(list, argc, argv);
  if (asked.entry == nullptr) {
    if (session.is_first()) print_answer(asked.text);
    return asked.wrong ? answer::wrong_input : answer::solved;
  }
  auto& entry = *asked.entry;
  const auto* const serial = entry.table.find("--serial");
  if (const auto fault = session.fault_of_launch(serial != nullptr && serial->given)) {
    if (!fault->empty()) refuse(session, "kusabi: " + *fault);
    return answer::wrong_input;
  }
  const auto defaults = take_defaults(session, list, entry);
  require_options(entry);
  return CommandRun(session, entry, defaults).execute();
}

}  // namespace

int main(int argc, char** argv) {
  secure_standard_streams();  // before MPI or anything else opens a file
  Session session(argc, argv);
  try {
    return run(session, argc, argv);
  } catch (const WrongCall& error) {
    return refuse(session, std::string("kusabi: ") + error.what());
  } catch (const WrongInput& error) {
    return refuse(session, error.what());
  } catch (const kusabi::support::InputError& error) {
    return refuse(session, error.what());
  } catch (const kusabi::engine::RankMismatch& error) {
    if (session.is_first()) print_message("kusabi: {}\n", error.what());
    return answer::failed;
  } catch (const std::exception& error) {
    const auto reason = kusabi::engine::reason_of(error.what());
    session.transport().abandon(reason);
    print_message("kusabi: {}\n", reason);
    return answer::failed;
  }
}
