// HTML elements and escaped text; HTML escapes the same characters as XML.
#include "pictures/html/markup.hpp"

#include <iterator>

#include <fmt/format.h>

#include "pictures/xml_text.hpp"

namespace kusabi::pictures {

Markup& Markup::single(std::string_view tag, Attributes attributes) {
  fmt::format_to(std::back_inserter(text_), "<{}", tag);
  for (const auto& [name, value] : attributes)
    fmt::format_to(std::back_inserter(text_), " {}=\"{}\"", name, xml_text(value));
  text_ += '>';
  return *this;
}

Markup& Markup::open(std::string_view tag, Attributes attributes) {
  open_.emplace_back(tag);
  return single(tag, attributes);
}

Markup& Markup::close() {
  // Line breaks separate elements, except within an element that contains numbers.
  const bool within_words = open_.back() == "data";
  fmt::format_to(std::back_inserter(text_), "</{}>{}", open_.back(), within_words ? "" : "\n");
  open_.pop_back();
  return *this;
}

Markup& Markup::element(std::string_view tag, std::string_view text, Attributes attributes) {
  return open(tag, attributes).words(text).close();
}

Markup& Markup::words(std::string_view text) {
  text_ += xml_text(text);
  return *this;
}

Markup& Markup::verbatim(std::string_view markup) {
  text_ += markup;
  return *this;
}

}  // namespace kusabi::pictures
