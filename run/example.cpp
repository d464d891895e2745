// Writes the file, or says what is wrong with the size.
#include "run/example.hpp"

#include <cstdio>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/grid_truss.hpp"
#include "problems/structure_writer.hpp"
#include "run/exit_code.hpp"
#include "run/output_file.hpp"

namespace kusabi::run {
namespace {

std::string text_of(const std::string& name,
                    const std::function<problems::Structure()>& structure) {
  try {
    return problems::structure_text(structure());
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("kusabi example {}: {}", name, error.what()));
  }
}

int write(Session& session, const std::string& output,
          const std::function<std::string()>& text_of) {
  session.on_first_rank([&]() -> std::string {
    const auto text = text_of();
    OutputFile file("--output", output, {});
    if (file.wanted()) {
      file.stream() << text;
      file.put_in_place();
    } else {
      fmt::print("{}", text);
    }
    return {};
  });
  return solved;
}

}  // namespace

int example_space_truss(Session& session, const ExampleSpaceTrussOptions& options) {
  return write(session, options.output, [&] {
    return text_of("space-truss", [&] { return problems::space_truss(options.size); });
  });
}

int example_grid(Session& session, const ExampleGridOptions& options) {
  return write(session, options.output,
               [&] { return text_of("grid", [&] { return problems::grid_truss(options.bays); }); });
}

}  // namespace kusabi::run
