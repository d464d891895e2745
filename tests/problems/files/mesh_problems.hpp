// Problems on meshes for tests: their texts, with the bytes of the mesh files.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "problems/files/problem_text.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

/// The bytes of a file of the sources.
std::string content(const std::string& path);

/// The lines of expected.txt in a folder of malformed files, FILE:LINE:COLUMN: fault.
std::vector<std::string> promises(const std::string& folder);

/// The file of such a line.
std::string promised_file(const std::string& promise);

/// The name of the test of such a line: its file, with _ for all but letters and digits.
std::string parameter_name(const testing::TestParamInfo<std::string>& promise);

/// Expects a line for each file of the folder, of which there are more than fifty.
void expect_all_listed(const std::string& folder);

/// The keys name, dimension and units.
std::string head(int dimension);

/// A [[mesh]] "m" of a file in tests/meshes, with a material.
std::string mesh_of(const std::string& file, int dimension);

/// A problem whose mesh files are those of tests/meshes that the text names.
ProblemText with_meshes(const std::string& toml);

Structure read(const std::string& toml);

/// The message of reading it; "no error" if it is valid.
std::string error_of(const ProblemText& problem);

}  // namespace kusabi::problems::test
