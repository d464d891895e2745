// Each answer has data attributes for the script to sort and filter by; without a script it is a
// plain list.
#include "run/report/gallery.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "pictures/svg/inline_picture.hpp"
#include "run/report/facts.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

std::string with_capital(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string meaning(std::string_view key) {
  if (key == "margin") return "margin t*";
  if (key == "margin_upper") return "t* is at most";
  if (key == "lower") return "cannot stick at μ";
  return "sticks at μ";
}

// Largest distance of lower and upper bound that are displayed as one number.
int digits_of(std::string_view key) {
  return key == "lower" || key == "upper" ? many_digits : few_digits;
}

class Gallery {
 public:
  Gallery(Markup& page, const ResultReader& reader, std::string things,
          const std::vector<Answer>& answers)
      : page_(page), reader_(reader), things_(std::move(things)), answers_(answers) {
    problem_ = &reader.at(reader.all(), "problem");
    force_ = reader.text(reader.at(*problem_, "units"), "force");
    thing_ = things_.substr(0, things_.size() - 1);
  }

  void add() {
    page_.open("section", {{"id", "answers"}});
    page_.element("h2", with_capital(things_));
    draw();
    if (pictures_.size() < answers_.size()) {
      page_.element("p", fmt::format("Pictures show the first {} of {} {}; the others are rows of "
                                     "the table below. kusabi draw --pattern N draws any of them.",
                                     pictures_.size(), answers_.size(), things_));
    }
    controls();
    page_.open("ul", {{"class", "gallery sorted"}});
    for (std::size_t i = 0; i < pictures_.size(); ++i) card(answers_[i], pictures_[i]);
    page_.close();
    if (pictures_.size() < answers_.size()) table();
    page_.close();
  }

 private:
  void draw() {
    std::size_t bytes = 0;
    for (const auto& answer : answers_) {
      std::string picture;
      if (answer.scene != nullptr) {
        picture = inline_svg(
            {fmt::format("picture-{}", answer.number),
             with_capital(fmt::format("{} {}", thing_, answer.number)),
             fmt::format("In contact: {}. Separated: {}. Inactive: {}.", joined(answer.contact),
                         joined(answer.separated), joined(answer.at_rest))},
            *answer.scene);
      }
      bytes += picture.size();
      if (pictures_.size() == most_pictures || bytes > most_picture_bytes) return;
      pictures_.push_back(std::move(picture));
    }
  }

  // Hidden until the script shows them.
  void controls() {
    const bool has_order = std::ranges::any_of(
        answers_, [](const Answer& answer) { return answer.order.has_value(); });
    page_.open("form", {{"id", "controls"}, {"hidden", ""}});
    page_.open("p").element("label", "In contact at ", {{"for", "filter"}});
    page_.single("input", {{"id", "filter"},
                           {"type", "search"},
                           {"list", "candidates"},
                           {"autocomplete", "off"},
                           {"placeholder", "name of a candidate"}});
    page_.open("datalist", {{"id", "candidates"}});
    for (const auto& each : reader_.list(*problem_, "contact"))
      page_.single("option", {{"value", reader_.text(each, "node")}});
    page_.close().close();
    page_.open("p").element("label", "Sort by ", {{"for", "order"}});
    page_.open("select", {{"id", "order"}}).element("option", "number", {{"value", "number"}});
    if (has_order) {
      const auto critical = reader_.text(reader_.all(), "command") == "critical";
      page_.element("option", critical ? "friction coefficient" : "largest margin first",
                    {{"value", critical ? "friction" : "margin"}});
    }
    page_.element("option", "number of candidates in contact", {{"value", "size"}}).close().close();
    page_.open("p").element("button", "Show all", {{"type", "reset"}}).words(" ");
    page_.element("output", "", {{"id", "shown"}, {"aria-live", "polite"}}).close();
    page_.close();
  }

  // Data attributes for the script.
  void open_answer(std::string_view tag, std::string_view kind, const Answer& answer) {
    page_.open(tag, {{"class", std::string(kind)},
                     {"id", fmt::format("answer-{}", answer.number)},
                     {"data-number", std::to_string(answer.number)},
                     {"data-order", answer.order ? fmt::format("{}", *answer.order) : ""},
                     {"data-size", std::to_string(answer.contact.size())},
                     {"data-contact", ResultJson(answer.contact).dump()}});
  }

  void card(const Answer& answer, const std::string& picture) {
    open_answer("li", "answer", answer);
    page_.element("h3", with_capital(fmt::format("{} {}", thing_, answer.number)));
    page_.verbatim(picture);
    page_.open("dl");
    const auto names = [this](const char* what, const std::vector<std::string>& set) {
      page_.element("dt", what).element("dd", joined(set));
    };
    names("in contact", answer.contact);
    names("separated", answer.separated);
    if (!answer.at_rest.empty()) names("inactive", answer.at_rest);
    if (!answer.state.empty()) page_.element("dt", "state").element("dd", answer.state);
    for (const auto& [key, value] : answer.numbers) {
      page_.element("dt", meaning(key)).open("dd", {{"class", key}});
      add_number(page_, value, digits_of(key));
      page_.close();
    }
    page_.close();
    if (answer.reaction != nullptr) reactions(answer);
    page_.close();
  }

  void reactions(const Answer& answer) {
    constexpr const char* components[] = {"r_n", "r_t1", "r_t2"};
    const auto& candidates = reader_.list(*problem_, "contact");
    const auto d = static_cast<int>(reader_.number(*problem_, "d"));
    page_.open("details").element("summary", fmt::format("Reactions, {}", force_));
    open_table(page_,
               fmt::format("Reactions of {} {} along n and t, {}", thing_, answer.number, force_));
    page_.open("thead").open("tr").element("th", "candidate", {{"scope", "col"}});
    for (int axis = 0; axis < d; ++axis) page_.element("th", components[axis], {{"scope", "col"}});
    page_.close().close().open("tbody");
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const auto& row = (*answer.reaction)[i];
      if (reader_.vector(row, d).isZero(0)) continue;
      page_.open("tr").element("th", reader_.text(candidates[i], "node"), {{"scope", "row"}});
      for (const auto& component : row) {
        page_.open("td");
        add_number(page_, &component);
        page_.close();
      }
      page_.close();
    }
    page_.close().close().close();
    page_.element("p", "All other reactions are zero.", {{"class", "remark"}}).close();
  }

  void table() {
    open_table(page_, fmt::format("The other {}", things_));
    page_.open("thead").open("tr");
    const auto column = [this](std::string_view title) {
      page_.element("th", title, {{"scope", "col"}});
    };
    column("number");
    column("in contact");
    column("separated");
    column("state");
    for (const auto& [key, value] : answers_.front().numbers) column(meaning(key));
    page_.close().close().open("tbody", {{"class", "sorted"}});
    for (std::size_t i = pictures_.size(); i < answers_.size(); ++i) {
      const auto& answer = answers_[i];
      open_answer("tr", "answer", answer);
      page_.element("th", std::to_string(answer.number), {{"scope", "row"}});
      page_.element("td", joined(answer.contact)).element("td", joined(answer.separated));
      page_.element("td", answer.state.empty() ? "–" : answer.state);
      for (const auto& [key, value] : answer.numbers) {
        page_.open("td", {{"class", key}});
        add_number(page_, value, digits_of(key));
        page_.close();
      }
      page_.close();
    }
    page_.close().close().close();
  }

  Markup& page_;
  const ResultReader& reader_;
  std::string things_;
  const std::vector<Answer>& answers_;
  const ResultJson* problem_ = nullptr;
  std::string force_;
  std::string thing_;
  std::vector<std::string> pictures_;
};

}  // namespace

void add_gallery(Markup& page, const ResultReader& reader, const std::string& things,
                 const std::vector<Answer>& answers) {
  Gallery(page, reader, things, answers).add();
}

}  // namespace kusabi::run
