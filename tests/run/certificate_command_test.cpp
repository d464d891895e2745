// Certificates of patterns, written by kusabi patterns and proved or refused by kusabi verify.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using PatternsCertificate = Command;

// The lines of a certificate about nodes, sorted.
std::vector<std::string> node_lines(const std::string& name) {
  std::ifstream file(name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("infeasible") || line.starts_with("wedged") ||
        line.starts_with("marginal"))
      lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

// Command that replaces the end of a changed certificate, with the right count and digest.
std::string sealed(const std::string& name) {
  return fmt::format(
      "{{ sed -i '/^end /,$d' {0} && echo \"end $(sed '1,/^evidence$/d' {0} | wc -l)\" >>{0} &&"
      "   echo \"digest $(sha1sum <{0} | cut -d' ' -f1)\" >>{0}; }}",
      name);
}

TEST_F(PatternsCertificate, ProvesTheListOfPatterns) {
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.65 --certificate " + argument("cert"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(files(), std::vector<std::string>{"cert"});
  const auto proved = shell(command + " verify " + argument("cert"));
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.output, HasSubstr(" nodes cover all 1024 sign patterns, each once"));
  EXPECT_THAT(proved.output, HasSubstr("PROVED: the list of 27 patterns is complete"));
  const auto quiet = shell(command + " verify --quiet " + argument("cert"));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.output, "");
  // The digest is the SHA-1 of all lines before it.
  EXPECT_EQ(shell(fmt::format("test \"digest $(head -n -1 {0} | sha1sum | cut -d' ' -f1)\" = "
                              "\"$(tail -n 1 {0})\"",
                              argument("cert")))
                .exit_code,
            0);
}

TEST_F(PatternsCertificate, ProvesAllNodesExceptMarginalOnes) {
  std::ofstream(in_folder("rod.toml")) << rod_along_normal;
  shell(command + " patterns " + argument("rod.toml") + " --mu 1.1 --certificate " +
        argument("cert"));
  const auto run = shell(command + " verify " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, testing::ContainsRegex("PROVED except for [0-9]* marginal node"));
}

TEST_F(PatternsCertificate, HasTheSameContentAndVerdictOnAnyNumberOfRanks) {
  const auto search = command + " patterns " + truss + " --mu 1.0 --quiet --certificate ";
  const auto alone = in_folder("alone");
  ASSERT_EQ(shell(search + quoted(alone) + " --serial").exit_code, 0);
  const auto expected = shell(command + " verify " + quoted(alone));
  ASSERT_EQ(expected.exit_code, 0) << expected.output;
  for (int count = 1; count <= 3; ++count) {
    const auto file = in_folder(fmt::format("np{}", count));
    const auto searched = shell(ranks(count) + search + quoted(file));
    ASSERT_EQ(searched.exit_code, 0) << searched.output;
    EXPECT_EQ(node_lines(file), node_lines(alone)) << count << " ranks";
    const auto run = shell(ranks(count) + command + " verify " + quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(run.output, expected.output) << count << " ranks";
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"alone", "np1", "np2", "np3"}));
}

TEST_F(PatternsCertificate, IsRefusedOnAnyNumberOfRanksIfFalsified) {
  const auto cert = argument("cert");
  shell(command + " patterns " + truss + " --mu 0.65 --certificate " + cert);
  const auto verdict = [&](const std::string& launch, const std::string& change) {
    return shell(fmt::format("cp {0} {1} && {2} && {3} && {4} {5} verify {1}", cert,
                             argument("spoilt"), change, sealed(argument("spoilt")), launch,
                             command));
  };
  for (const auto& launch : {std::string{}, ranks(3)}) {
    const auto missing = verdict(launch, "sed -i '0,/^wedged/{/^wedged/d}' " + argument("spoilt"));
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_THAT(missing.output, HasSubstr("refused: no node covers contact {"));
    EXPECT_THAT(missing.output, HasSubstr("\nNOT PROVED\n"));
    const auto steeper =
        verdict(launch, "sed -i '/^friction/s/0x1.4/0x1.f/g' " + argument("spoilt"));
    EXPECT_EQ(steeper.exit_code, 1);
    EXPECT_THAT(steeper.output, HasSubstr("its multipliers do not rule out a reaction at"));
    EXPECT_THAT(steeper.output, HasSubstr("refused: infeasible contact {"));
  }
}

// A slab between parallel walls, with 25 candidates on each side and no supports.
constexpr auto slab = R"(name = "slab"
dimension = 2
units = { length = "m", force = "kN" }
[[mesh]]
name = "b"
corners = [[0, 0], [4, 0], [4, 1], [0, 1]]
divisions = [24, 2]
E = 1000
nu = 0.3
thickness = 1
plane = "stress"
[[contact]]
nodes = ["b.bottom"]
normal = [0, 1]
[[contact]]
nodes = ["b.top"]
normal = [0, -1]
)";

// The lower bound is that of the form with products of two displacements; the limit of nodes ends
// the run before any tree.
TEST_F(PatternsCertificate, ProvesTheBracketOfASlabBetweenParallelWalls) {
  const auto file = argument("slab.toml"), cert = argument("cert.lower");
  std::ofstream(in_folder("slab.toml")) << slab;
  const auto run =
      shell(command + " critical " + file + " --node-limit 1 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr(" (proved)"));
  const auto verdict = [&](const std::string& name) {
    return shell(command + " verify " + name + " --problem " + file).output;
  };
  EXPECT_THAT(verdict(argument("cert.upper")), HasSubstr("PROVED: it can stick, by 1 pattern"));
  EXPECT_THAT(verdict(cert), HasSubstr("PROVED: the list of 0 patterns is complete: it cannot"));
  const auto altered = [&](const std::string& change) {
    const auto spoilt = argument("spoilt");
    shell(fmt::format("awk '/^form/ {{ {} }} {{ print }}' {} >{} && {}", change, cert, spoilt,
                      sealed(spoilt)));
    return verdict(spoilt);
  };
  EXPECT_THAT(altered(""), HasSubstr("PROVED: the list of 0 patterns"));
  // P_12, N of the last pair, and all N: without them no motion is bounded.
  EXPECT_THAT(altered(R"($6 = "-0x1p-30")"), HasSubstr("of two candidates is below zero"));
  EXPECT_THAT(altered(R"($NF = "-0x1p-30")"), HasSubstr("of two candidates is below zero"));
  EXPECT_THAT(altered(R"(for (i = NF - 2499; i <= NF; ++i) $i = "0x0p+0")"),
              HasSubstr("its form is not negative definite"));
}

TEST_F(PatternsCertificate, IsRefusedIfItsDigestIsWrong) {
  const auto cert = argument("cert");
  shell(command + " patterns " + truss + " --mu 0.65 --certificate " + cert);
  shell("sed -i '0,/^wedged/s/^wedged/infeasible/' " + cert);
  for (const auto& launch : {std::string{}, ranks(2)}) {
    const auto run = shell(launch + command + " verify " + cert);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.output, HasSubstr(in_folder("cert") + ": was altered: digest '"));
  }
}

TEST_F(PatternsCertificate, IsRefusedInInvalidCalls) {
  const std::string good = "patterns " + truss + " --mu 0.5 ";
  // A part that a run with its state continues.
  std::ofstream(in_folder("state")) << "kusabi-checkpoint";
  std::ofstream(in_folder("cert.part.1.0"))
      << "part of the tree 0 of the checkpoint " << in_folder("state") << '\n';
  ASSERT_EQ(mkfifo(in_folder("pipe").c_str(), 0600), 0);
  const std::vector<std::string> wrong{
      "verify",
      "verify " + argument("none"),
      "verify " + quoted(folder_.string()),
      "verify " + truss,
      good + "--certificate /nowhere/at/all",
      good + "--certificate " + quoted(folder_.string()),
      good + "--certificate " + argument("pipe"),
      good + "--certificate " + truss,
      good + "--certificate " + argument("cert"),
      good + "--certificate " + argument("same") + " --output " + argument("same"),
  };
  for (const auto& call : wrong) {
    const auto run = shell(command + " " + call);
    EXPECT_EQ(run.exit_code, 2) << call;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"cert.part.1.0", "pipe", "state"}));
}

TEST_F(PatternsCertificate, ReplacesPartsOfAKilledProcess) {
  std::ofstream(in_folder("cert.part.1.0")) << "part of the tree 0\nmarginal 1 0 0\n";
  std::ofstream(in_folder("cert.part.3.1"))
      << "part of the tree 0 of the checkpoint " << in_folder("gone") << '\n';
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.5 --quiet --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(files(), std::vector<std::string>{"cert"});
}

TEST_F(PatternsCertificate, IsNotOverwrittenWhileAnotherProcessWritesIt) {
  std::ofstream(in_folder("cert.part.1.0")) << "part of the tree 0\n";
  const int part = open(in_folder("cert.part.1.0").c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(flock(part, LOCK_EX), 0);
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.5 --quiet --certificate " + argument("cert"));
  close(part);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("is in use by another search"));
  EXPECT_EQ(files(), std::vector<std::string>{"cert.part.1.0"});
}

TEST_F(PatternsCertificate, IsCompletedByAResumedRun) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet";
  const auto with = " --certificate " + argument("cert");
  const auto stopped =
      shell(ranks(2) + call + with + " --node-limit 300 --resume " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("the evidence so far is in " + in_folder("cert.part.*")));
  EXPECT_THAT(files(), testing::IsSupersetOf({"cert.part.1.0", "cert.part.1.1"}));
  // Refused: a new search, and another name of the certificate.
  const auto anew = shell(call + with);
  EXPECT_EQ(anew.exit_code, 2);
  EXPECT_THAT(anew.output, HasSubstr("belongs to an unfinished search; "
                                     "expected --resume " +
                                     in_folder("state")));
  const auto rest = " --resume " + argument("state");
  const auto other = shell(call + rest + " --certificate " + argument("other"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("expected the name with which the search began"));
  // A part that was being written when a run was killed.
  std::ofstream(in_folder("cert.part.1.0"), std::ios::app) << "infeasible 1 2 0x1.8";
  const auto again = shell(ranks(3) + call + with + rest);
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_THAT(files(), testing::Each(testing::Not(HasSubstr(".part."))));
  const auto whole = in_folder("whole");
  ASSERT_EQ(shell(call + " --certificate " + quoted(whole)).exit_code, 0);
  EXPECT_EQ(node_lines(in_folder("cert")), node_lines(whole));
  EXPECT_EQ(shell(command + " verify " + argument("cert")).exit_code, 0);
}

TEST_F(PatternsCertificate, OfAStoppedRunRequiresAState) {
  const auto run = shell(command + " patterns " + truss +
                         " --mu 1.0 --quiet --node-limit 300 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, HasSubstr("no certificate"));
  EXPECT_TRUE(files().empty());
}

TEST_F(PatternsCertificate, ReportsAFullDisk) {
  // A file may have 4096 bytes, and a longer write is an error, not a signal.
  const auto run = shell("trap '' XFSZ; ulimit -f 8; " + command + " patterns " + truss +
                         " --mu 1.0 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_THAT(run.output, HasSubstr("251 sign patterns"));
  EXPECT_THAT(run.output, HasSubstr("cert: a part is incomplete"));
  EXPECT_TRUE(files().empty());  // nothing that no run can use
}

}  // namespace
}  // namespace kusabi::test
