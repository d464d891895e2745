// Calls of each reader and of the next step of the command; checksums are recomputed before.
#include "readers.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <typeinfo>
#include <utility>

#include <boost/crc.hpp>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "engine/wire.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/program_file.hpp"
#include "support/input_error.hpp"
#include "support/sha1.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/cover.hpp"

namespace kusabi::fuzz {
namespace {

namespace fs = std::filesystem;

// A folder of this process alone, for readers that want a file; removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "kusabi-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the fuzzer");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code nothing_to_be_done;
    fs::remove_all(path_, nothing_to_be_done);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

const Folder& folder() {
  static const Folder own;
  return own;
}

void write(const std::string& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

// An answer must be one line of a bounded length.
void check_line(const std::string& line) {
  constexpr std::size_t longest = 2000;
  if (line.empty() || line.size() > longest || line.find('\n') != std::string::npos) {
    throw Defect("not one line: " + line);
  }
}

// The error of `read`.
template <class Error, class Read>
std::optional<std::string> refusal(Read read) {
  try {
    read();
    return std::nullopt;
  } catch (const Error& error) {
    std::string line = error.what();
    check_line(line);
    return line;
  } catch (const Defect&) {
    throw;
  } catch (const std::exception& other) {
    throw Defect(std::string("not the reader's error: ") + other.what());
  }
}

std::optional<std::string> try_structure(const std::string& bytes) {
  // The rest takes time of the cube of the size.
  constexpr std::size_t max_nodes = 60;
  std::optional<problems::Structure> structure;
  auto refused = refusal<support::InputError>(
      [&] { structure = problems::read_structure(bytes, "fuzzed.toml"); });
  if (refused || structure->node_names.size() > max_nodes) return refused;
  refused = refusal<support::InputError>([&] { problems::wedged_problem(checked(*structure)); });
  const auto other =
      refusal<support::InputError>([&] { problems::limit_problem(checked(*structure)); });
  return refused && other ? refused : std::nullopt;
}

std::optional<std::string> try_mesh(const std::string& bytes, const std::string& name,
                                    int dimension) {
  constexpr std::size_t max_nodes = 60;
  problems::ProblemText problem;
  problem.toml = "name = \"fuzzed\"\ndimension = " + std::to_string(dimension) +
                 "\nunits = { length = \"m\", force = \"kN\" }\n[[mesh]]\nname = \"m\"\nfile = \"" +
                 name + "\"\nE = 1.0\nnu = 0.25\n" +
                 (dimension == 2 ? "thickness = 1.0\nplane = \"stress\"\n" : "") +
                 "[[supports]]\nnodes = [\"m.1\"]\n[[contact]]\nnodes = [\"m.2\"]\n"
                 "normal = \"surface\"\n";
  problem.meshes[name] = bytes;
  std::optional<problems::Structure> structure;
  const auto refused = refusal<support::InputError>(
      [&] { structure = problems::read_structure(problem, "fuzzed.toml"); });
  if (refused || structure->node_names.size() > max_nodes) return refused;
  for (const auto& warning : structure->warnings) check_line(warning);
  refusal<support::InputError>([&] { problems::wedged_problem(checked(*structure)); });
  return std::nullopt;
}

std::optional<std::string> try_mesh(const std::string& bytes, const std::string& name) {
  const auto plane = try_mesh(bytes, name, 2);
  const auto space = try_mesh(bytes, name, 3);
  return plane ? space : plane;
}

// The bytes as each kind of matrix file.
std::optional<std::string> try_matrix(const std::string& bytes) {
  const auto as = [&](const std::string& name, const std::string& rows) {
    problems::ProblemText problem;
    problem.toml =
        "name = \"fuzzed\"\ndimension = 2\nunits = { length = \"m\", force = \"kN\" }\n"
        "[nodes]\n1 = [0, 0]\n2 = [1, 0]\n[[contact]]\nnodes = [\"1\"]\nnormal = [0, 1]\n"
        "[[stiffness]]\nfile = \"" +
        name + "\"\n" + rows;
    problem.meshes[name] = bytes;
    problem.meshes["k.dof"] = "1.1\n1.2\n2.1\n2.2\n";
    std::optional<problems::Structure> structure;
    auto refused = refusal<support::InputError>(
        [&] { structure = problems::read_structure(problem, "fuzzed.toml"); });
    if (refused) return refused;
    for (const auto& warning : structure->warnings) check_line(warning);
    return refusal<support::InputError>([&] { problems::wedged_problem(checked(*structure)); });
  };
  const auto listed = as("k.mtx", "nodes = [\"1\", \"2\"]\n");
  const auto named = as("k.mtx", "others = \"free\"\n");
  const auto stored = as("k.sti", "");
  return listed && named ? stored : std::nullopt;
}

void require(bool holds, const char* what) {
  if (!holds) throw Defect(what);
}

void check(const linear::MixedProgram& mixed) {
  const auto& program = mixed.program;
  require(std::isfinite(program.constant), "a constant that is no number");
  for (const auto& column : program.columns) {
    require(std::isfinite(column.cost), "a cost that is no number");
    require(column.lower <= column.upper, "bounds of a column that cross, or are no numbers");
    require(column.lower < linear::infinity && column.upper > -linear::infinity,
            "bounds of a column that leave no number");
  }
  for (const auto& row : program.rows) {
    require(row.lower <= row.upper, "bounds of a row that cross, or are no numbers");
    require(row.lower < linear::infinity && row.upper > -linear::infinity,
            "bounds of a row that leave no number");
  }
  std::set<std::pair<int, int>> places;
  for (const auto& entry : program.entries) {
    require(std::isfinite(entry.value), "an entry that is no number");
    require(static_cast<std::size_t>(entry.row) < program.rows.size() &&
                static_cast<std::size_t>(entry.column) < program.columns.size(),
            "an entry outside of the matrix");
    require(places.emplace(entry.row, entry.column).second, "two entries in one place");
  }
  std::set<int> binaries;
  for (const int binary : mixed.binaries) {
    require(static_cast<std::size_t>(binary) < program.columns.size(), "a binary of no column");
    require(binaries.insert(binary).second, "a binary that is listed twice");
    const auto& column = program.columns[static_cast<std::size_t>(binary)];
    require(column.lower >= 0 && column.upper <= 1, "a binary with bounds outside of [0, 1]");
  }
}

// A program that the first rank has read is sent to the others; ambiguous lines give warnings.
void check(const linear::ProgramFile& program) {
  check(program.mixed);
  for (const auto& warning : program.warnings) check_line(warning);
  const auto sent = engine::pack(program);
  require(sent == engine::pack(engine::unpack<linear::ProgramFile>(sent)),
          "a program that changes on its way");
}

std::optional<std::string> try_program(const std::string& bytes, const char* name) {
  const auto file = folder().file(name);
  write(file, bytes);
  return refusal<support::InputError>([&] { check(linear::read_program(file)); });
}

std::optional<std::string> try_certificate(const std::string& bytes) {
  return refusal<verify::CertificateError>([&] {
    if (bytes.starts_with(verify::truss_first_line)) {
      const auto theorems = verify::read_truss_certificate(bytes, "fuzzed");
      const auto text = verify::truss_certificate_text(theorems);
      require(
          text == verify::truss_certificate_text(verify::read_truss_certificate(text, "fuzzed")),
          "a certificate that changes when it is written");
    } else {
      const auto certificate = verify::read_certificate(bytes, "fuzzed");
      for (std::size_t theorem = 0; theorem < certificate.theorems.size(); ++theorem)
        static_cast<void>(verify::flaw_of_cover(certificate, theorem));
    }
  });
}

std::optional<std::string> try_checkpoint(const std::string& bytes) {
  const auto file = folder().file("state");
  const auto line_end = bytes.find('\n');
  if (line_end == std::string::npos) {
    write(file, bytes);
    return refusal<engine::CheckpointError>([&] { engine::read_manifest(file); });
  }
  write(file, std::string_view(bytes).substr(0, line_end + 1));
  return refusal<engine::CheckpointError>([&] {
    const auto manifest = engine::read_manifest(file);
    const auto part = file + "." + std::to_string(manifest.epoch) + "." + std::to_string(0);
    write(part, std::string_view(bytes).substr(line_end + 1));
    // The resumed search compares them; here only the types differ.
    engine::Manifest own = manifest;
    own.node = own.solution = typeid(int).name();
    refusal<engine::CheckpointError>([&] { engine::expect_same_search(file, manifest, own); });
    std::string warning;
    try {
      static_cast<void>(engine::usable_checkpoint(file, manifest.problem, warning));
      engine::remove_leftovers(file);
    } catch (...) {
      fs::remove(part);
      throw;
    }
    fs::remove(part);
  });
}

void repair_digest(std::string& bytes) {
  const auto at = bytes.rfind("\ndigest ");
  if (at == std::string::npos) return;
  bytes.resize(at + 1);
  bytes += "digest " + support::hexadecimal(support::sha1(bytes)) + '\n';
}

std::string checksummed(std::string header, const std::string& body) {
  const auto last = header.rfind(' ');
  if (last != std::string::npos) header.resize(last);
  boost::crc_32_type crc;
  crc.process_bytes(header.data(), header.size());
  crc.process_bytes(body.data(), body.size());
  return header + ' ' + std::to_string(crc.checksum()) + '\n' + body;
}

void repair_checksums(std::string& bytes) {
  const auto manifest_end = bytes.find('\n');
  if (manifest_end == std::string::npos) return;
  const auto part = bytes.substr(manifest_end + 1);
  auto repaired = checksummed(bytes.substr(0, manifest_end), "");
  const auto header_end = part.find('\n');
  repaired += header_end == std::string::npos
                  ? part
                  : checksummed(part.substr(0, header_end), part.substr(header_end + 1));
  bytes = repaired;
}

}  // namespace

std::string name_of(Reader reader) {
  switch (reader) {
    case Reader::structure:
      return "structure";
    case Reader::gmsh:
      return "gmsh";
    case Reader::abaqus:
      return "abaqus";
    case Reader::matrix:
      return "matrix";
    case Reader::mps:
      return "mps";
    case Reader::lp:
      return "lp";
    case Reader::certificate:
      return "certificate";
    case Reader::checkpoint:
      return "checkpoint";
  }
  return {};
}

std::optional<Reader> reader_named(std::string_view name) {
  for (const auto reader : readers) {
    if (name == name_of(reader)) return reader;
  }
  return std::nullopt;
}

std::optional<std::string> try_reader(Reader reader, const std::string& bytes) {
  switch (reader) {
    case Reader::structure:
      return try_structure(bytes);
    case Reader::gmsh:
      return try_mesh(bytes, "fuzzed.msh");
    case Reader::abaqus:
      return try_mesh(bytes, "fuzzed.inp");
    case Reader::matrix:
      return try_matrix(bytes);
    case Reader::mps:
      return try_program(bytes, "fuzzed.mps");
    case Reader::lp:
      return try_program(bytes, "fuzzed.lp");
    case Reader::certificate:
      return try_certificate(bytes);
    case Reader::checkpoint:
      return try_checkpoint(bytes);
  }
  return std::nullopt;
}

void repair(Reader reader, std::string& bytes) {
  if (reader == Reader::certificate) repair_digest(bytes);
  if (reader == Reader::checkpoint) repair_checksums(bytes);
}

}  // namespace kusabi::fuzz
