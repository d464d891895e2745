#include "searched.hpp"

#include <sstream>

#include <fmt/format.h>

#include "nodes/sha1.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/structure_file.hpp"
#include "run/certificate_file.hpp"
#include "verify/certificate.hpp"
#include "verify/cover.hpp"
#include "verify/proof.hpp"

namespace kusabi::verify {

std::string sealed(const std::string& text) {
  const auto body = text.substr(0, text.rfind("digest "));
  return fmt::format("{}digest {}\n", body, nodes::hexadecimal(nodes::sha1(body)));
}

std::string Draft::text() const {
  std::string body;
  for (const auto& line : header) body += line;
  for (const auto& line : nodes) body += line;
  return sealed(body + fmt::format("end {}\n", nodes.size()));
}

problems::WedgedProblem example(const std::string& name) {
  return problems::wedged_problem(
      problems::load_structure(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name));
}

Draft searched(const problems::WedgedProblem& problem, double friction) {
  const std::vector<double> everywhere(problem.contact_names.size(), friction);
  Draft draft;
  std::istringstream header(run::certificate_header(problem, everywhere));
  for (std::string line; std::getline(header, line);) draft.header.push_back(line + "\n");
  nodes::SignPatternTree tree(problem, everywhere);
  tree.report_to(
      [&](const auto& evidence) { draft.nodes.push_back(run::certificate_line(evidence)); });
  engine::search(tree);
  return draft;
}

Verdict verdict(const std::string& text) {
  const auto certificate = read_certificate(text, "cert");
  const Proof proof(certificate);
  Verdict result;
  if (!proof.least_eigenvalue()) {
    result.refusals.emplace_back("K");
    return result;
  }
  for (const auto& record : certificate.records) {
    if (auto reason = proof.refusal(record)) {
      result.refusals.push_back(*reason);
    } else if (record.claim == Claim::alive) {
      result.alive.insert(record.contact);
    } else {
      ++(record.claim == Claim::dead ? result.dead : result.marginal);
    }
  }
  if (auto flaw = flaw_of_cover(certificate)) result.refusals.push_back(*flaw);
  return result;
}

}  // namespace kusabi::verify
