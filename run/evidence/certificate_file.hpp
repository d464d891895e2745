// CertificateFile: the certificate of `kusabi patterns --certificate` (docs/certificates.md). Each
// rank writes the evidence of closed nodes to a part of its own at once; rank 0 joins the parts at
// the end. Memory stays constant, and a killed run loses nothing that a checkpoint contains.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/output_file.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Separates the header from the nodes in a certificate that shows one feasible pattern and says
/// nothing about others.
inline constexpr const char* one_pattern_line = "one pattern\n";

/// Header of a certificate. @param bounds used by its nodes
std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               std::span<const wedged::ProvedBound> bounds = {});

/// A name in one line, with control characters as \x0a.
std::string one_line(const std::string& name);

/// ' ' and a hexadecimal number, for each number.
void append_numbers(std::string& text, std::span<const double> numbers);

/// Lines of the names and the friction of all candidates, of the blocks, and of the rigid-body
/// modes.
std::string candidate_lines(const problems::WedgedProblem& problem,
                            std::span<const double> friction);
std::string motion_lines(const problems::WedgedProblem& problem);

/// Line of a node, including its line end.
std::string certificate_line(const wedged::Evidence& evidence);

/// Joins the parts of a search that an earlier run has completed; leaves the certificate if that
/// run has joined them. On rank 0.
/// @param input as CertificateFile()
/// @param tree fingerprint of the searched tree
/// @throws std::runtime_error if parts are missing or belong to another tree
void put_earlier_certificate_in_place(const std::string& name, const std::string& input,
                                      std::uint64_t tree, const std::string& header);

/// A certificate written by all ranks together. Part `rank` of a run is NAME.part.RUN.RANK until
/// the certificate is complete, and is locked while the rank lives. Its first line identifies its
/// tree and the checkpoint that it belongs to.
class CertificateFile {
 public:
  /// Opens the files; none for an empty name.
  /// @param input the problem file, which must be another file
  /// @param tree fingerprint of the searched tree
  /// @param goes_on the search resumes from a checkpoint: parts of the same tree must exist.
  ///        Otherwise parts that no search can resume from are removed, and any others are an error
  /// @param checkpoint file that keeps the state of the search; empty: none
  /// @throws WrongInput on every rank; std::runtime_error if a rank cannot open its part
  CertificateFile(Session& session, const std::string& name, const std::string& input,
                  std::uint64_t tree, bool goes_on, const std::string& checkpoint = {});
  CertificateFile(const CertificateFile&) = delete;
  CertificateFile& operator=(const CertificateFile&) = delete;
  ~CertificateFile();

  [[nodiscard]] bool wanted() const { return !name_.empty(); }

  /// Writes a node. A full disk is reported by close(). @pre wanted()
  void add(const wedged::Evidence& evidence);

  /// Writes whole lines of another kind of certificate. @pre wanted()
  void add(std::string_view lines) { put(lines); }

  /// Closes this part; collective over all ranks. @pre wanted()
  void close();

  /// Joins the parts of this run and of those that it resumes, and removes them.
  /// @throws std::runtime_error if a part is missing or incomplete, or the disk is full
  /// @pre wanted(), rank 0, closed
  void put_in_place(const std::string& header);

  /// Checks that all parts are complete, for a later run that resumes.
  /// @throws std::runtime_error if one is not
  /// @pre wanted(), rank 0, closed
  void require_parts() const;

  /// Removes all parts, which no run will resume from. @pre wanted(), rank 0, closed
  void drop();

 private:
  std::string prepare(const std::string& input, bool goes_on, const std::string& own);
  void put(std::string_view text);  // whole lines unless the disk is full

  Session& session_;
  std::string name_;
  std::string tree_;  // beginning of the first line of each part
  std::optional<OutputFile> whole_;
  std::string run_;
  int part_ = -1;        // a file descriptor
  bool failed_ = false;  // of this part; after close() of any part
};

}  // namespace kusabi::run
