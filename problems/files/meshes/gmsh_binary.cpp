// Sections of binary MSH 2.2 and 4.1, as the Gmsh reference manual describes them: numbers without
// separators between the ASCII lines $Name and $EndName. Either order of bytes is read.
#include "problems/files/meshes/gmsh_binary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "problems/files/meshes/gmsh_elements.hpp"
#include "problems/files/meshes/mesh_data.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

constexpr std::string_view binary_start = "$MeshFormat\n";

class GmshBinary {
 public:
  GmshBinary(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  std::string text() &&;

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw support::InputError(file_, {}, message);
  }
  std::string_view line();
  template <class Number>
  Number take();
  /// Copies an ASCII line with a number. @return the number
  std::size_t number_of_line();
  // Copies the number of blocks of MSH 4.1 and the three numbers after it.
  std::size_t number_of_blocks();
  std::size_t count() { return static_cast<std::size_t>(take<std::uint64_t>()); }
  template <class Number>
  void put(std::size_t count);
  void end_line() { text_ += '\n'; }
  void put_line(std::string_view line) { (text_ += line) += '\n'; }
  /// Reads the line $End...
  void end(const std::string& name);
  /// The bytes up to the line $End..., which is the next one.
  std::string_view up_to_the_end(const std::string& name);

  void format();
  void section(const std::string& name);
  void entities();
  void nodes_2();
  void nodes_4();
  void elements_2();
  void elements_4();
  /// The number of nodes of a type. A type that is not read ends the text, where gmsh_file refuses
  /// it.
  std::size_t nodes_of(int type);

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  bool swapped_ = false;
  bool old_ = false;  // 2.2
  bool ended_ = false;
  std::string text_;
};

std::string_view GmshBinary::line() {
  const auto end = std::min(bytes_.find('\n', at_), bytes_.size());
  const auto result = bytes_.substr(at_, end - at_);
  at_ = std::min(end + 1, bytes_.size());
  return result.ends_with('\r') ? result.substr(0, result.size() - 1) : result;
}

template <class Number>
Number GmshBinary::take() {
  std::array<char, sizeof(Number)> raw{};
  if (bytes_.size() - at_ < raw.size())
    fail("the binary mesh ends within a section; expected more bytes");
  std::copy_n(bytes_.data() + at_, raw.size(), raw.begin());
  at_ += raw.size();
  if (swapped_) std::ranges::reverse(raw);
  return std::bit_cast<Number>(raw);
}

template <class Number>
void GmshBinary::put(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    fmt::format_to(std::back_inserter(text_), "{} ", take<Number>());
}

std::size_t GmshBinary::number_of_line() {
  const auto digits = line();
  put_line(digits);
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc() || end != digits.data() + digits.size()) {
    fail(fmt::format("{} in a binary mesh; expected how many entries the section has",
                     support::in_quotes(digits)));
  }
  return number;
}

std::string_view GmshBinary::up_to_the_end(const std::string& name) {
  const auto end = bytes_.find("$End" + name.substr(1), at_);
  if (end == std::string_view::npos) fail(fmt::format("the binary mesh ends within {}", name));
  const auto first = std::exchange(at_, end);
  return bytes_.substr(first, end - first);
}

void GmshBinary::end(const std::string& name) {
  if (bytes_.substr(at_).starts_with('\n')) ++at_;
  const std::string expected = "$End" + name.substr(1);
  if (line() != expected)
    fail(fmt::format("{} of a binary mesh continues; expected {}", name, expected));
}

void GmshBinary::format() {
  at_ = binary_start.size();
  const auto version = line();
  old_ = version.starts_with("2.2 ");
  if (!old_ && !version.starts_with("4.1 ")) {
    fail(
        fmt::format("a binary mesh of format {}; expected 2.2 or 4.1, as Gmsh writes with -format "
                    "msh22 or msh41",
                    support::in_quotes(version)));
  }
  if (!version.ends_with(" 8")) {
    fail(fmt::format("a binary mesh of format {}; expected numbers of 8 bytes",
                     support::in_quotes(version)));
  }
  const auto one = take<std::uint32_t>();
  constexpr std::uint32_t one_swapped = 0x01000000;
  if (one != 1 && one != one_swapped) fail("a binary mesh without the number 1 behind its version");
  swapped_ = one != 1;
  end("$MeshFormat");
  put_line(fmt::format("{}{} 0 8\n$EndMeshFormat", binary_start, old_ ? "2.2" : "4.1"));
}

std::string GmshBinary::text() && {
  format();
  while (at_ < bytes_.size() && !ended_) {
    const std::string name(line());
    if (name.starts_with('$')) section(name);
  }
  return std::move(text_);
}

void GmshBinary::section(const std::string& name) {
  put_line(name);
  if (name == "$PhysicalNames") {
    text_ += up_to_the_end(name);
  } else if (name == "$Entities" && !old_) {
    entities();
  } else if (name == "$Nodes") {
    old_ ? nodes_2() : nodes_4();
  } else if (name == "$Elements") {
    old_ ? elements_2() : elements_4();
  } else {
    up_to_the_end(name);
  }
  if (ended_) return;
  end(name);
  put_line("$End" + name.substr(1));
}

void GmshBinary::entities() {
  std::array<std::size_t, 4> counts{};
  for (auto& each : counts) each = count();
  put_line(fmt::format("{} {} {} {}", counts[0], counts[1], counts[2], counts[3]));
  for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      put<std::int32_t>(1);
      put<double>(dimension == 0 ? 3 : 6);
      for (int list = 0; list < (dimension == 0 ? 1 : 2); ++list) {  // groups, then boundaries
        const auto length = count();
        text_ += fmt::format("{} ", length);
        put<std::int32_t>(length);
      }
      end_line();
    }
  }
}

void GmshBinary::nodes_2() {
  const auto nodes = number_of_line();
  for (std::size_t i = 0; i < nodes; ++i, end_line()) {
    put<std::int32_t>(1);
    put<double>(3);
  }
}

std::size_t GmshBinary::number_of_blocks() {
  const auto blocks = count();
  text_ += fmt::format("{} ", blocks);
  put<std::uint64_t>(3);
  end_line();
  return blocks;
}

void GmshBinary::nodes_4() {
  const auto blocks = number_of_blocks();
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto dimension = take<std::int32_t>();
    const auto entity = take<std::int32_t>();
    const auto parametric = take<std::int32_t>();
    const auto nodes = count();
    put_line(fmt::format("{} {} {} {}", dimension, entity, parametric, nodes));
    for (std::size_t i = 0; i < nodes; ++i, end_line()) put<std::uint64_t>(1);
    const int parameters = parametric != 0 ? std::clamp(dimension, 0, 3) : 0;
    for (std::size_t i = 0; i < nodes; ++i, end_line())
      put<double>(3 + static_cast<std::size_t>(parameters));
  }
}

std::size_t GmshBinary::nodes_of(int type) {
  const auto shape = gmsh_shape(type);
  ended_ = !shape;
  return shape ? static_cast<std::size_t>(mesh_nodes(*shape)) : 0;
}

void GmshBinary::elements_2() {
  const auto elements = number_of_line();
  for (std::size_t done = 0; done < elements && !ended_;) {
    const auto type = take<std::int32_t>();
    const auto follow = take<std::int32_t>();
    const auto tags = take<std::int32_t>();
    const auto nodes = nodes_of(type);
    if (follow < 1 || tags < 0) fail("a block of elements without elements; expected one or more");
    done += static_cast<std::size_t>(follow);
    for (std::int32_t i = 0; i < follow; ++i, end_line()) {
      put<std::int32_t>(1);
      text_ += fmt::format("{} {} ", type, tags);
      if (ended_) return;
      put<std::int32_t>(static_cast<std::size_t>(tags) + nodes);
    }
  }
}

void GmshBinary::elements_4() {
  const auto blocks = number_of_blocks();
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto dimension = take<std::int32_t>();
    const auto entity = take<std::int32_t>();
    const auto type = take<std::int32_t>();
    const auto elements = count();
    put_line(fmt::format("{} {} {} {}", dimension, entity, type, elements));
    const auto nodes = nodes_of(type);
    if (ended_) return;
    for (std::size_t i = 0; i < elements; ++i, end_line()) put<std::uint64_t>(1 + nodes);
  }
}

}  // namespace

bool is_binary_gmsh(std::string_view bytes) {
  if (!bytes.starts_with(binary_start)) return false;
  const auto version = bytes.substr(binary_start.size(),
                                    bytes.find('\n', binary_start.size()) - binary_start.size());
  return version.find(" 1 ") != std::string_view::npos;
}

std::string gmsh_as_text(std::string_view bytes, const std::string& file) {
  return GmshBinary(bytes, file).text();
}

}  // namespace kusabi::problems
