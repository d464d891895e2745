// The list of files and their bytes.
#include "problems/files/problem_text.hpp"

#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/draft/mesh_file.hpp"
#include "problems/files/matrices/matrix_file.hpp"
#include "problems/files/meshes/mesh_texts.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

namespace fs = std::filesystem;

/// Begins texts of some editors; TOML accepts it, too.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The bytes of a file; nothing if it cannot be read or would exceed the limit of the sum.
std::optional<std::string> bytes_of(const fs::path& file, std::uintmax_t maximum) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure || size > maximum) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// The files of one problem found so far.
class Collection {
 public:
  Collection(ProblemText& problem, const fs::path& file) : problem_(problem), file_(file) {}

  /// Adds the file at `place` and all files it includes.
  /// @param namer, position the file that names it, and the place there
  void add(const std::string& place, const std::string& namer, support::SourcePosition position,
           bool is_abaqus);

 private:
  ProblemText& problem_;
  fs::path file_;
  std::uintmax_t size_ = 0;
};

void Collection::add(const std::string& place, const std::string& namer,
                     support::SourcePosition position, bool is_abaqus) {
  if (problem_.meshes.contains(place)) return;
  const auto fail = [&](const std::string& message) {
    throw support::InputError(namer, position, message);
  };
  if (problem_.meshes.size() >= max_included_files) {
    fail(fmt::format("too many files; expected at most {}", max_included_files));
  }
  const fs::path path = file_.parent_path() / fs::path(place);
  auto bytes = bytes_of(path, largest_meshes - size_);
  if (!bytes) {
    fail(
        fmt::format("the file {} cannot be read, or all files have more than {} bytes; expected a "
                    "name relative to the folder of this file",
                    support::in_quotes(place), largest_meshes));
  }
  size_ += bytes->size();
  if (bytes->starts_with(byte_order_mark)) bytes->erase(0, byte_order_mark.size());
  const std::string& text = problem_.meshes.emplace(place, std::move(*bytes)).first->second;
  if (!is_abaqus) return;
  for (const auto& [name, line] : abaqus_includes(text, path.string())) {
    add(MeshTexts::place(place, name), path.string(), {line, 1}, true);
  }
}

/// The values of `file` in a section, with their places; none if the file is not a valid problem
/// file, which is reported later by the reader.
/// @param name_in rule for such a name
template <class Rule>
std::vector<TomlText> file_names(const ProblemText& problem, const std::string& file,
                                 std::string_view section_name, const Rule& name_in) {
  std::vector<TomlText> names;
  try {
    const TomlReader reader(problem.toml, file);
    const auto* section = reader.root().table->get(section_name);
    if (section == nullptr) return names;
    for (const TomlTable& group : reader.groups(*section, section_name)) {
      const auto* name = group.table->get("file");
      if (name != nullptr) names.push_back(name_in(reader, *name));
    }
  } catch (const support::InputError&) {
    names.clear();
  }
  return names;
}

}  // namespace

ProblemText deck_text(const std::filesystem::path& file) {
  ProblemText problem;
  Collection(problem, file).add(file.filename().string(), file.string(), {}, true);
  return problem;
}

ProblemText problem_text(const std::filesystem::path& file) {
  ProblemText problem{file_text(file), {}};
  Collection files(problem, file);
  for (const TomlText& name : file_names(problem, file.string(), "mesh", mesh_file_name)) {
    files.add(MeshTexts::place("", name.text), file.string(), name.position,
              is_abaqus_file(name.text));
  }
  for (const TomlText& name : file_names(problem, file.string(), "stiffness", matrix_file_name)) {
    const auto place = MeshTexts::place("", name.text);
    files.add(place, file.string(), name.position, false);
    if (const auto rows = rows_file_of(place); !rows.empty())
      files.add(rows, file.string(), name.position, false);
  }
  return problem;
}

}  // namespace kusabi::problems
