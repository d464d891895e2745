// Markup: HTML element by element. Content is escaped, and elements are closed in order.
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
  /// Closes the innermost open element. @pre an element is open
  Markup& close();
  /// An element with text only.
  Markup& element(std::string_view tag, std::string_view text, Attributes attributes = {});
  /// An element without an end tag: meta, input.
  Markup& single(std::string_view tag, Attributes attributes);
  Markup& words(std::string_view text);
  /// Adds markup, or the content of style and script, unescaped.
  Markup& verbatim(std::string_view markup);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::vector<std::string> open_;
};

}  // namespace kusabi::pictures
