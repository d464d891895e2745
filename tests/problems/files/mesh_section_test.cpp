// Section [[mesh]] with a file, [[material]], lists of nodes with `except` and `every`, and meshes
// that touch.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// Quadrilaterals of 1 x 1 from (x, 0) on, all in one row, as an Abaqus file; some of their nodes
/// as sets.
std::string row(int count, double x, double step, const std::string& more = {}) {
  std::string nodes = "*NODE\n";
  std::string elements = "*ELEMENT, TYPE=CPS4, ELSET=BODY\n";
  for (int i = 0; i <= count; ++i) {
    nodes += std::to_string(2 * i + 1) + ", " + std::to_string(x + step * i) + ", 0\n";
    nodes += std::to_string(2 * i + 2) + ", " + std::to_string(x + step * i) + ", 1\n";
  }
  for (int i = 0; i < count; ++i) {
    const auto tag = [&](int place) { return std::to_string(2 * i + place); };
    elements += std::to_string(i + 1) + ", " + tag(1) + ", " + tag(3) + ", " + tag(4) + ", " +
                tag(2) + "\n";
  }
  return nodes + elements + more;
}

std::string mesh(const std::string& name, const std::string& more = {}) {
  return "[[mesh]]\nname = \"" + name + "\"\nfile = \"" + name + ".inp\"\n" + more +
         "E = 1.0\nnu = 0.25\nthickness = 1.0\nplane = \"stress\"\n";
}

ProblemText problem(const std::string& toml, const std::map<std::string, std::string>& meshes) {
  return {test::head(2) + toml, meshes};
}

Structure read(const ProblemText& text) {
  return read_structure(text, "test.toml");
}

std::vector<std::string> names(const Structure& structure) {
  std::vector<std::string> result;
  for (const auto& candidate : structure.contact) {
    result.push_back(structure.node_names[static_cast<std::size_t>(candidate.node)]);
  }
  return result;
}

TEST(MeshSection, JoinsCoincidentNodes) {
  const auto text = problem(mesh("a") + mesh("b") + "[[supports]]\nnodes = [\"b.3\"]\n",
                            {{"a.inp", row(2, 0, 1)}, {"b.inp", row(1, 2, 1)}});
  const Structure structure = read(text);
  EXPECT_EQ(structure.node_names.size(), 8U);
  EXPECT_EQ(structure.elements.size(), 3U);
  EXPECT_EQ(structure.elements[2].nodes[0], structure.elements[1].nodes[1]);
}

TEST(MeshSection, SeparatesTouchingBodiesOnRequest) {
  for (const bool first : {true, false}) {
    const std::string apart = "join = false\n";
    const auto text = problem(mesh("a", first ? apart : "") + mesh("b", first ? "" : apart),
                              {{"a.inp", row(2, 0, 1)}, {"b.inp", row(1, 2, 1)}});
    EXPECT_EQ(read(text).node_names.size(), 10U);
  }
}

TEST(MeshSection, RefusesMeshesThatTouchAndDoNotMatch) {
  auto text = problem(mesh("a") + mesh("b"), {{"a.inp", row(2, 0, 1)}, {"b.inp", row(1, 2, 1)}});
  text.meshes["b.inp"] = row(1, 2, 1);
  // The left edge of b in two halves.
  text.meshes["b.inp"] =
      "*NODE\n1, 2, 0\n2, 3, 0\n3, 3, 1\n4, 2, 1\n5, 2, 0.5\n6, 3, 0.5\n"
      "*ELEMENT, TYPE=CPS4\n1, 1, 2, 6, 5\n2, 5, 6, 3, 4\n";
  EXPECT_EQ(test::error_of(text),
            "a.inp:10:1: a face of this element lies on another where their nodes do not meet, at "
            "node \"b.5\"; expected meshes that match, a gap, or join = false");
  text.toml = test::head(2) + mesh("a", "join = false\n") + mesh("b");
  EXPECT_EQ(test::error_of(text), "no error");
}

TEST(MeshSection, RefusesAMidpointNodeThatTheNeighbourLacks) {
  const std::string mixed =
      "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 1, 1\n5, 0.5, 0\n6, 0.5, 0.5\n7, 0, 0.5\n"
      "*ELEMENT, TYPE=CPS6\n1, 1, 2, 3, 5, 6, 7\n*ELEMENT, TYPE=CPS3\n2, 2, 4, 3\n";
  EXPECT_EQ(test::error_of(problem(mesh("a"), {{"a.inp", mixed}})),
            "a.inp:12:1: a face of this element lies on another where their nodes do not meet, at "
            "node \"a.6\"; expected meshes that match, a gap, or join = false");
}

// A brick, and a tetrahedron on half of its right face.
TEST(MeshSection, RefusesTrianglesOnAQuadrilateral) {
  const std::string text =
      "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n"
      "8, 0, 1, 1\n9, 2, 0, 0\n*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
      "*ELEMENT, TYPE=C3D4\n2, 2, 3, 6, 9\n";
  const ProblemText problem{
      test::head(3) + "[[mesh]]\nname = \"a\"\nfile = \"a.inp\"\nE = 1.0\nnu = 0.2\n",
      {{"a.inp", text}}};
  EXPECT_THAT(test::error_of(problem), StartsWith("a.inp:14:1: a face of this element lies on"));
}

TEST(MeshSection, NamesTheGroupsThatAdmitMaterials) {
  const auto error_with = [](const std::string& group, const std::string& sets) {
    return test::error_of(problem(
        "[[mesh]]\nname = \"a\"\nfile = \"a.inp\"\nE = 1.0\nnu = 0.25\nthickness = 0.1\n"
        "[[material]]\ngroups = [\"" +
            group + "\"]\nE = 70.0\nnu = 0.3\nthickness = 1\n[[supports]]\nnodes = [\"a.1\"]\n",
        {{"a.inp", row(3, 0, 1, sets)}}));
  };
  const std::string sets = "*ELSET, ELSET=HARD\n2, 3\n*ELSET, ELSET=SOFT\n1\n";
  EXPECT_THAT(error_with("a.HRAD", sets), EndsWith("in it; did you mean \"a.HARD\"?"));
  EXPECT_THAT(error_with("stone", sets),
              EndsWith("in it; there are \"a.BODY\", \"a.HARD\", \"a.SOFT\""));
  EXPECT_THAT(error_with("stone", ""), EndsWith("in it; there are \"a.BODY\""));
}

TEST(MeshSection, TakesMaterialsByGroup) {
  const std::string groups = "*ELSET, ELSET=HARD\n2, 3\n";
  const auto text = problem(
      "[[mesh]]\nname = \"a\"\nfile = \"a.inp\"\nscale = 0.5\nE = 1.0\nnu = 0.25\n"
      "thickness = 0.1\n[[material]]\ngroups = [\"a.HARD\"]\nE = 70.0\nnu = 0.3\n"
      "thickness = 2.0\nplane = \"stress\"\n[[supports]]\nnodes = [\"a.1\"]\n",
      {{"a.inp", row(3, 0, 1, groups)}});
  const Structure structure = read(text);
  std::vector<double> moduli;
  for (const Element& element : structure.elements) moduli.push_back(element.modulus);
  EXPECT_THAT(moduli, ElementsAre(1, 70, 70));
  EXPECT_EQ(structure.elements[0].thickness, 0.1);
  EXPECT_EQ(structure.elements[0].state, PlaneState::stress);  // CPS4
  EXPECT_EQ(structure.coordinates.row(0).maxCoeff(), 1.5);
  EXPECT_EQ(structure.coordinates.row(1).maxCoeff(), 0.5);
}

TEST(MeshSection, TakesMaterialsAndSupportsOfTheFile) {
  const std::string more =
      "*Nset, nset=Left\n1, 2\n*SOLID SECTION, ELSET=body, MATERIAL=Steel\n0.5\n"
      "*MATERIAL, NAME=\"steel\"\n*DENSITY\n7.8\n*ELASTIC\n2.1D2, 0.3\n"
      "*BOUNDARY\nLEFT, 1\n1, 2\n*STEP\n*STATIC\n*END STEP\n";
  const auto structure =
      read(problem("[[mesh]]\nname = \"a\"\nfile = \"a.inp\"\n", {{"a.inp", row(1, 0, 1, more)}}));
  EXPECT_EQ(structure.elements[0].modulus, 210);
  EXPECT_EQ(structure.elements[0].ratio, 0.3);
  EXPECT_EQ(structure.elements[0].thickness, 0.5);
  EXPECT_EQ(structure.elements[0].density, 7.8);
  EXPECT_THAT(structure.fixed[0], ElementsAre(true, true, false));
  EXPECT_THAT(structure.fixed[1], ElementsAre(true, false, false));
  EXPECT_THAT(structure.fixed[2], ElementsAre(false, false, false));
  // Reported with its line instead of ignored.
  EXPECT_THAT(structure.warnings,
              ElementsAre("a.inp:20: *STEP is left out", "a.inp:21: *STATIC is left out",
                          "a.inp:22: *END STEP is left out"));
}

TEST(MeshSection, MakesBarsOfLinesThatHaveAStiffness) {
  const std::string more = "*NODE\n9, 3, 0\n*ELEMENT, TYPE=T2D2, ELSET=RODS\n7, 3, 9\n";
  const std::string toml = mesh("a") + "[[supports]]\nnodes = [\"a.1\", \"a.2\", \"a.9\"]\n";
  const auto structure = read(problem(toml + "[[material]]\ngroups = [\"a.RODS\"]\nEA = 5.0\n",
                                      {{"a.inp", row(1, 0, 1, more)}}));
  ASSERT_EQ(structure.members.size(), 1U);
  EXPECT_EQ(structure.members[0].axial_stiffness, 5);
  EXPECT_EQ(structure.node_names.size(), 5U);
  EXPECT_THAT(test::error_of(problem(toml + "[[material]]\ngroups = [\"a.RODS\"]\nyield = { "
                                            "tension = 1, compression = 2, residual = 0.3 }\n"
                                            "EA = 5.0\n",
                                     {{"a.inp", row(1, 0, 1, more)}})),
              testing::HasSubstr("residual stands in [[material]]; expected tension and"));
  // Without it they only name nodes, and node 9 belongs to no element.
  EXPECT_EQ(test::error_of(problem(toml, {{"a.inp", row(1, 0, 1, more)}})),
            "test.toml:12:24: node \"a.9\" does not exist; expected a name from [nodes]; did you "
            "mean \"a.1\"?");
}

TEST(MeshSection, NamesTheExistingGroupsIfOneDoesNotExist) {
  const std::string sets = "*NSET, NSET=SOLE\n1, 2\n*NSET, NSET=BACK\n3, 4\n";
  const auto error = [&](const std::string& name) {
    const auto toml = mesh("a") + "[[supports]]\nnodes = [\"" + name + "\"]\n";
    return test::error_of(problem(toml, {{"a.inp", row(1, 0, 1, sets)}}));
  };
  const std::string start = "test.toml:12:10: node ";
  const std::string expected = " does not exist; expected a name from [nodes]";
  EXPECT_EQ(error("SOLE"), start + "\"SOLE\"" + expected + "; did you mean \"a.SOLE\"?");
  EXPECT_EQ(error("a.SOLES"), start + "\"a.SOLES\"" + expected + "; did you mean \"a.SOLE\"?");
  EXPECT_EQ(error("a.UNDERSIDE"), start + "\"a.UNDERSIDE\"" + expected +
                                      "; its mesh has \"a.BACK\", \"a.BODY\", \"a.SOLE\"");
  EXPECT_EQ(error("b.UNDERSIDE"), start + "\"b.UNDERSIDE\"" + expected);
}

TEST(MeshSection, ReadsIncludedFiles) {
  const std::string whole = row(1, 0, 1);
  const auto cut = whole.find("*ELEMENT");
  auto text =
      problem(mesh("a"), {{"a.inp", "*Include, input=parts/nodes.txt\n" + whole.substr(cut)},
                          {"parts/nodes.txt", whole.substr(0, cut)}});
  EXPECT_EQ(read(text).node_names.size(), 4U);
  text.meshes["parts/nodes.txt"] += "*INCLUDE, INPUT=more.txt\n";
  text.meshes["parts/more.txt"] = "*NODE\n3, 0, 0\n";
  EXPECT_EQ(test::error_of(text),
            "parts/more.txt:2:1: node 3 is given twice, first on line 4; expected once");
}

TEST(NodeLists, ApplyExceptAndEvery) {
  const std::string set = "*NSET, NSET=BOTTOM\n1, 3, 5, 7, 9, 11\n*NSET, NSET=ENDS\n1, 11\n";
  const auto list = [&](const std::string& keys) {
    return names(read(problem(mesh("a") +
                                  "[[supports]]\nnodes = [\"a.2\", \"a.1\"]\n"
                                  "[[contact]]\nnormal = [0.0, 1.0]\n" +
                                  keys,
                              {{"a.inp", row(5, 0, 1, set)}})));
  };
  EXPECT_THAT(list("nodes = [\"a.BOTTOM\"]\nexcept = [\"a.ENDS\"]\n"),
              ElementsAre("a.3", "a.5", "a.7", "a.9"));
  EXPECT_THAT(list("nodes = [\"a.BOTTOM\"]\nexcept = [\"a.1\"]\nevery = 2\n"),
              ElementsAre("a.3", "a.7", "a.11"));
  EXPECT_THAT(list("nodes = [\"a.3\", \"a.5\"]\nevery = 5\n"), ElementsAre("a.3"));
}

// Node sets, element sets and surfaces with the same name are one group, whose nodes are those of
// the node set.
TEST(NodeLists, ResolveSurfacesAndElementSets) {
  const std::string sets =
      "*ELSET, ELSET=RIGHT\n3\n*NSET, NSET=RIGHT\n7\n*SURFACE, NAME=TOP\n2, S3\nBODY, S3\n";
  const auto list = [&](const std::string& nodes) {
    return names(read(problem(mesh("a") +
                                  "[[supports]]\nnodes = [\"a.1\"]\n[[contact]]\n"
                                  "normal = \"surface\"\nnodes = [\"" +
                                  nodes + "\"]\n",
                              {{"a.inp", row(3, 0, 1, sets)}})));
  };
  EXPECT_THAT(list("a.RIGHT"), ElementsAre("a.7"));
  EXPECT_THAT(list("a.TOP"), ElementsAre("a.2", "a.4", "a.6", "a.8"));
}

std::vector<Eigen::Vector2d> normals(const std::string& contact, const std::string& more = {}) {
  const auto structure =
      read(problem(mesh("a") + "[[supports]]\nnodes = [\"a.1\", \"a.2\"]\n[[contact]]\n" + contact,
                   {{"a.inp", row(2, 0, 1, more)}}));
  std::vector<Eigen::Vector2d> result;
  for (const auto& candidate : structure.contact) result.emplace_back(candidate.normal);
  return result;
}

// The vertex (2, 1) belongs to the top and to the right edge: the group determines the normal.
TEST(SurfaceNormals, AreThoseOfTheFacesOfTheGroup) {
  const std::string sets =
      "*NSET, NSET=RIGHT\n5, 6\n*SURFACE, NAME=TOP\nBODY, S3\n*NSET, NSET=BOTH\n4, 6, 5\n";
  const auto at = [&](const std::string& keys) {
    return normals("normal = \"surface\"\n" + keys + "\n", sets);
  };
  EXPECT_THAT(at("nodes = [\"a.RIGHT\"]"),
              ElementsAre(Eigen::Vector2d(-1, 0), Eigen::Vector2d(-1, 0)));
  EXPECT_THAT(at("nodes = [\"a.TOP\"]\nexcept = [\"a.2\"]"),
              ElementsAre(Eigen::Vector2d(0, -1), Eigen::Vector2d(0, -1)));
  const double half = std::sqrt(0.5);
  EXPECT_LT((at("nodes = [\"a.BOTH\"]")[1] - Eigen::Vector2d(-half, -half)).norm(), 1e-15);
  EXPECT_LT((at("nodes = [\"a.6\"]")[0] - Eigen::Vector2d(-half, -half)).norm(), 1e-15);
}

TEST(SurfaceNormals, OfAPlanePointIntoTheBody) {
  for (const char* plane : {"[3.0, 0.0]", "[-3.0, 0.0]"}) {
    EXPECT_THAT(normals("nodes = [\"a.5\"]\nnormal = { plane = " + std::string(plane) + " }\n"),
                ElementsAre(Eigen::Vector2d(-1, 0)));
  }
}

TEST(SurfaceNormals, OfACircleAreRadial) {
  const auto found =
      normals("nodes = [\"a.5\", \"a.6\"]\nnormal = { point = [-1.0, 0.0], body = \"inside\" }\n");
  EXPECT_LT((found[0] - Eigen::Vector2d(-1, 0)).norm(), 1e-15);
  EXPECT_LT((found[1] - Eigen::Vector2d(-3, -1).normalized()).norm(), 1e-15);
  EXPECT_LT(
      (normals("nodes = [\"a.5\"]\nnormal = { point = [3.0, 0.0], body = \"outside\" }\n")[0] -
       Eigen::Vector2d(-1, 0))
          .norm(),
      1e-15);
}

// On curved sides of second order the normal is that of the circle to third order in the element
// size.
TEST(SurfaceNormals, OfACurvedEdgeAreThoseOfTheCurve) {
  const auto worst = [](const std::string& file) {
    const auto structure =
        test::read(test::head(2) + test::mesh_of(file, 2) +
                   "[[supports]]\nnodes = [\"m.left\"]\n[[contact]]\nnodes = [\"m.notch\"]\n"
                   "normal = \"surface\"\n");
    double angle = 0;
    for (const auto& candidate : structure.contact) {
      // The notch is a quarter of a circle about (2, 1), the obstacle a shaft in it.
      const Eigen::Vector2d exact =
          (structure.coordinates.col(candidate.node) - Eigen::Vector2d(2, 1)).normalized();
      angle = std::max(angle, std::acos(std::min(1.0, exact.dot(candidate.normal))));
    }
    return angle;
  };
  EXPECT_LT(worst("plate-t6-41.msh"), 0.02);
  EXPECT_LT(worst("plate-t3-41.msh"), 0.5);
  EXPECT_GT(worst("plate-t3-41.msh"), 0.1);
}

TEST(SurfaceNormals, OfTheBoxAreExact) {
  for (const char* file : {"box-tet4-22.msh", "box-tet10-41.msh", "box-hex20.inp"}) {
    const auto structure =
        test::read(test::head(3) + test::mesh_of(file, 3) +
                   "[[supports]]\nnodes = [\"m.bottom\"]\n[[contact]]\nnodes = [\"m.right\"]\n"
                   "except = [\"m.bottom\"]\nnormal = \"surface\"\n");
    ASSERT_GE(structure.contact.size(), 2U);
    for (const auto& candidate : structure.contact) {
      const Eigen::Vector3d place = structure.coordinates.col(candidate.node);
      EXPECT_EQ(candidate.normal, Eigen::VectorXd(Eigen::Vector3d(place.x() == 2 ? -1 : 0,
                                                                  place.x() == 2 ? 0 : 1, 0)))
          << file;
    }
  }
}

TEST(SurfaceNormals, OfConesAndCylindersInSpace) {
  const auto at = [](const std::string& normal) {
    const auto structure =
        test::read(test::head(3) + test::mesh_of("box-hex8-41.msh", 3) +
                   "[[supports]]\nnodes = [\"m.bottom\"]\n[[contact]]\nnodes = [\"m.right\"]\n"
                   "except = [\"m.bottom\"]\nnormal = " +
                   normal + "\n");
    return std::pair(Eigen::Vector3d(structure.coordinates.col(structure.contact[0].node)),
                     Eigen::Vector3d(structure.contact[0].normal));
  };
  const std::string axis = "point = [1.0, 0.5, 0.0], axis = [0.0, 0.0, 2.0], body = \"inside\"";
  const auto [place, cylinder] = at("{ " + axis + " }");
  const Eigen::Vector3d away = Eigen::Vector3d(place.x() - 1, place.y() - 0.5, 0).normalized();
  EXPECT_LT((cylinder + away).norm(), 1e-15);
  // The plug that widens upwards: the normal of the wall of the hole points inwards and upwards.
  const auto cone = at("{ half_angle = 30, " + axis + " }").second;
  EXPECT_LT((cone - (-std::sqrt(0.75) * away + 0.5 * Eigen::Vector3d::UnitZ())).norm(), 1e-15);
}

TEST(GivenNormals, ThatPointOutOfTheBodyAreRefused) {
  const auto text = [](const std::string& normal) {
    return problem(mesh("a") +
                       "[[supports]]\nnodes = [\"a.1\", \"a.2\"]\n[[contact]]\n"
                       "nodes = [\"a.3\"]\nnormal = " +
                       normal + "\n",
                   {{"a.inp", row(2, 0, 1)}});
  };
  EXPECT_EQ(test::error_of(text("[0.1, -1.0]")),
            "test.toml:15:10: the normal at \"a.3\" points out of the body, 174.3 degrees off its "
            "surface; expected the outward normal of the obstacle, into the body");
  EXPECT_THAT(read(text("[0.1, 1.0]")).warnings,
              ElementsAre("test.toml:15:10: the normal is 5.7 degrees off the surface of the body "
                          "at \"a.3\""));
  EXPECT_THAT(read(text("[0.01, 1.0]")).warnings, ElementsAre());
}

// The paper's own normal is that of the mirrored edge, 2 atan(0.1) off.
TEST(GivenNormals, ThatAreOffByMoreThanADegreeAreReported) {
  const auto path = std::string(KUSABI_SOURCE_DIR "/examples/paper/elastic-body.toml");
  const auto warnings = load_structure(path)->warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], StartsWith(path + ":"));
  EXPECT_THAT(warnings[0], HasSubstr("the normal is 11.4 degrees off the surface of the body"));
  EXPECT_THAT(load_structure(KUSABI_SOURCE_DIR "/examples/elastic-body.toml")->warnings,
              ElementsAre());
}

// A node that a mesh shares with [nodes] has two names.
TEST(ResidualStrengths, AreThoseOfTheMembersOfTheirGroup) {
  for (const std::string name : {"p", "b.0,0"}) {
    const std::string text =
        "name = \"t\"\ndimension = 2\nunits = { length = \"m\", force = \"kN\" }\n"
        "[nodes]\np = [0, 0]\nq = [0, -1]\nr = [1, -1]\n"
        "[[mesh]]\nname = \"b\"\ncorners = [[0, 0], [1, 0], [1, 1], [0, 1]]\n"
        "divisions = [1, 1]\nE = 1\nnu = 0.2\nthickness = 1\nplane = \"stress\"\n"
        "[[members]]\nEA = 1\nyield = 10\nbetween = [[\"p\", \"q\"]]\n"
        "[[members]]\nEA = 1\nyield = { tension = 10, compression = 8, residual = 0.25 }\n"
        "between = [[\"" +
        name +
        "\", \"r\"]]\n"
        "[[supports]]\nnodes = [\"b.bottom\", \"q\", \"r\"]\n"
        "[[loads]]\nkind = \"reference\"\nnodes = [\"b.top\"]\nforce = [0, -1]\n";
    const auto structure = read_structure(text, "t.toml");
    EXPECT_EQ(structure->members[0].yield->residual, std::nullopt) << name;
    EXPECT_EQ(structure->members[1].yield->residual, 2) << name;
    EXPECT_EQ(after_buckling(structure).members[1].yield, (YieldForces{10, 2})) << name;
  }
}

}  // namespace
}  // namespace kusabi::problems
