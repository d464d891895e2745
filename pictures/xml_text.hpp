// XML text from names and sentences with arbitrary bytes.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::pictures {

/// Text for elements and attributes: &amp; and the like for special characters, U+FFFD for
/// characters that XML does not permit and for bytes that are not UTF-8.
std::string xml_text(std::string_view text);

/// A comment, which must not contain two dashes in a row; empty if the text is.
std::string xml_comment(std::string_view text);

}  // namespace kusabi::pictures
