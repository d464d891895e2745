// Blocks in memory and in files, merged by a heap of their next lines.
#include "run/output/line_sorter.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

namespace kusabi::run {
namespace {

[[noreturn]] void fail(const std::string& beside) {
  throw std::runtime_error(fmt::format("{}: its lines cannot be sorted in this folder: {}", beside,
                                       std::strerror(errno)));
}

}  // namespace

class LineSorter::Block {
 public:
  Block(std::FILE* file, const std::string& beside) : file_(file), beside_(beside) {
    std::rewind(file_);
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  ~Block() { std::free(line_); }

  /// @return false after the last line
  bool next() {
    length_ = getline(&line_, &room_, file_);
    if (length_ < 0 && std::ferror(file_) != 0) fail(beside_);
    return length_ >= 0;
  }

  /// The line without its end.
  [[nodiscard]] std::string_view line() const {
    return {line_, static_cast<std::size_t>(length_) - 1};
  }

 private:
  std::FILE* file_;
  const std::string& beside_;
  char* line_ = nullptr;
  std::size_t room_ = 0;
  ssize_t length_ = 0;
};

void LineSorter::add(std::string_view line) {
  if (!places_.empty() && text_.size() + line.size() > block_) write_block();
  places_.emplace_back(text_.size(), line.size());
  text_ += line;
}

void LineSorter::sort() {
  std::sort(places_.begin(), places_.end(),
            [this](const auto& a, const auto& b) { return before_(line(a), line(b)); });
}

void LineSorter::write_block() {
  sort();
  auto name = beside_ + ".XXXXXX";
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) fail(beside_);
  unlink(name.c_str());
  File file(fdopen(descriptor, "w+b"));
  if (!file) fail(beside_);
  for (const auto& place : places_) {
    const auto text = line(place);
    std::fwrite(text.data(), 1, text.size(), file.get());
    std::fputc('\n', file.get());
  }
  if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0) fail(beside_);
  files_.push_back(std::move(file));
  text_.clear();
  places_.clear();
}

void LineSorter::each(const std::function<void(std::string_view)>& take) {
  std::optional<std::string> last;
  const auto take_once = [&](std::string_view line) {
    if (last && !before_(*last, line)) return;
    take(line);
    last.emplace(line);
  };
  if (files_.empty()) {
    sort();
    for (const auto& place : places_) take_once(line(place));
    return;
  }
  write_block();
  std::vector<std::unique_ptr<Block>> heap;
  const auto later = [this](const auto& a, const auto& b) { return before_(b->line(), a->line()); };
  for (const auto& file : files_) {
    auto block = std::make_unique<Block>(file.get(), beside_);
    if (block->next()) heap.push_back(std::move(block));
  }
  std::make_heap(heap.begin(), heap.end(), later);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), later);
    take_once(heap.back()->line());
    if (heap.back()->next()) {
      std::push_heap(heap.begin(), heap.end(), later);
    } else {
      heap.pop_back();
    }
  }
}

}  // namespace kusabi::run
