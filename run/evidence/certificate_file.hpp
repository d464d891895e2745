// CertificateFile: a certificate about a contact problem (docs/certificates.md), written during the
// search in parts (part_files.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/evidence/part_files.hpp"
#include "run/output/output_file.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Section of a certificate about wedged configurations alone.
inline constexpr const char* no_load_lines = "loads 0\n";

/// Lines of the theorems that a list of patterns is complete, one for each block.
std::vector<std::string> list_theorems(const problems::WedgedProblem& problem);

/// Header of a certificate, up to the line 'evidence'. @param theorems one line each
/// @param bounds used by its nodes @param load_lines from the line 'loads N' to the total
std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               const std::vector<std::string>& theorems,
                               std::span<const wedged::ProvedBound> bounds = {},
                               const std::string& load_lines = no_load_lines);

/// ' ' and a hexadecimal number, for each number.
void append_numbers(std::string& text, std::span<const double> numbers);

/// Line of a node of list_theorems(), or of a wedged configuration, including its line end.
std::string certificate_line(const wedged::Evidence& evidence);

/// Joins the parts of a search that an earlier run has completed; leaves the certificate if that
/// run has joined them. On rank 0.
/// @param input as CertificateFile()
/// @param tree fingerprint of the searched tree
/// @throws std::runtime_error if parts are missing or belong to another tree
void put_earlier_certificate_in_place(const std::string& name, const std::string& input,
                                      std::uint64_t tree, const std::string& header);

/// A certificate written by all ranks together, in parts until it is complete.
class CertificateFile {
 public:
  /// Opens the files; none for an empty name.
  /// @param input the problem file, which must be another file
  /// @param tree fingerprint of the searched tree
  /// @param goes_on, checkpoint as PartFiles()
  /// @throws WrongInput on every rank; std::runtime_error if a rank cannot open its part
  CertificateFile(Session& session, const std::string& name, const std::string& input,
                  std::uint64_t tree, bool goes_on, const std::string& checkpoint = {});

  [[nodiscard]] bool wanted() const { return !name_.empty(); }

  /// Writes a node. A full disk is reported by close(). @pre wanted()
  void add(const wedged::Evidence& evidence);

  /// Writes whole lines. @pre wanted()
  void add(std::string_view lines) { parts_->put(lines); }

  /// Closes this part; collective over all ranks. @pre wanted()
  void close() { parts_->close(); }

  /// Joins the parts of this run and of those that it resumes, and removes them.
  /// @throws std::runtime_error if a part is missing or incomplete, or the disk is full
  /// @pre wanted(), rank 0, closed
  void put_in_place(const std::string& header);

  /// Checks that all parts are complete, for a later run that resumes.
  /// @throws std::runtime_error if one is not
  /// @pre wanted(), rank 0, closed
  void require_parts() const { parts_->require(); }

 private:
  std::string name_;
  std::optional<OutputFile> whole_;
  std::optional<PartFiles> parts_;
};

}  // namespace kusabi::run
