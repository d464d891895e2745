// HTML, element by element: whatever is put into it comes out as text, and what is opened is
// closed in order.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace kusabi::pictures {

class Markup {
 public:
  struct Attribute {
    std::string_view name;
    std::string value;
  };
  using Attributes = std::initializer_list<Attribute>;

  Markup& open(std::string_view tag, Attributes attributes = {});
  /// The innermost element that is open. @pre there is one
  Markup& close();
  /// An element with nothing but a text.
  Markup& element(std::string_view tag, std::string_view text, Attributes attributes = {});
  /// One that has no end: meta, input.
  Markup& single(std::string_view tag, Attributes attributes);
  Markup& words(std::string_view text);
  /// What is markup already, or the contents of style and script.
  Markup& verbatim(std::string_view markup);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::vector<std::string> open_;
};

}  // namespace kusabi::pictures
