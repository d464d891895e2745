// Writes the file, or says what is wrong with the size.
#include "run/example.hpp"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/structure_writer.hpp"
#include "run/exit_code.hpp"
#include "run/output_file.hpp"

namespace kusabi::run {
namespace {

std::string text_of(const problems::SpaceTrussSize& size) {
  try {
    return problems::structure_text(problems::space_truss(size));
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("kusabi example space-truss: {}", error.what()));
  }
}

}  // namespace

int example_space_truss(Session& session, const ExampleSpaceTrussOptions& options) {
  session.on_first_rank([&]() -> std::string {
    const auto text = text_of(options.size);
    OutputFile file("--output", options.output, {});
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

}  // namespace kusabi::run
