// The certificate that `kusabi patterns --certificate` writes (docs/certificates.md): what each
// rank saw proved is written at once to a part of its own, and when the search is over rank 0 puts
// the parts together. So it takes no memory, and what is killed loses nothing that a checkpoint
// has.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/output_file.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Goes between that and the nodes of a certificate that shows one feasible pattern and says
/// nothing of others.
inline constexpr const char* one_pattern_line = "one pattern\n";

/// All of a certificate before its nodes.
/// @param bounds that they use
std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               std::span<const wedged::ProvedBound> bounds = {});

/// A node of a certificate: its line, with the end of the line.
std::string certificate_line(const wedged::Evidence& evidence);

/// Puts the certificate of a search together that came to its end in an earlier run, or leaves it
/// as it is if that run has done so. On rank 0.
/// @param input as CertificateFile() @param tree fingerprint of the tree that was searched
/// @throws std::runtime_error if its parts are not there, or are of another tree
void put_earlier_certificate_in_place(const std::string& name, const std::string& input,
                                      std::uint64_t tree, const std::string& header);

/// A certificate that is being written, by all ranks together. Part `rank` of a run lies in
/// NAME.part.RUN.RANK until the certificate is in its place, and is locked while the rank lives.
/// Its first line says of which tree it is, and with which checkpoint it can go on.
class CertificateFile {
 public:
  /// Opens the files. An empty name: nothing will be written.
  /// @param input the problem file, which must not be the same
  /// @param tree fingerprint of the tree that is searched
  /// @param goes_on whether the search goes on from a checkpoint: then there must be parts of the
  ///        same tree already. Otherwise parts that nothing can go on from any more are removed,
  ///        and there must be no others
  /// @param checkpoint that the search keeps; empty: none
  /// @throws WrongInput on every rank alike; std::runtime_error if a rank cannot open its part
  CertificateFile(Session& session, const std::string& name, const std::string& input,
                  std::uint64_t tree, bool goes_on, const std::string& checkpoint = {});
  CertificateFile(const CertificateFile&) = delete;
  CertificateFile& operator=(const CertificateFile&) = delete;
  ~CertificateFile();

  [[nodiscard]] bool wanted() const { return !name_.empty(); }

  /// Writes a node down. A disk that is full is remembered until close().
  /// @pre wanted()
  void add(const wedged::Evidence& evidence);

  /// Ends this rank's part; every rank calls it, and it returns when all have.
  /// @pre wanted()
  void close();

  /// Puts the parts of this run and of those that it continues together, and removes them.
  /// @throws std::runtime_error if a part is missing or was not written in full, or the disk is
  /// full
  /// @pre wanted(), rank 0, closed
  void put_in_place(const std::string& header);

  /// What a search that goes on needs of the parts, which stay where they are.
  /// @throws std::runtime_error if one was not written in full
  /// @pre wanted(), rank 0, closed
  void require_parts() const;

  /// Removes all parts: nothing will go on from them.
  /// @pre wanted(), rank 0, closed
  void drop();

 private:
  std::string prepare(const std::string& input, bool goes_on, const std::string& own);
  void put(std::string_view text);  // into the part, as a whole unless the disk is full

  Session& session_;
  std::string name_;
  std::string tree_;  // how the first line of each part begins
  std::optional<OutputFile> whole_;
  std::string run_;
  int part_ = -1;        // a file descriptor
  bool failed_ = false;  // this part; after close() any
};

}  // namespace kusabi::run
