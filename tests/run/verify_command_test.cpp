// `kusabi verify` as a user calls it: for the certificate alone, and for the structure of a problem
// file.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shell.hpp"

namespace {

namespace fs = std::filesystem;
using kusabi::test::command;
using kusabi::test::quoted;
using kusabi::test::shell;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string example_file(const std::string& name) {
  return std::string(KUSABI_SOURCE_DIR) + "/examples/" + name;
}

std::string given_certificate(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/verify/certificates/" + name);
}

class VerifyCommand : public kusabi::test::Command {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return in_folder(name); }

  // Searches and writes the certificate.
  [[nodiscard]] std::string certificate_of(const std::string& file, double mu) const {
    const auto name = quoted(path(fmt::format("{}-{}.cert", fs::path(file).stem().string(), mu)));
    const auto run = shell(fmt::format("{} patterns {} --mu {} --quiet --certificate {}", command,
                                       quoted(file), mu, name));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return name;
  }

  // An example with one change.
  [[nodiscard]] std::string changed(const std::string& example, const std::string& what,
                                    const std::string& with) const {
    std::ifstream file(example_file(example));
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const auto place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    text.replace(place, what.size(), with);
    std::ofstream(path("changed.toml")) << text;
    return path("changed.toml");
  }

  [[nodiscard]] static auto verify(const std::string& certificate, const std::string& file) {
    return shell(fmt::format("{} verify {} --problem {}", command, certificate, quoted(file)));
  }
};

TEST_F(VerifyCommand, ProvesGenuineCertificatesForTheProblemFile) {
  struct Row {
    const char* example;
    double mu;
    const char* patterns;
  };
  const Row table[] = {{"two-bars.toml", 1.9, "the list of 0 patterns"},
                       {"two-bars.toml", 2.1, "the list of 1 pattern "},
                       {"plane-truss.toml", 1, "the list of 11 patterns"},
                       {"space-truss.toml", 0.65, "the list of 27 patterns"},
                       {"elastic-body.toml", 0.7, "PROVED: the list of"},
                       {"peg-in-hole.toml", 0.25, "the list of 0 patterns"},
                       {"peg-in-hole.toml", 0.26, "PROVED: the list of"},
                       {"brick-by-calculix.toml", 0.502, "the list of 0 patterns"},
                       {"brick-by-calculix.toml", 0.503, "the list of 2 patterns"},
                       {"snap-hook.toml", 0.3935, "the list of 0 patterns"},
                       {"snap-hook.toml", 0.3945, "the list of 1 pattern "}};
  for (const auto& [example, mu, patterns] : table) {
    const auto certificate = certificate_of(example_file(example), mu);
    const auto run = verify(certificate, example_file(example));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr(patterns), HasSubstr("problem: "), HasSubstr("fingerprint "),
                      HasSubstr(fmt::format("friction coefficient: {}", mu)),
                      HasSubstr("K was recomputed from the structure with errors up to ")));
    // Without a problem file the output states that the stiffness is that of the certificate.
    const auto own = shell(command + " verify " + certificate);
    EXPECT_EQ(own.exit_code, 0);
    EXPECT_THAT(own.output, AllOf(HasSubstr(patterns), HasSubstr("those of the certificate")));
    EXPECT_THAT(own.output, Not(HasSubstr("recomputed")));
  }
}

TEST_F(VerifyCommand, AForgedStiffnessIsRefused) {
  const auto forged = given_certificate("forged-decoupled-K.cert");
  const auto run = verify(forged, example_file("plane-truss.toml"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, AllOf(HasSubstr("refused: "),
                                HasSubstr("K of the certificate is not that of the structure"),
                                HasSubstr("NOT PROVED")));
}

TEST_F(VerifyCommand, AnotherProblemFileIsRefused) {
  const auto certificate = certificate_of(example_file("two-bars.toml"), 3);
  struct Row {
    const char* what;
    const char* with;
    const char* said;
  };
  const Row table[] = {
      {"EA = 3.0", "EA = 3.00001", "K of the certificate is not that of the structure"},
      {"top = [1.0, 1.0]", "top = [1.0, 1.0001]",
       "K of the certificate is not that of the structure"},
      {"normal = [-1.0, 1.0]", "normal = [-1.0, 1.0]\nfriction_factor = 2.0",
       ""},  // mu = 1.5: all agree
      {"normal = [-1.0, 1.0]", "normal = [-1.0, 1.001]",
       "K of the certificate is not that of the structure"},
  };
  for (const auto& [what, with, said] : table) {
    const auto run = verify(certificate, changed("two-bars.toml", what, with));
    EXPECT_EQ(run.exit_code, *said == '\0' ? 0 : 1) << with << run.output;
    EXPECT_THAT(run.output, HasSubstr(said));
  }
  std::ifstream file(example_file("two-bars.toml"));
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (auto place = text.find("tip"); place != std::string::npos; place = text.find("tip", place)) {
    text.replace(place, 3, "end");
  }
  std::ofstream(path("renamed.toml")) << text;
  const auto run = verify(certificate, path("renamed.toml"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(
      run.output,
      HasSubstr("contact candidate 1 of the certificate is tip, that of the structure end"));
}

TEST_F(VerifyCommand, RefusesAnInvalidProblemFile) {
  const auto certificate = certificate_of(example_file("two-bars.toml"), 3);
  const auto none = verify(certificate, path("none.toml"));
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.output, HasSubstr("none.toml: the file cannot be read"));
  const auto wrong = verify(certificate, changed("two-bars.toml", "EA = 3.0", "EA = -3.0"));
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("changed.toml:"));
}

TEST_F(VerifyCommand, ReportsMarginalNodesAsNotProved) {
  const auto run = shell(command + " verify " + given_certificate("everything-marginal.cert"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, AllOf(HasSubstr("NOTHING PROVED: all nodes are marginal"),
                                HasSubstr("marginal: 32 open")));
  const auto quiet =
      shell(command + " verify --quiet " + given_certificate("everything-marginal.cert"));
  EXPECT_EQ(quiet.exit_code, 3);
}

TEST_F(VerifyCommand, ProvesBoundsBeforeNodesThatRequireThem) {
  const auto run = shell(command + " verify " + given_certificate("bounds.cert"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, AllOf(HasSubstr("bounds: 3 proved\ncannot stick: 2 proved\n"),
                                HasSubstr("PROVED: the list of 1 pattern is complete")));
  const auto refused = shell(command + " verify " + given_certificate("refused-bound.cert"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, AllOf(HasSubstr("refused-bound.cert:19: refused: bound 0.25 b "
                                              "separated: its multipliers do not rule out"),
                                    HasSubstr("refused-bound.cert:20: refused: never a contact: "),
                                    HasSubstr("refused-bound.cert:23: refused: cut contact {a}"),
                                    HasSubstr("bounds: 1 proved\n"), HasSubstr("NOT PROVED")));
}

TEST_F(VerifyCommand, RefusesAnUpperBoundBeyondAllDoubles) {
  const auto run = shell(command + " verify " + given_certificate("limit-beyond-doubles.cert"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("the upper bound exceeds the range of double precision"));
}

TEST_F(VerifyCommand, ProvesLimitLoadsForTheProblemFile) {
  const auto certificate = quoted(path("grid.cert"));
  const auto file = example_file("paper/limit-3x3.toml");
  const auto run = shell(fmt::format("{} limit {} --alpha 40 --quiet --certificate {}", command,
                                     quoted(file), certificate));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto proved = verify(certificate, file);
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(
      proved.output,
      AllOf(HasSubstr("PROVED: the worst-case load factor for alpha = 40 is between 37.0120041"),
            HasSubstr("problem: "),
            HasSubstr("coordinates, yield forces and loads are those of the truss")));
  EXPECT_THAT(shell(command + " verify " + certificate).output,
              HasSubstr("the truss is that of the certificate"));
  const auto other = verify(certificate, example_file("paper/limit-4x4.toml"));
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.output, HasSubstr("refused: "));
  const auto wrong = verify(certificate, example_file("two-bars.toml"));
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("a [[members]] group has no yield; expected yield"));
}

// 80 nodes on the face of a mesh: sets of candidates of two words, in messages between ranks, in
// the certificate and in the proof.
TEST_F(VerifyCommand, ProvesPatternsOfEightyCandidates) {
  std::ofstream(path("body.toml")) << R"(name = "body"
dimension = 2
units = { length = "m", force = "kN" }
[[mesh]]
name = "body"
corners = [[0.0, 0.0], [1.8, 0.0], [2.0, 2.0], [0.0, 2.0]]
divisions = [4, 79]
E = 1.0
nu = 0.25
thickness = 1.0
plane = "stress"
[[supports]]
nodes = ["body.left"]
[[contact]]
nodes = ["body.right"]
normal = [-2.0, -0.2]
)";
  const auto file = path("body.toml");
  std::set<std::string> shown;
  for (int count = 1; count <= 2; ++count) {
    const auto certificate = quoted(path(fmt::format("{}.cert", count)));
    const auto run =
        shell(fmt::format("{} {} patterns {} --mu 0.8 --quiet --certificate {}",
                          kusabi::test::ranks(count), command, quoted(file), certificate));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto proved = verify(certificate, file);
    EXPECT_EQ(proved.exit_code, 0) << proved.output;
    EXPECT_THAT(proved.output, HasSubstr(" nodes cover all 2^80 sign patterns, each once"));
    EXPECT_THAT(proved.output, HasSubstr("PROVED: the list of "));
    shown.insert(proved.output);
  }
  EXPECT_EQ(shown.size(), 1U) << "other nodes on two ranks";
}

}  // namespace
