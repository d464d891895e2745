// Parts by plain writes, a whole line at a time; and how they are found again.
#include "run/evidence/certificate_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "engine/together.hpp"
#include "problems/wedged/free_stiffness.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/output/values.hpp"
#include "support/sha1.hpp"

namespace kusabi::run {

namespace fs = std::filesystem;

namespace {

// A name of one line, whatever it holds.
std::string one_line(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    text += control ? fmt::format("\\x{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return text;
}

template <class Numbers>
void append(std::string& text, const Numbers& numbers) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(text), " {:a}", number);
}

struct Part {
  unsigned run = 0;
  unsigned rank = 0;
  std::string file;
};

std::string part_name(const std::string& name, std::string_view run, int rank) {
  return fmt::format("{}.part.{}.{}", name, run, rank);
}

// All parts of a certificate, in the order of their runs and ranks.
std::vector<Part> parts_of(const std::string& name) {
  std::vector<Part> parts;
  const auto place = fs::absolute(name);
  const auto prefix = place.filename().string() + ".part.";
  for (const auto& entry : fs::directory_iterator(place.parent_path())) {
    const auto file = entry.path().filename().string();
    if (!file.starts_with(prefix)) continue;
    Part part;
    const char* const last = file.data() + file.size();
    const auto run = std::from_chars(file.data() + prefix.size(), last, part.run);
    if (run.ec != std::errc{} || run.ptr == last || *run.ptr != '.') continue;
    const auto rank = std::from_chars(run.ptr + 1, last, part.rank);
    if (rank.ec != std::errc{} || rank.ptr != last) continue;
    part.file = name + file.substr(prefix.size() - std::string_view(".part.").size());
    parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.run != b.run ? a.run < b.run : a.rank < b.rank;
  });
  return parts;
}

// The next line without its end. A line without an end, of a run that was killed, is none.
bool next_line(std::istream& file, std::string& line) {
  return static_cast<bool>(std::getline(file, line)) && !file.eof();
}

std::string first_line(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::string line;
  return next_line(file, line) ? line : std::string{};
}

constexpr std::string_view of_checkpoint = " of the checkpoint ";

// The checkpoint that a part can go on with, if it is still there.
std::string checkpoint_of(const std::string& part) {
  const auto line = first_line(part);
  const auto at = line.find(of_checkpoint);
  if (at == std::string::npos) return {};
  auto checkpoint = line.substr(at + of_checkpoint.size());
  return engine::checkpoint_exists(checkpoint) ? checkpoint : std::string{};
}

bool is_being_written(const std::string& part) {
  const int descriptor = open(part.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

// Writes the text and takes it into the digest.
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

}  // namespace

namespace {

// The oldest that can say it.
int version_of(const problems::WedgedProblem& problem,
               std::span<const wedged::ProvedBound> bounds) {
  if (!bounds.empty()) return 4;
  return problem.motions.cols() == 0 ? 2 : 3;
}

void append_bound(std::string& text, const wedged::ProvedBound& bound) {
  const auto* const side = bound.side == wedged::Side::contact ? "contact" : "separated";
  const auto* const kind = bound.never() ? "never" : "bound";
  text += fmt::format("{} {} {} {}", kind, bound.block + 1, bound.candidate, side);
  if (!bound.never()) text += fmt::format(" {:a}", bound.most);
  append(text, bound.numbers);
  text += '\n';
}

const char* kind_name(wedged::Evidence::Kind kind) {
  using Kind = wedged::Evidence::Kind;
  switch (kind) {
    case Kind::dead:
      return "dead";
    case Kind::cut:
      return "cut";
    case Kind::alive:
      return "alive";
    case Kind::marginal:
      break;
  }
  return "marginal";
}

}  // namespace

std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               std::span<const wedged::ProvedBound> bounds) {
  const auto& motions = problem.motions;
  auto text =
      fmt::format("kusabi certificate {}\ndimension {}\ncandidates {}\n",
                  version_of(problem, bounds), problem.dimension, problem.contact_names.size());
  for (const auto& name : problem.contact_names) text += fmt::format("name {}\n", one_line(name));
  text += "friction";
  append(text, friction);
  const auto blocks = problems::blocks_of(problem);
  text += fmt::format("\nblocks {}\n", blocks.size());
  for (const auto& block : blocks) text += fmt::format("block {}\n", support::hexadecimal(block));
  text += "stiffness\n";
  const auto stiffness = problems::free_stiffness(problem);
  for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      text += fmt::format("{}{:a}", j == 0 ? "" : " ", stiffness(i, j));
    }
    text += '\n';
  }
  if (motions.cols() > 0 || !bounds.empty()) text += fmt::format("motions {}\n", motions.cols());
  for (Eigen::Index i = 0; i < motions.rows() && motions.cols() > 0; ++i) {
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      text += fmt::format("{}{:a}", k == 0 ? "" : " ", motions(i, k));
    text += '\n';
  }
  if (!bounds.empty()) text += fmt::format("bounds {}\n", bounds.size());
  for (const auto& bound : bounds) append_bound(text, bound);
  return text + "nodes\n";
}

std::string certificate_line(const wedged::Evidence& evidence) {
  auto line = fmt::format("{} {} {} {}", kind_name(evidence.kind), evidence.block + 1,
                          support::hexadecimal(evidence.node.contact),
                          support::hexadecimal(evidence.node.separated));
  append(line, evidence.numbers);
  return line + '\n';
}

CertificateFile::CertificateFile(Session& session, const std::string& name,
                                 const std::string& input, std::uint64_t tree, bool goes_on,
                                 const std::string& checkpoint)
    : session_(session), name_(name), tree_("part of the tree " + hexadecimal(tree)) {
  if (!wanted()) return;
  run_ = session.from_first_rank([&] { return prepare(input, goes_on); });
  const auto file = part_name(name_, run_, session.transport().rank());
  constexpr mode_t for_all = 0666;
  part_ = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, for_all);
  if (part_ < 0) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file, std::strerror(errno)));
  }
  flock(part_, LOCK_EX | LOCK_NB);
  const auto state = checkpoint.empty() ? std::string{} : fs::absolute(checkpoint).string();
  put(state.empty() ? tree_ + '\n' : fmt::format("{}{}{}\n", tree_, of_checkpoint, state));
}

CertificateFile::~CertificateFile() {
  if (part_ >= 0) ::close(part_);
}

// @return a number for this run's parts that is still free
std::string CertificateFile::prepare(const std::string& input, bool goes_on) {
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("--certificate {}: {}", name_, why));
  };
  std::error_code error;
  const auto kind = fs::status(name_, error).type();
  if (kind != fs::file_type::not_found && kind != fs::file_type::regular) {
    refuse("is a device or a pipe, expected a file name");
  }
  whole_.emplace("--certificate", name_, input);
  const auto parts = parts_of(name_);
  for (const auto& part : parts) {
    if (is_being_written(part.file)) {
      refuse(
          fmt::format("{} is being written by another search; expected another name", part.file));
    }
    const auto checkpoint = goes_on ? std::string{} : checkpoint_of(part.file);
    if (!checkpoint.empty()) {
      refuse(
          fmt::format("{} is in the way, a part of a search that did not end; expected --restart "
                      "{} to go on with it, or a new name",
                      part.file, checkpoint));
    }
  }
  const unsigned run = parts.empty() ? 1 : parts.back().run + 1;
  if (!goes_on) {
    drop();
    return std::to_string(run);
  }
  if (parts.empty()) {
    refuse(
        fmt::format("there is no {}.part.*, so what the search has proved so far is not known; "
                    "expected the name that it began with",
                    name_));
  }
  for (const auto& part : parts) {
    const auto line = first_line(part.file);
    // A part without a whole line was killed before it had begun.
    if (!line.empty() && !line.starts_with(tree_)) {
      refuse(fmt::format("{} belongs to another problem, friction or tolerance", part.file));
    }
  }
  return std::to_string(run);
}

void CertificateFile::add(const wedged::Evidence& evidence) {
  put(certificate_line(evidence));
}

void CertificateFile::put(std::string_view text) {
  while (!text.empty() && !failed_) {
    const auto written = write(part_, text.data(), text.size());
    if (written >= 0) text.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) failed_ = true;
  }
}

void CertificateFile::close() {
  if (::close(part_) != 0) failed_ = true;
  part_ = -1;
  engine::Survey own{.ranks = 1};
  if (failed_) own.wishes = engine::wish_failed;
  failed_ = (engine::meet(session_.transport(), own).wishes & engine::wish_failed) != 0;
}

void CertificateFile::require_parts() const {
  if (!failed_) return;
  throw std::runtime_error(
      fmt::format("{}: a part could not be written in full; is the disk full?", name_));
}

void CertificateFile::put_in_place(const std::string& header) {
  require_parts();
  const auto parts = parts_of(name_);
  const auto own = std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return std::to_string(part.run) == run_;
  });
  if (own != session_.ranks()) {
    throw std::runtime_error(
        fmt::format("{}: {} parts expected, {} found; do all ranks write to the same folder?",
                    name_, session_.ranks(), own));
  }
  Writer writer(whole_->stream());
  writer.add(header);
  std::uint64_t count = 0;
  std::string line;
  for (const auto& part : parts) {
    std::ifstream file(part.file, std::ios::binary);
    if (!file) throw std::runtime_error(part.file + ": cannot be read");
    next_line(file, line);  // of which tree
    while (next_line(file, line)) {
      writer.add(line + '\n');
      ++count;
    }
  }
  writer.add(fmt::format("end {}\n", count));
  writer.end();
  whole_->put_in_place();
  drop();
}

void CertificateFile::drop() {
  std::error_code nothing_to_be_done;
  for (const auto& part : parts_of(name_)) fs::remove(part.file, nothing_to_be_done);
}

}  // namespace kusabi::run
