// `kusabi show` and --vtu: files of a call, and errors before the search. Contents of the files are
// tested in tests/pictures.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Pictures : public Command {
 protected:
  static test::Run called(const std::string& words) { return shell(command + " " + words); }
  static std::string example(const std::string& name) {
    return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
  }
  [[nodiscard]] std::vector<std::string> drawn() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(in_folder("seen")))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
};

TEST_F(Pictures, AreAFileForEachAnswerAndTheirList) {
  const auto run = called("rays " + example("two-bars.toml") + " --mu 2 --vtu " + argument("seen"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("wrote " + in_folder("seen") + "/rays.pvd"));
  const auto names = drawn();
  ASSERT_GE(names.size(), 3U);
  // Answers, their list, and a script for ParaView.
  EXPECT_EQ(names.back(), "rays.py");
  EXPECT_EQ(names[names.size() - 2], "rays.pvd");
  const auto list = content(in_folder("seen/rays.pvd"));
  for (std::size_t i = 0; i + 2 < names.size(); ++i) EXPECT_THAT(list, HasSubstr(names[i]));
}

TEST_F(Pictures, OfACollapseAreTwo) {
  const auto call = "limit " + example("gust.toml") + " --vtu " + argument("seen");
  EXPECT_EQ(called(call).exit_code, 0);
  EXPECT_THAT(drawn(), ElementsAre("limit.pvd", "limit.py", "nominal.vtu"));
  EXPECT_EQ(called(call + " --alpha 0.5").exit_code, 0);
  EXPECT_THAT(drawn(), ElementsAre("limit.pvd", "limit.py", "nominal.vtu", "worst-case.vtu"));
}

TEST_F(Pictures, AreTheSameOnTwoRanks) {
  const auto call = "patterns " + truss + " --mu 0.65 --vtu " + argument("seen");
  ASSERT_EQ(called(call).exit_code, 0);
  const auto alone = content(in_folder("seen/pattern-05.vtu"));
  const auto run = shell(ranks(2) + command + " " + call);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(content(in_folder("seen/pattern-05.vtu")), alone);
}

TEST_F(Pictures, RequireAFolderOrANewName) {
  std::ofstream(in_folder("seen")) << "mine";
  const auto run = called("patterns " + truss + " --mu 0.65 --vtu " + argument("seen"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.output,
            "--vtu " + in_folder("seen") + ": is not a folder; expected a folder or a new name\n");
  EXPECT_EQ(content(in_folder("seen")), "mine");
}

TEST_F(Pictures, LeaveNoEmptyFolderAfterAnInvalidCall) {
  const auto run = called("critical " + truss + " --vtu " + argument("seen") + " --output " +
                          argument("seen/critical.pvd"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("is also the file of --output"));
  EXPECT_FALSE(fs::exists(in_folder("seen")));
}

TEST_F(Pictures, RequireAMethodThatFindsPatterns) {
  const auto run =
      called("critical " + truss + " --method newton --mu-max 1 --vtu " + argument("seen"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("expected --method auto, descent"));
}

TEST_F(Pictures, RequireAResultFile) {
  for (const std::string subcommand : {"draw", "report"}) {
    const auto run = called(subcommand + " " + argument("none.json"));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.output, HasSubstr("the file cannot be read; expected a result file in JSON"));
  }
}

TEST_F(Pictures, ShowSummarisesAFile) {
  const auto run = called("show " + example("gust.toml") + " --vtu " + argument("gust.vtu"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("\n  consists of 8 nodes, 15 members\n"));
  EXPECT_THAT(run.output, HasSubstr("\n  supports    2 nodes along x y\n"));
  EXPECT_THAT(run.output,
              HasSubstr("\n  loads       6 dead loads, 2 reference loads, 4 uncertain\n"));
  EXPECT_THAT(content(in_folder("gust.vtu")), HasSubstr("Name=\"uncertain_load\""));
}

}  // namespace
}  // namespace kusabi::test
