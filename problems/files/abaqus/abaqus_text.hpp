// Lines of an Abaqus or CalculiX input file: keyword lines and data lines, without comments, with
// the files of *INCLUDE inserted.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_text.hpp"
#include "problems/files/meshes/mesh_texts.hpp"

namespace kusabi::problems {

/// Maximum depth of nested files.
inline constexpr int max_nested_files = 20;

/// Maximum number of files of a mesh, counting repeated inclusions.
inline constexpr int max_included_files = 1000;

/// A keyword line, such as "*ELEMENT, TYPE=C3D4, ELSET=body".
struct AbaqusCard {
  std::string keyword;  ///< in capitals, as in "*ELEMENT"
  /// Name in capitals and value as written; empty if there is none.
  std::vector<std::pair<std::string, std::string>> parameters;
  MeshPlace at;

  /// The value of a parameter; null if the line does not have it.
  const std::string* find(std::string_view name) const;
};

/// The text in capitals, as names are compared.
std::string capitals(std::string_view text);

class AbaqusText {
 public:
  /// @throws InputError if the file at `place` is not among `texts`
  AbaqusText(const MeshTexts& texts, const std::string& place);

  /// Goes to the next keyword line. @return false at the end
  /// @throws InputError at a data line, which belongs to no keyword
  bool next_card(AbaqusCard& card);

  /// Goes to the next line if it is a data line of the card.
  bool next_data();

  /// The current line.
  const MeshText& line() const { return *open_.back().text; }
  MeshPlace here() const { return {open_.back().file, line().number()}; }
  /// All files read so far.
  const std::vector<std::string>& files() const { return files_; }

  /// Adds a warning such as "*STEP is left out"; repeated ones are one warning.
  void warn(const std::string& what, MeshPlace at);
  /// All warnings in the order of their first lines: "FILE:LINE: *STEP is left out (3 times)".
  std::vector<std::string> warnings() const;

 private:
  struct Open {
    std::string place;
    int file;
    std::unique_ptr<MeshText> text;
  };

  bool next_line();
  void open(const std::string& place);
  void include();
  AbaqusCard card();

  const MeshTexts& texts_;
  std::vector<Open> open_;
  struct Warning {
    std::string what;
    MeshPlace at;  ///< of the first
    int count = 1;
  };

  std::vector<std::string> files_;
  std::vector<Warning> warnings_;
  int included_ = 0;
  bool put_back_ = false;
};

/// The names of the included files of a text, with their lines.
std::vector<std::pair<std::string, int>> abaqus_includes(std::string_view text,
                                                         const std::string& file);

}  // namespace kusabi::problems
