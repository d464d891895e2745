// From the file to the verdict, on all ranks.
#include "run/verify/verify.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/search.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/progress_line.hpp"
#include "run/verify/verification.hpp"
#include "run/verify/verify_limit.hpp"
#include "verify/agreement.hpp"
#include "verify/certificate.hpp"
#include "verify/cover.hpp"
#include "verify/limit_certificate.hpp"
#include "verify/proof.hpp"

namespace kusabi::run {
namespace {

// Every rank gets the text in one message, and a message has no more bytes than this.
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

verify::Certificate certificate_in(const std::string& text, const std::string& file) {
  try {
    return verify::read_certificate(text, file);
  } catch (const verify::CertificateError& error) {
    throw WrongInput(error.what());
  }
}

// Of `count` things.
std::string counted(std::uint64_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string all_patterns(std::size_t candidates) {
  constexpr std::size_t easily_read = 20;
  if (candidates > easily_read) return fmt::format("2^{}", candidates);
  return std::to_string(std::uint64_t{1} << candidates);
}

void print_refusal(const VerifyOptions& options, const verify::Certificate& certificate,
                   const Verification::Solution& refusal) {
  const auto& record = certificate.records[refusal.record];
  fmt::print("{}:{}: refused: {} contact {} separated {}: {}\n", options.certificate, record.line,
             verify::claim_name(record.claim), certificate.names_of(record.contact),
             certificate.names_of(record.separated), refusal.reason);
}

// What is proved, and of what.
void print_subject(const VerifyOptions& options, const verify::Certificate& certificate,
                   const std::optional<problems::Structure>& structure,
                   const std::optional<verify::Agreement>& agreement) {
  fmt::print("contact candidates: {}\n", fmt::join(certificate.names, " "));
  if (!structure) {
    fmt::print(
        "K and the friction are the certificate's own; --problem FILE proves it of a "
        "structure\n");
    return;
  }
  fmt::print("problem: {}, from {}, fingerprint {:016x}\n", structure->name, options.problem,
             problems::wedged_fingerprint(*structure));
  fmt::print("friction coefficient: {}{}\n", agreement->friction,
             std::ranges::all_of(structure->contact, [](const auto& c) { return c.friction == 1; })
                 ? ""
                 : " times that of each candidate");
  fmt::print("K was computed anew from the structure, up to {:.1e}\n",
             agreement->stiffness.radius.nearest());
}

// What was proved, in the order in which the proof needs it.
void print_summary(const verify::Certificate& certificate, const verify::Proof& proof, bool covered,
                   const Verification::Tally& proved) {
  fmt::print("K is positive definite: its eigenvalues are above {:.3g}\n",
             proof.least_eigenvalue()->nearest());
  if (covered) {
    for (std::size_t b = 0; b < certificate.blocks.size(); ++b) {
      const auto block = certificate.blocks[b];
      const auto nodes = std::ranges::count(certificate.records, b, &verify::Record::block);
      fmt::print("{}{} cover all {} sign patterns{}, each once\n",
                 certificate.blocks.size() > 1 ? fmt::format("block {}: ", b + 1) : "",
                 counted(static_cast<std::uint64_t>(nodes), "node"),
                 all_patterns(static_cast<std::size_t>(std::popcount(block))),
                 certificate.blocks.size() > 1 ? " of " + certificate.names_of(block) : "");
    }
  }
  fmt::print("dead: {} proved\nalive: {} proved\n", proved.dead, proved.alive);
  if (proved.marginal > 0) fmt::print("marginal: {} not proved\n", proved.marginal);
}

void print_verdict(bool refused, const Verification::Tally& proved) {
  if (refused) {
    fmt::print("NOT PROVED\n");
  } else if (proved.marginal > 0 && proved.dead + proved.alive == 0) {
    fmt::print("NOTHING PROVED: all nodes are marginal, and nothing is claimed of these\n");
  } else if (proved.marginal > 0) {
    fmt::print("PROVED but for {}: the list of {} is complete but for these\n",
               counted(proved.marginal, "marginal node"), counted(proved.alive, "pattern"));
  } else {
    fmt::print("PROVED: the list of {} is complete\n", counted(proved.alive, "pattern"));
  }
}

int refuse_all(Session& session, const VerifyOptions& options, const std::string& why) {
  if (session.speaks()) {
    fmt::print("{}: refused: {}\n", options.certificate, why);
    if (!options.quiet) print_verdict(true, {});
    flush_standard_output();
  }
  return failed;
}

std::optional<problems::Structure> structure_in(Session& session, const VerifyOptions& options) {
  if (options.problem.empty()) return {};
  const auto text = session.from_first_rank([&] { return problems::file_text(options.problem); });
  return problems::read_structure(text, options.problem);
}

}  // namespace

int verify(Session& session, const VerifyOptions& options) {
  const auto text = session.from_first_rank([&] { return content(options.certificate); });
  const auto structure = structure_in(session, options);
  // The first line says what it is a certificate of.
  if (text.starts_with(verify::limit_first_line)) {
    return verify_limit(session, options, structure, text);
  }
  // Every rank reads it, and proves for itself what the proof of each node rests on.
  const auto certificate = certificate_in(text, options.certificate);
  std::optional<verify::Agreement> agreement;
  if (structure) {
    auto found = verify::agreement(certificate, evidence::verified_structure(*structure));
    if (const auto* why = std::get_if<std::string>(&found)) {
      return refuse_all(session, options, fmt::format("{}: {}", options.problem, *why));
    }
    agreement = std::move(std::get<verify::Agreement>(found));
  }
  const verify::Proof proof(
      certificate, agreement ? agreement->stiffness : verify::recorded_stiffness(certificate));
  if (!proof.least_eigenvalue()) {
    return refuse_all(session, options, "K was not shown to be positive definite");
  }

  Verification verification(certificate, proof);
  engine::Options search_options;
  std::optional<ProgressLine> progress;
  if (session.speaks() && !options.quiet) {
    progress.emplace(search_options.goal);
    search_options.progress = [&](const auto& state) { progress->show(state); };
  }
  const auto outcome = engine::search(verification, session.transport(), search_options);
  progress.reset();

  // Every rank knows whether the nodes cover all patterns and what is left open, but rank 0 alone
  // what was refused; the exit code of the job is that of a rank that has not 0.
  const auto flaw = verify::flaw_of_cover(certificate);
  const bool refused = flaw.has_value() || !outcome.solutions.empty();
  const bool open =
      std::ranges::count(certificate.records, verify::Claim::marginal, &verify::Record::claim) > 0;
  const int exit_code = refused ? failed : open ? stopped_early : solved;
  if (!session.speaks()) return refused ? failed : solved;
  for (const auto& found : outcome.solutions) print_refusal(options, certificate, found.solution);
  if (flaw) fmt::print("{}: refused: {}\n", options.certificate, *flaw);
  if (!options.quiet) {
    const auto proved = outcome.tally();
    print_subject(options, certificate, structure, agreement);
    print_summary(certificate, proof, !flaw, proved);
    print_verdict(refused, proved);
  }
  flush_standard_output();
  return exit_code;
}

}  // namespace kusabi::run
