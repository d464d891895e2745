// One certificate file per bound; a file is dropped when its bound moves.
#include "run/critical/critical_certificate.hpp"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "run/evidence/certificate_file.hpp"
#include "run/output/standard_output.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

class BoundCertificate final : public wedged::BoundRecord {
 public:
  BoundCertificate(Session& session, const BoundCertificates& certificates, const std::string& name,
                   std::uint64_t tree, const problems::WedgedProblem& problem,
                   std::span<const double> friction, bool& written)
      : session_(session),
        written_(written),
        quiet_(certificates.quiet),
        name_(name),
        problem_(problem),
        friction_(friction.begin(), friction.end()),
        file_(session, name, certificates.input, tree, false) {}

  void add(const wedged::Evidence& evidence) override { file_.add(evidence); }

  void end(std::span<const wedged::ProvedBound> bounds, wedged::BoundClaim claim,
           bool holds) override {
    file_.close();
    written_ = holds;
    if (!session_.is_first()) return;
    if (holds) {
      const bool one = claim == wedged::BoundClaim::one_pattern;
      file_.put_in_place(certificate_header(problem_, friction_, bounds) +
                         (one ? one_pattern_line : ""));
      if (!quiet_) print_written({name_});
    }
  }

 private:
  Session& session_;
  bool& written_;
  bool quiet_;
  std::string name_;
  const problems::WedgedProblem& problem_;
  std::vector<double> friction_;
  CertificateFile file_;
};

}  // namespace

wedged::BoundRecorder bound_recorder(Session& session, BoundCertificates certificates,
                                     const problems::WedgedProblem& problem,
                                     WrittenCertificates& written) {
  if (certificates.name.empty()) return {};
  return [&session, &problem, &written, certificates = std::move(certificates)](
             wedged::BracketSide side, double factor,
             std::span<const double> friction) -> std::unique_ptr<wedged::BoundRecord> {
    support::Fingerprint fingerprint;
    fingerprint.add(problem.provenance.fingerprint);
    fingerprint.add(factor);
    const bool lower = side == wedged::BracketSide::lower;
    return std::make_unique<BoundCertificate>(
        session, certificates, certificates.name + (lower ? ".lower" : ".upper"),
        fingerprint.value(), problem, friction, lower ? written.lower : written.upper);
  };
}

}  // namespace kusabi::run
