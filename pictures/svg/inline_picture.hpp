// A scene as a part of a page of HTML: no title, lines or legend of its own, and one style for all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct InlinePicture {
  std::string id;           ///< of the element; no other on the page begins with it and a dash
  std::string title;        ///< its name for those who do not see it
  std::string description;  ///< what is to be seen, in a sentence
  bool large = false;       ///< with names and hatches
};

/// An svg element of the class "picture".
std::string inline_svg(const InlinePicture& picture, const Scene& scene);

/// What the marks mean of all the scenes, likewise. @pre at least one
std::string inline_legend(const InlinePicture& picture, const std::vector<Scene>& scenes);

/// What has been drawn, as such an element. @param size in pixels
std::string svg_element(const InlinePicture& picture, const Point& size, const Canvas& canvas);

/// The style of svg/style.hpp, charts included, for `svg.picture` alone, so that a page may use its
/// class names.
std::string inline_style();

}  // namespace kusabi::pictures
