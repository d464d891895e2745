// Joining of the parts into one file with a digest.
#include "run/evidence/certificate_file.hpp"

#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support/sha1.hpp"

namespace kusabi::run {
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
  std::string line;
  for (const auto& part : parts) {
    std::ifstream file(part, std::ios::binary);
    if (!file) throw std::runtime_error(part + ": cannot be read");
    next_line(file, line);  // fingerprint of its tree
    while (next_line(file, line)) {
      writer.add(line + '\n');
      ++count;
    }
  }
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
