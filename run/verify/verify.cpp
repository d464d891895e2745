// `kusabi verify`: from the file to the verdict, on all ranks.
#include "run/verify/verify.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/terminal_page.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "support/fingerprint.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::run {
namespace {

// Every rank holds the text.
constexpr std::uintmax_t largest_file = std::numeric_limits<int>::max() - 1;

std::string content(const std::string& file) {
  const auto refuse = [&](const std::string& why) { throw WrongInput(file + ": " + why); };
  std::error_code failure;
  const auto size = std::filesystem::file_size(file, failure);
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) refuse("the file cannot be read; expected a certificate");
  if (size > largest_file) {
    refuse(fmt::format("the file has {} bytes; expected at most {}", size, largest_file));
  }
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) refuse("the file cannot be read in full");
  return text;
}

class Verify final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  VerifyOptions options_;
  std::string text_;
  problems::ProblemText problem_text_;
  std::optional<problems::CheckedStructure> structure_;
  VerifyFindings findings_;
};

void Verify::describe(OptionTable& table) {
  table
      .file("certificate", options_.certificate, Role::input,
            "certificate of kusabi patterns, critical, hold or limit")
      .required();
  table.file(
      "--problem", options_.problem, Role::input,
      "problem file (TOML) to which the proof applies; its stiffness is recomputed with bounds for "
      "all rounding errors. Default: the proof applies to the numbers in the certificate");
  table.resume(options_.checkpoint,
               ". The verification trusts this file, so nobody else may have access to it");
  table.quiet_and_serial("print errors and refused claims only");
}

void Verify::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return content(options_.certificate); });
  if (options_.problem.empty()) return;
  problem_text_ =
      run.session().from_first_rank([&] { return problems::problem_text(options_.problem); });
  structure_ = problems::read_structure(problem_text_, options_.problem);
}

void Verify::prepare(CommandRun& run) {
  support::Fingerprint fingerprint;
  fingerprint.add(text_);
  engine::Facts facts{{"the certificate", hexadecimal(fingerprint.value())}};
  if (!options_.problem.empty()) {
    support::Fingerprint problem;
    problem.add(problem_text_.toml);
    for (const auto& [name, text] : problem_text_.meshes) {
      problem.add(name);
      problem.add(text);
    }
    facts.emplace_back("--problem", hexadecimal(problem.value()));
  }
  run.keep_state(options_.checkpoint, std::move(facts));
}

// The first line identifies the kind of certificate.
void Verify::search(CommandRun& run) {
  if (text_.starts_with(verify::truss_first_line)) {
    findings_ = verify_truss(run, options_, structure_, text_);
  } else {
    findings_ = verify_contact(run, options_, structure_, text_);
  }
}

std::vector<Step> Verify::results(CommandRun& run) {
  const auto page = CommandRun::page();
  auto text = page.warning(findings_.refusals);
  if (!run.quiet()) text += findings_.summary;
  return {CommandRun::print(folded(text, page.width)), run.answer([] { return std::string(); })};
}

answer::Verdict Verify::verdict() const {
  return {.ended = findings_.status, .answer = findings_.check};
}

}  // namespace

constexpr Registration verify_subcommand{
    {.name = "verify",
     .chapter = "Verification",
     .purpose = "exact proof of a result from its certificate",
     .description =
         "Proves from a certificate, in exact arithmetic: a list of patterns, a critical friction "
         "coefficient, loads that friction can hold, a worst-case load factor, or the least factor "
         "after a loss of members.",
     .example = "answer.cert --problem examples/space-truss.toml"},
    make<Verify>};

}  // namespace kusabi::run
