// Writes the file, or says what is wrong with the size.
#include "run/example/example.hpp"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/families/grid_truss.hpp"
#include "problems/files/structure_writer.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/output_file.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {
namespace {

// Writes what `structure` makes, which throws std::invalid_argument if the size is impossible.
template <class MakeStructure>
int write_example(Session& session, const char* name, const std::string& output,
                  MakeStructure structure) {
  session.from_first_rank([&] {
    std::string text;
    try {
      text = problems::structure_text(structure());
    } catch (const std::invalid_argument& error) {
      throw WrongInput(fmt::format("kusabi example {}: {}", name, error.what()));
    }
    OutputFile file("--output", output, {});
    if (file.wanted()) {
      file.stream() << text;
      file.put_in_place();
    } else {
      print_answer(text);
    }
  });
  return solved;
}

}  // namespace

int example_space_truss(Session& session, const ExampleSpaceTrussOptions& options) {
  return write_example(session, "space-truss", options.output,
                       [&] { return problems::space_truss(options.size); });
}

int example_plane_truss(Session& session, const ExamplePlaneTrussOptions& options) {
  return write_example(session, "plane-truss", options.output,
                       [&] { return problems::plane_truss(options.size); });
}

int example_grid(Session& session, const ExampleGridOptions& options) {
  return write_example(session, "grid", options.output,
                       [&] { return problems::grid_truss(options.bays); });
}

}  // namespace kusabi::run
