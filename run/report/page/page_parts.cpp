// A page loads nothing, and has one style for itself and its pictures.
#include "run/report/page/page_parts.hpp"

#include "pictures/svg/inline_picture.hpp"
#include "run/report/page/page_style.hpp"

namespace kusabi::run {

using pictures::Markup;

namespace {

// Content security policy: the page loads nothing, whatever the file contains.
constexpr const char* nothing_from_elsewhere =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

void add_head(Markup& page, const std::string& title) {
  page.open("head").single("meta", {{"charset", "utf-8"}});
  page.single("meta",
              {{"http-equiv", "Content-Security-Policy"}, {"content", nothing_from_elsewhere}});
  page.single("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  page.single("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  page.element("title", title);
  page.open("style").verbatim(page_style).verbatim(pictures::inline_style()).close();
  page.close();
}

}  // namespace

void begin_page(Markup& page, const std::string& title) {
  page.verbatim("<!DOCTYPE html>\n").open("html", {{"lang", "en"}});
  add_head(page, title);
  page.open("body");
}

void add_list(Markup& page, const char* id, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  page.open("ul", {{"id", id}});
  for (const auto& each : sentences) page.element("li", each);
  page.close();
}

void open_figure(Markup& page, const std::string& turning) {
  if (turning.empty()) {
    page.open("figure");
  } else {
    page.open("figure", {{"data-scene", turning}});
  }
}

}  // namespace kusabi::run
