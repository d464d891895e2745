// Decks with contact as problem files: the written file, read again, is the structure of a file
// written by hand.
#include "problems/files/decks/deck_problem.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/draft/mesh_file.hpp"
#include "problems/files/structure_file.hpp"
#include "support/input_error.hpp"
#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems::deck_problem_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::ThrowsMessage;

/// Block of 2 x 1 (1 to 6) on a block of 3 x 1 below it, (11 to 18), which is held at the bottom.
const std::string blocks =
    "*HEADING\nblock on a block\n*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1\n6, 2, 1\n"
    "11, 0, -1\n12, 1, -1\n13, 2, -1\n14, 3, -1\n15, 0, 0\n16, 1, 0\n17, 2, 0\n18, 3, 0\n"
    "*ELEMENT, TYPE=CPE4, ELSET=UP\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n"
    "*ELEMENT, TYPE=CPE4, ELSET=LOW\n11, 11, 12, 16, 15\n12, 12, 13, 17, 16\n13, 13, 14, 18, 17\n"
    "*NSET, NSET=GROUND, GENERATE\n11, 14\n*SURFACE, NAME=FOOT\nUP, S1\n*SURFACE, NAME=TABLE\nLOW, "
    "S3\n"
    "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000, 0.3\n*SOLID SECTION, ELSET=UP, MATERIAL=STEEL\n2.5\n"
    "*SOLID SECTION, ELSET=LOW, MATERIAL=STEEL\n2.5\n*BOUNDARY\nGROUND, 1, 2\n";

const std::string contact =
    "*SURFACE INTERACTION, NAME=DRY\n*FRICTION\n0.3, 1e5\n*SURFACE BEHAVIOR, "
    "PRESSURE-OVERCLOSURE=LINEAR\n1e7\n*CONTACT PAIR, INTERACTION=DRY\nFOOT, TABLE\n";

DeckProblem imported(const std::string& deck, std::optional<double> gap = {}) {
  const std::map<std::string, std::string> texts{{"d.inp", deck}};
  DeckChoices choices;
  choices.file = "d.inp";
  choices.gap = gap;
  return deck_problem(read_mesh_file({"d.inp", texts}, "d.inp"), choices);
}

Structure structure_of(const DeckProblem& problem, const std::string& deck) {
  return read_structure({problem.text, {{"d.inp", deck}}}, "p.toml");
}

std::vector<std::string> candidates(const Structure& structure) {
  std::vector<std::string> names;
  for (const auto& candidate : structure.contact)
    names.push_back(structure.node_names[static_cast<std::size_t>(candidate.node)]);
  return names;
}

TEST(DeckProblem, HasItsHeadingAsANameOfThePermittedLength) {
  // 63 bytes and a letter of two.
  auto deck = blocks;
  deck.replace(deck.find("block on a block"), 16,
               "Job\t1: " + std::string(56, 'x') + "\u00e9 and more");
  EXPECT_EQ(structure_of(imported(deck), deck).name, "Job 1: " + std::string(56, 'x'));
}

// Sets and surfaces have name spaces of their own.
TEST(DeckProblem, HasThePairsOfASurfaceThatHasTheNameOfASet) {
  const auto with_set = blocks + "*NSET, NSET=FOOT\n2\n" + contact;
  EXPECT_EQ(candidates(structure_of(imported(with_set), with_set)),
            candidates(structure_of(imported(blocks + contact), blocks + contact)));
}

TEST(DeckProblem, LeavesOutLoadsThatAreNoStaticForces) {
  for (const std::string kind : {"FOLLOWER", "IMAGINARY", "LOAD CASE=2", "SUBMODEL"}) {
    const auto deck = blocks + "*STEP\n*STATIC\n*CLOAD, " + kind + "\n6, 1, 7\n*END STEP\n";
    const auto problem = imported(deck);
    EXPECT_TRUE(structure_of(problem, deck).loads.empty()) << kind;
    EXPECT_THAT(problem.warnings, Contains(HasSubstr("*CLOAD of a"))) << kind;
  }
}

TEST(DeckProblem, RefusesASurfaceOfNodesThatHasTheNameOfASetOfOtherNodes) {
  const std::string set = "*NSET, NSET=FEET\n4\n";
  const std::string surface = "*SURFACE, NAME=FEET, TYPE=NODE\n1\n2\n";
  for (const auto& both : {set + surface, surface + set}) {
    EXPECT_THAT([&] { imported(blocks + both); },
                ThrowsMessage<support::InputError>(
                    HasSubstr("surface \"FEET\" has the name of a set with other nodes")));
  }
  const auto same = blocks + surface + "*NSET, NSET=FEET\n2, 1\n";
  EXPECT_THAT(imported(same).warnings, IsEmpty());
}

TEST(DeckProblem, HasTheLoadsAtTheEndOfTheLastStep) {
  // Node 6 has 1 + 2 in the second step instead of 7; the set keeps its load of the first one.
  const auto deck =
      blocks + contact +
      "*NSET, NSET=TOP\n4, 5, 6\n*STEP\n*STATIC\n*CLOAD\nTOP, 2, -3\n6, 1, 7\n*END STEP\n"
      "*STEP\n*STATIC\n*CLOAD\n6, 1, 1\n6, 1, 2\n5, 6, 4\n*END STEP\n";
  const auto problem = imported(deck);
  const auto structure = structure_of(problem, deck);
  std::map<std::string, Eigen::VectorXd> loads;
  for (const auto& load : structure.loads) {
    EXPECT_EQ(load.kind, Load::Kind::dead);
    loads[structure.node_names[static_cast<std::size_t>(load.node)]] = load.force;
  }
  const std::map<std::string, Eigen::VectorXd> expected{{"d.4", Eigen::Vector2d(0, -3)},
                                                        {"d.5", Eigen::Vector2d(0, -3)},
                                                        {"d.6", Eigen::Vector2d(3, -3)}};
  EXPECT_EQ(loads, expected);
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("*CLOAD beyond axis 3")));
  const auto cleared = imported(deck + "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*END STEP\n");
  EXPECT_THAT(cleared.text, Not(HasSubstr("[[loads]]")));
}

// Of the set with gravity alone; later of all elements, in another direction.
TEST(DeckProblem, HasTheWeightOfItsGravity) {
  std::string deck = blocks + contact;
  deck.insert(deck.find("*ELASTIC"), "*DENSITY\n7.8e-9\n");
  deck += "*STEP\n*STATIC\n*DLOAD\nUP, GRAV, 9810, 0, -2\nUP, P1, 3\n*END STEP\n";
  const auto problem = imported(deck);
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("*DLOAD other than GRAV")));
  EXPECT_THAT(problem.text, HasSubstr("gravity = [0, -9810]"));
  double down = 0;
  for (const auto& load : structure_of(problem, deck).loads) {
    EXPECT_LT(load.node, 6);
    down -= load.force(1);
  }
  EXPECT_NEAR(down, 2 * 2.5 * 7.8e-9 * 9810, 1e-12);  // area, thickness, density, gravity
  const auto later = deck + "*STEP\n*DLOAD, OP=NEW\n, GRAV, 1, 1, 0, 0\n";
  double right = 0;
  for (const auto& load : structure_of(imported(later), later).loads) right += load.force(0);
  EXPECT_NEAR(right, 5 * 2.5 * 7.8e-9, 1e-20);
  const auto none = imported(deck.erase(deck.find("*DENSITY"), 16));
  EXPECT_THAT(none.text, Not(HasSubstr("gravity")));
  EXPECT_THAT(none.warnings, Contains(HasSubstr("without *DENSITY")));
}

TEST(DeckProblem, AddsUpTheGravityOfAStep) {
  std::string deck = blocks + contact + "*ELSET, ELSET=ONE\n1\n";
  deck.insert(deck.find("*ELASTIC"), "*DENSITY\n7.8e-9\n");
  const auto loaded = [&](const std::string& lines) { return imported(deck + "*STEP\n" + lines); };
  const auto twice = loaded("*DLOAD\nUP, GRAV, 2, 0, -1\nUP, GRAV, 3, 0, -1\n");
  EXPECT_THAT(twice.text, HasSubstr("gravity = [0, -5]"));
  const auto replaced = loaded(
      "*DLOAD\nUP, GRAV, 2, 0, -1\n*END STEP\n*STEP\n*DLOAD\nUP, GRAV, 3, 0, -1\n*END STEP\n");
  EXPECT_THAT(replaced.text, HasSubstr("gravity = [0, -3]"));
  for (const auto* problem : {&twice, &replaced})
    EXPECT_THAT(problem->warnings, Not(Contains(HasSubstr("gravity"))));
  const auto both = loaded("*DLOAD\n, GRAV, 1, 0, -1\nUP, GRAV, 1, 0, -1\n");
  EXPECT_THAT(both.text, HasSubstr("gravity = [0, -2]"));
  EXPECT_THAT(both.warnings, ElementsAre(HasSubstr("*STEP"), HasSubstr("gravity of another size")));
}

TEST(DeckProblem, LooksForTheElementSetOfGravity) {
  const std::string deck = blocks + contact + "*STEP\n*DLOAD\nWRONG, GRAV, 1, 0, -1\n";
  EXPECT_THAT(
      [&] { static_cast<void>(imported(deck)); },
      ThrowsMessage<support::InputError>(HasSubstr("element set \"WRONG\" does not exist")));
}

TEST(DeckProblem, WarnsOnceOfGravityThatIsLeftOut) {
  std::string deck = blocks + contact + "*ELSET, ELSET=ONE\n1\n";
  deck.insert(deck.find("*ELASTIC"), "*DENSITY\n7.8e-9\n");
  for (const auto& [line, warning] :
       {std::pair("ONE, GRAV, 1, 0, -1\n", "gravity on a part of the elements"),
        std::pair("UP, GRAV, 1, 0, 0, 1\n", "gravity across the plane")}) {
    const auto problem = imported(deck + "*STEP\n*DLOAD\n" + line);
    EXPECT_THAT(problem.warnings, ElementsAre(HasSubstr("*STEP"), HasSubstr(warning)));
    EXPECT_THAT(problem.text, Not(HasSubstr("gravity")));
  }
}

TEST(DeckProblem, EqualsTheProblemFileWrittenByHand) {
  const auto problem = imported(blocks + contact);
  EXPECT_THAT(problem.warnings, IsEmpty());
  const auto found = structure_of(problem, blocks + contact);
  const std::string by_hand =
      "name = \"block on a block\"\ndimension = 2\nunits = { length = \"mm\", force = \"N\" }\n"
      "[[mesh]]\nname = \"d\"\nfile = \"d.inp\"\n"
      "[[contact]]\nnodes = [\"d.1\", \"d.2\", \"d.3\"]\nagainst = \"d.TABLE\"\nnormal = [0, 1]\n";
  const Structure expected = read_structure({by_hand, {{"d.inp", blocks}}}, "h.toml");
  EXPECT_EQ(found.name, expected.name);
  EXPECT_EQ(found.node_names, expected.node_names);
  EXPECT_EQ(found.fixed, expected.fixed);
  ASSERT_EQ(found.contact.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found.contact[i].node, expected.contact[i].node);
    EXPECT_EQ(found.contact[i].normal, expected.contact[i].normal);
    ASSERT_EQ(found.contact[i].against.size(), 1U);
    EXPECT_EQ(found.contact[i].against[0].node, expected.contact[i].against[0].node);
    EXPECT_EQ(found.contact[i].friction, 1);
  }
  for (const Element& element : found.elements) {
    EXPECT_EQ(element.modulus, 210000);
    EXPECT_EQ(element.thickness, 2.5);
    EXPECT_EQ(element.state, PlaneState::strain);
  }
  EXPECT_THAT(problem.text, HasSubstr("largest friction coefficient is 0.3: --mu 0.3"));
  EXPECT_THAT(problem.text, HasSubstr("[[supports]]\nnodes = [\"d.GROUND\"]\n\n"));
}

// The supports are those of the problem file, so that they can be edited there.
TEST(DeckProblem, HasItsSupportsInTheProblemFile) {
  auto problem = imported(blocks + contact);
  problem.text.erase(problem.text.find("[[supports]]"),
                     std::string("[[supports]]\nnodes = [\"d.GROUND\"]\n").size());
  EXPECT_EQ(structure_of(problem, blocks + contact).fixed[6], (std::array{false, false, false}));
}

TEST(DeckProblem, OmitsNodesWithAGap) {
  std::string deck = blocks + contact;
  deck.replace(deck.find("1, 0, 0\n"), 8, "1, 0, 0.01\n");
  const auto problem = imported(deck);
  EXPECT_THAT(problem.warnings,
              ElementsAre(HasSubstr("1 of 3 nodes of FOOT do not touch TABLE, the nearest of them "
                                    "at 0.01; --gap")));
  EXPECT_THAT(candidates(structure_of(problem, deck)), ElementsAre("d.2", "d.3"));
  EXPECT_THAT(candidates(structure_of(imported(deck, 0.02), deck)),
              ElementsAre("d.1", "d.2", "d.3"));
  std::string adjusted = deck;
  adjusted.replace(adjusted.find("INTERACTION=DRY"), 15, "INTERACTION=DRY, ADJUST=0.05");
  EXPECT_THAT(candidates(structure_of(imported(adjusted), adjusted)),
              ElementsAre("d.1", "d.2", "d.3"));
}

TEST(DeckProblem, HasAFactorForPairsWithAnotherCoefficient) {
  const std::string more =
      "*NODE\n21, 2, 0\n22, 3, 0\n23, 3, 1\n24, 2, 1\n*ELEMENT, TYPE=CPE4, ELSET=SIDE\n21, 21, 22, "
      "23, 24\n"
      "*SOLID SECTION, ELSET=SIDE, MATERIAL=STEEL\n2.5\n*SURFACE, NAME=FLANK\nUP, S2\n"
      "*SURFACE, NAME=CHEEK\nSIDE, S4\n*SURFACE, NAME=RIGHT\n2, S2\n"
      "*SURFACE INTERACTION, NAME=WET\n*FRICTION\n0.06,\n*SURFACE INTERACTION, NAME=SMOOTH\n"
      "*CONTACT PAIR, INTERACTION=wet\nRIGHT, CHEEK\n*BOUNDARY\n22, 1, 2\n23, 1\n";
  const auto problem = imported(blocks + contact + more);
  const auto structure = structure_of(problem, blocks + contact + more);
  EXPECT_THAT(candidates(structure), ElementsAre("d.1", "d.2", "d.3", "d.3", "d.6"));
  EXPECT_EQ(structure.contact[2].friction, 1);
  EXPECT_EQ(structure.contact[3].friction, 0.2);
}

TEST(DeckProblem, HasMultiPointConstraintsForTiedSurfaces) {
  const auto text = imported(blocks + "*TIE, NAME=T\nFOOT, TABLE\n");
  EXPECT_THAT(text.text, HasSubstr("nodes = [\"d.FOOT\"]\nto = \"d.TABLE\"\n"));
  EXPECT_EQ(structure_of(text, blocks).ties.size(), 3U);
  // Rotations and displacements out of the plane are no supports.
  const auto turned = imported(blocks + "*TIE, NAME=T\nFOOT, TABLE\n*BOUNDARY\n1, 3, 6\n");
  EXPECT_EQ(structure_of(turned, blocks).ties.size(), 3U);
  // CalculiX: contact that is tied.
  const auto behaviour = imported(
      blocks +
      "*SURFACE INTERACTION, NAME=GLUE\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TIED\n1e7\n"
      "*CONTACT PAIR, INTERACTION=GLUE\nFOOT, TABLE\n");
  EXPECT_THAT(behaviour.text, HasSubstr("[[ties]]"));
}

// Candidates that are held along their normal cannot touch anything.
TEST(DeckProblem, OmitsCandidatesSupportedAlongTheirNormal) {
  const auto problem = imported(blocks + contact + "*BOUNDARY\n1, 2\n");
  EXPECT_THAT(problem.warnings,
              Contains(HasSubstr("1 of 3 nodes of FOOT are supported along their normal")));
  EXPECT_THAT(candidates(structure_of(problem, blocks)), ElementsAre("d.2", "d.3"));
}

/// The upper block on a rigid plate of two elements.
const std::string plate =
    "*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1\n6, 2, 1\n31, -1, 0\n32, 1.5, 0\n33, 4, 0\n"
    "*ELEMENT, TYPE=CPS4R, ELSET=UP\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n"
    "*ELEMENT, TYPE=R2D2, ELSET=PLATE\n31, 31, 32\n32, 32, 33\n*RIGID BODY, REF NODE=31, "
    "ELSET=PLATE\n"
    "*SURFACE, NAME=FOOT\nUP, S1\n*SURFACE, NAME=TOP\nPLATE, SPOS\n*BOUNDARY\n31, 1, 6\n"
    "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000, 0.3\n*SOLID SECTION, ELSET=UP, MATERIAL=STEEL\n1\n";

TEST(DeckProblem, TakesARigidSurfaceAsObstacle) {
  const std::string deck = plate + "*CONTACT PAIR, INTERACTION=X\nFOOT, TOP\n";
  const auto problem = imported(deck);
  const auto structure = structure_of(problem, deck);
  EXPECT_THAT(candidates(structure), ElementsAre("d.1", "d.2", "d.3"));
  EXPECT_EQ(structure.contact[0].normal, Eigen::Vector2d(0, 1));
  EXPECT_THAT(structure.contact[0].against, IsEmpty());
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("*RIGID BODY is not understood")));
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("supports of 1 nodes of no element")));
}

// A surface of nodes has no faces: the normal is that of the other surface, if it is a plane.
TEST(DeckProblem, TakesTheNormalOfThePlaneThatNodesTouch) {
  const std::string nodes =
      "*NSET, NSET=END\n3\n*SURFACE, NAME=TOE, TYPE=NODE\nEND\n*CONTACT PAIR\nTOE, ";
  const std::string on_body = blocks + nodes + "TABLE\n";
  const auto body = structure_of(imported(on_body), on_body);
  ASSERT_EQ(body.contact.size(), 1U);
  EXPECT_EQ(body.contact[0].normal, Eigen::Vector2d(0, 1));
  const std::string on_plate = plate + nodes + "TOP\n";
  const auto rigid = structure_of(imported(on_plate), on_plate);
  ASSERT_EQ(rigid.contact.size(), 1U);
  EXPECT_EQ(rigid.contact[0].normal, Eigen::Vector2d(0, 1));
}

TEST(DeckProblem, TakesAllNodesAgainstAnAnalyticalSurface) {
  const std::string deck =
      plate +
      "*SURFACE, TYPE=SEGMENTS, NAME=WALL\nSTART, 0, 0\nLINE, 4, 0\n*CONTACT PAIR\nFOOT, wall\n";
  const auto problem = imported(deck);
  EXPECT_THAT(candidates(structure_of(problem, deck)), ElementsAre("d.1", "d.2", "d.3"));
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("all nodes of FOOT are taken as touching it")));
}

TEST(DeckProblem, OmitsRepeatedPairsAndPairsOfOneSurface) {
  const auto problem =
      imported(blocks + contact + "*CONTACT PAIR, INTERACTION=DRY\nTABLE, FOOT\nFOOT,\n");
  EXPECT_THAT(candidates(structure_of(problem, blocks)), ElementsAre("d.1", "d.2", "d.3"));
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("surfaces exchanged")));
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("one surface with itself")));
}

TEST(DeckProblem, NamesAMissingMaterial) {
  std::string deck = blocks;
  deck.replace(deck.find("*ELASTIC"), 8, "*HYPERELASTIC");
  const auto problem = imported(deck);
  EXPECT_THAT(problem.warnings, Contains(HasSubstr("*HYPERELASTIC is not understood")));
  EXPECT_THAT(problem.warnings,
              Contains(HasSubstr("material \"STEEL\" has no elasticity: give E and nu")));
  EXPECT_THAT(problem.text,
              HasSubstr("groups = [\"d.UP\"]\n# E and nu of an isotropic material\n"));
}

// A mesh of a problem file has no contact of its own.
TEST(DeckProblem, IsSuggestedIfADeckWithContactIsReadAsAMesh) {
  const std::string toml = test::head(2) + "[[mesh]]\nname = \"d\"\nfile = \"d.inp\"\n";
  const auto warnings = [&](const std::string& more) {
    return read_structure({toml + more, {{"d.inp", blocks + contact}}}, "p.toml")->warnings;
  };
  EXPECT_THAT(warnings(""), Contains(HasSubstr("kusabi import writes a problem file with them")));
  EXPECT_THAT(warnings("supports = false\n[[supports]]\nnodes = [\"d.GROUND\"]\n"),
              Not(Contains(HasSubstr("kusabi import"))));
}

}  // namespace
}  // namespace kusabi::problems::deck_problem_test
