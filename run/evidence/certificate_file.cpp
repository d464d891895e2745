// Lines of evidence, and the joining of the parts into one file with a digest.
#include "run/evidence/certificate_file.hpp"

#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/wedged/free_stiffness.hpp"
#include "problems/wedged/problem_block.hpp"
#include "support/one_line.hpp"
#include "support/sha1.hpp"

namespace kusabi::run {

namespace {

template <class Numbers>
void append(std::string& text, const Numbers& numbers) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(text), " {:a}", number);
}

void append_bound(std::string& text, const wedged::ProvedBound& bound) {
  const auto* const side = bound.side == wedged::Side::contact ? "contact" : "separated";
  const auto* const kind = bound.excludes_side() ? "never" : "bound";
  text += fmt::format("{} {} {} {}", kind, bound.theorem + 1, bound.candidate, side);
  if (!bound.excludes_side()) text += fmt::format(" {:a}", bound.maximum);
  append(text, bound.numbers);
  text += '\n';
}

const char* kind_name(wedged::Evidence::Kind kind) {
  using Kind = wedged::Evidence::Kind;
  switch (kind) {
    case Kind::infeasible:
      return "infeasible";
    case Kind::cut:
      return "cut";
    case Kind::form:
      return "form";
    case Kind::feasible:
      return "wedged";
    case Kind::no_claim:
      break;
  }
  return "marginal";
}

// Names and friction of all candidates, and the blocks.
std::string candidate_lines(const problems::WedgedProblem& problem,
                            std::span<const double> friction) {
  auto text =
      fmt::format("dimension {}\ncandidates {}\n", problem.dimension, problem.contact_names.size());
  for (const auto& name : problem.contact_names)
    text += fmt::format("name {}\n", support::on_one_line(name));
  text += "friction";
  append(text, friction);
  const auto blocks = problems::blocks_of(problem);
  text += fmt::format("\nblocks {}\n", blocks.size());
  for (const auto& block : blocks) text += fmt::format("block {}\n", support::hexadecimal(block));
  return text;
}

// The rigid-body modes.
std::string motion_lines(const problems::WedgedProblem& problem) {
  const auto& motions = problem.modes.matrix;
  auto text = fmt::format("motions {}\n", motions.cols());
  for (Eigen::Index i = 0; i < motions.rows() && motions.cols() > 0; ++i) {
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      text += fmt::format("{}{:a}", k == 0 ? "" : " ", motions(i, k));
    text += '\n';
  }
  return text;
}

std::string stiffness_lines(const problems::WedgedProblem& problem) {
  std::string text = "stiffness\n";
  const auto stiffness = problems::free_stiffness(problem);
  for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      text += fmt::format("{}{:a}", j == 0 ? "" : " ", stiffness(i, j));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

void append_numbers(std::string& text, std::span<const double> numbers) {
  append(text, numbers);
}

std::vector<std::string> list_theorems(const problems::WedgedProblem& problem) {
  std::vector<std::string> lines;
  for (std::size_t block = 1; block <= problems::blocks_of(problem).size(); ++block)
    lines.push_back(fmt::format("none {} 0\n", block));
  return lines;
}

std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               const std::vector<std::string>& theorems,
                               std::span<const wedged::ProvedBound> bounds,
                               const std::string& load_lines) {
  auto text = "kusabi certificate 5 contact\n" + candidate_lines(problem, friction) +
              stiffness_lines(problem) + motion_lines(problem) + load_lines +
              fmt::format("theorems {}\n", theorems.size());
  for (const auto& theorem : theorems) text += theorem;
  text += fmt::format("bounds {}\n", bounds.size());
  for (const auto& bound : bounds) append_bound(text, bound);
  return text + "evidence\n";
}

std::string certificate_line(const wedged::Evidence& evidence) {
  auto line = fmt::format("{} {} {} {}", kind_name(evidence.kind), evidence.block + 1,
                          support::hexadecimal(evidence.node.contact),
                          support::hexadecimal(evidence.node.separated));
  append(line, evidence.numbers);
  return line + '\n';
}

namespace {

// Writes the text and adds it to the digest.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  void add(std::string_view text) {
    out_ << text;
    digest_.add(text);
  }

  void end() { out_ << "digest " << support::hexadecimal(digest_.digest()) << '\n'; }

 private:
  std::ostream& out_;
  support::Sha1Stream digest_;
};

// Concatenates all parts into one file.
void write_whole(OutputFile& whole, const std::string& header,
                 const std::vector<std::string>& parts) {
  Writer writer(whole.stream());
  writer.add(header);
  std::uint64_t count = 0;
  read_parts(parts, [&](std::string_view line) {
    writer.add(line);
    writer.add("\n");
    ++count;
  });
  writer.add(fmt::format("end {}\n", count));
  writer.end();
  whole.put_in_place();
}

// True if a file is a complete certificate with this beginning.
bool is_whole(const std::string& name, const std::string& header) {
  std::ifstream file(name, std::ios::binary);
  std::string beginning(header.size(), '\0');
  if (!file.read(beginning.data(), static_cast<std::streamsize>(beginning.size())) ||
      beginning != header) {
    return false;
  }
  support::Sha1Stream digest;
  digest.add(header);
  std::string line;
  while (next_line(file, line)) {
    if (line == "digest " + support::hexadecimal(digest.digest())) return true;
    digest.add(line + '\n');
  }
  return false;
}

PartsOwner owner(const std::string& name, std::uint64_t tree, const std::string& checkpoint = {}) {
  return {.option = "--certificate",
          .name = name,
          .content = "the evidence",
          .tree = tree,
          .checkpoint = checkpoint};
}

}  // namespace

CertificateFile::CertificateFile(Session& session, const std::string& name,
                                 const std::string& input, std::uint64_t tree, bool goes_on,
                                 const std::string& checkpoint)
    : name_(name) {
  if (!wanted()) return;
  auto own = owner(name_, tree, checkpoint);
  session.from_first_rank([&] {
    require_file_name(own);
    whole_.emplace(own.option, name_, input);
  });
  parts_.emplace(session, std::move(own), goes_on);
}

void CertificateFile::add(const wedged::Evidence& evidence) {
  parts_->put(certificate_line(evidence));
}

void CertificateFile::put_in_place(const std::string& header) {
  write_whole(*whole_, header, parts_->all());
  remove_parts(name_);
}

void put_earlier_certificate_in_place(const std::string& name, const std::string& input,
                                      std::uint64_t tree, const std::string& header) {
  if (!is_whole(name, header)) {
    const auto parts = parts_of_finished(owner(name, tree));
    if (parts.empty()) {
      throw std::runtime_error(
          fmt::format("{}: neither the certificate nor its parts exist; expected one of them, or "
                      "another --resume",
                      name));
    }
    OutputFile whole("--certificate", name, input);
    write_whole(whole, header, parts);
  }
  remove_parts(name);
}

}  // namespace kusabi::run
