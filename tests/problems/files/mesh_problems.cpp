#include "tests/problems/files/mesh_problems.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "problems/files/structure_file.hpp"
#include "support/input_error.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems::test {

std::string content(const std::string& path) {
  std::ifstream stream(source_path(path), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> promises(const std::string& folder) {
  std::istringstream stream(content(folder + "/expected.txt"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string promised_file(const std::string& promise) {
  return promise.substr(0, promise.find(':'));
}

std::string parameter_name(const testing::TestParamInfo<std::string>& promise) {
  std::string name = promised_file(promise.param);
  std::ranges::replace_if(
      name, [](unsigned char character) { return std::isalnum(character) == 0; }, '_');
  return name;
}

void expect_all_listed(const std::string& folder) {
  std::set<std::string> promised{"expected.txt"};
  for (const auto& promise : promises(folder)) promised.insert(promised_file(promise));
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_path(folder)))
    files.insert(entry.path().filename().string());
  EXPECT_EQ(files, promised);
  EXPECT_GT(files.size(), 50U);
}

std::string head(int dimension) {
  return "name = \"test\"\ndimension = " + std::to_string(dimension) +
         "\nunits = { length = \"m\", force = \"kN\" }\n";
}

std::string mesh_of(const std::string& file, int dimension) {
  std::string text = "[[mesh]]\nname = \"m\"\nfile = \"" + file + "\"\nE = 1.0\nnu = 0.25\n";
  if (dimension == 2) text += "thickness = 1.0\nplane = \"stress\"\n";
  return text;
}

ProblemText with_meshes(const std::string& toml) {
  ProblemText problem{toml, {}};
  for (const auto& entry : std::filesystem::directory_iterator(source_path("tests/meshes"))) {
    const auto name = entry.path().filename().string();
    if (toml.find('"' + name + '"') != std::string::npos) {
      problem.meshes[name] = content("tests/meshes/" + name);
    }
  }
  return problem;
}

Structure read(const std::string& toml) {
  return read_structure(with_meshes(toml), "test.toml");
}

std::string error_of(const ProblemText& problem) {
  try {
    read_structure(problem, "test.toml");
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace kusabi::problems::test
