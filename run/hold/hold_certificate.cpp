// Each rank writes the nodes that it closed; rank 0 writes the states.
#include "run/hold/hold_certificate.hpp"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "run/evidence/certificate_file.hpp"
#include "run/output/standard_output.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

constexpr std::array grip_words{"above", "below"};

std::string sets(const wedged::LoadedPattern& pattern) {
  return support::hexadecimal(pattern.contact) + ' ' + support::hexadecimal(pattern.separated);
}

class HoldCertificate final : public wedged::HoldRecord {
 public:
  HoldCertificate(Session& session, const HoldCertificates& certificates, const std::string& name,
                  const wedged::LoadedProblem& loaded, double mu, std::uint64_t fingerprint)
      : session_(session),
        certificates_(certificates),
        name_(name),
        loaded_(loaded),
        friction_(wedged::friction_with_loads(loaded.problem, mu, 0)),
        file_(session, name, certificates.input, fingerprint, false) {}

  void tree(std::uint32_t block, const wedged::TreeEvidence& tree) override {
    auto line = fmt::format("tree {} {}", block + 1, tree.shares.size());
    for (const auto& share : tree.shares)
      append_numbers(line, std::array{share.dead, share.reference});
    if (const auto& grip = tree.grip; grip && grip->kind != wedged::GripRestriction::Kind::equal) {
      line +=
          fmt::format(" {} {:a}", grip_words.at(static_cast<std::size_t>(grip->kind)), grip->total);
    }
    trees_.push_back(line + '\n');
    for (const auto& node : tree.nodes.value()) {
      line = fmt::format("dead {} {}", trees_.size(), sets(node.pattern));
      append_numbers(line, node.numbers);
      file_.add(std::string_view(line += '\n'));
    }
  }

  void state(std::uint32_t block, const std::optional<wedged::LoadShare>& share,
             const wedged::LoadedPattern& pattern, std::span<const double> numbers) override {
    has_states_ = true;
    if (!session_.is_first()) return;
    auto line = fmt::format("{} {}", share ? "alive" : "wedged", block + 1);
    if (share) append_numbers(line, std::array{share->dead, share->reference});
    line += ' ' + sets(pattern);
    append_numbers(line, numbers);
    file_.add(std::string_view(line += '\n'));
  }

  [[nodiscard]] bool has_evidence() const override { return has_states_ || !trees_.empty(); }

  void finish() override {
    file_.close();
    if (!session_.is_first()) return;
    std::string text = "kusabi hold certificate 1\ncase";
    if (!certificates_.load_case.empty()) text += ' ' + one_line(certificates_.load_case);
    text += '\n' + candidate_lines(loaded_.problem, friction_) + motion_lines(loaded_.problem);
    if (certificates_.total) text += fmt::format("total {:a}\n", *certificates_.total);
    text += fmt::format("trees {}\n", trees_.size());
    for (const auto& tree : trees_) text += tree;
    file_.put_in_place(text + "nodes\n");
    if (!certificates_.quiet) print_written({name_});
  }

 private:
  Session& session_;
  HoldCertificates certificates_;
  std::string name_;
  const wedged::LoadedProblem& loaded_;
  std::vector<double> friction_;
  CertificateFile file_;
  std::vector<std::string> trees_;
  bool has_states_ = false;
};

}  // namespace

wedged::HoldRecorder hold_recorder(Session& session, HoldCertificates certificates,
                                   const wedged::LoadedProblem& loaded) {
  if (certificates.name.empty()) return {};
  return [&session, &loaded, certificates = std::move(certificates)](
             wedged::HoldClaim end, double mu) -> std::unique_ptr<wedged::HoldRecord> {
    support::Fingerprint fingerprint;
    fingerprint.add(loaded.problem.provenance.fingerprint);
    fingerprint.add(mu);
    const char* const which = end == wedged::HoldClaim::lower   ? ".lower"
                              : end == wedged::HoldClaim::upper ? ".upper"
                                                                : "";
    return std::make_unique<HoldCertificate>(session, certificates, certificates.name + which,
                                             loaded, mu, fingerprint.value());
  };
}

}  // namespace kusabi::run
