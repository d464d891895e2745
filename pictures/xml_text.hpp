// Names and sentences in XML, whatever bytes they hold.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::pictures {

/// What may stand between tags or quotation marks: &amp; and the like for what XML means otherwise,
/// U+FFFD for what it does not permit and for bytes that are not UTF-8.
std::string xml_text(std::string_view text);

/// The same as a comment, which may not hold two dashes in a row; empty if the text is.
std::string xml_comment(std::string_view text);

}  // namespace kusabi::pictures
