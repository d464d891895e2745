// Each answer has data attributes for the script to sort and filter by; without a script it is a
// plain list. On paper there are the first ten and a table.
#include "run/report/gallery.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "pictures/svg/legend.hpp"
#include "run/report/answer_parts.hpp"
#include "run/report/facts.hpp"
#include "run/report/page/page_parts.hpp"
#include "run/report/page/turning_view.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

/// Maximum number of characters of the names in a line of the choice.
constexpr std::size_t longest_choice = 40;

std::string description(const AnswerList& list, const Answer& answer) {
  return fmt::format("In contact: {}. Separated: {}.", list.names.of(answer.contact),
                     list.names.of(answer.separated));
}

// Legend of a large picture. @pre it has a scene
std::string large_legend(const ResultReader& reader, const Answer& answer, const std::string& id) {
  const auto& units = reader.at(reader.at(reader.all(), "problem"), "units");
  return inline_legend(
      {id, "Legend", "Legend of the large picture."},
      legend(*answer.scene, {reader.text(units, "length"), reader.text(units, "force")}));
}

class Gallery {
 public:
  Gallery(Markup& page, const ResultReader& reader, const AnswerList& list)
      : page_(page), reader_(reader), list_(list), rank_(list.answers.size()) {
    for (std::size_t i = 0; i < list.order.size(); ++i) rank_[list.order[i]] = i;
  }

  void add() {
    page_.open("section", {{"id", "answers"}});
    const auto& by = list_.ranked_by;
    page_.element("h2", fmt::format("All {}{}", list_.things,
                                    by.empty() ? by : fmt::format(", {} first", by)));
    draw();
    const auto drawn = list_.answers.size() -
                       static_cast<std::size_t>(std::ranges::count(pictures_, std::string()));
    if (drawn < list_.answers.size()) {
      page_.element("p", fmt::format("Pictures show {} of {} {}; the others are rows of the table "
                                     "below. kusabi draw --pattern N draws any of them.",
                                     drawn, list_.answers.size(), list_.things));
    }
    controls();
    for (std::size_t i = 0; i < list_.groups.groups.size(); ++i) group(i);
    table();
    page_.close();
  }

 private:
  void draw() {
    std::size_t bytes = 0;
    pictures_.resize(list_.answers.size());
    views_.resize(list_.answers.size());
    const auto* const leading = list_.answers[list_.order.front()].scene;
    const auto turning = leading == nullptr ? std::string() : turning_data(*leading);
    for (const auto i : list_.order) {
      const auto& answer = list_.answers[i];
      if (answer.scene == nullptr || bytes > max_picture_bytes) continue;
      pictures_[i] = inline_svg({fmt::format("picture-{}", answer.number), title_of(list_, answer),
                                 description(list_, answer)},
                                *answer.scene);
      bytes += pictures_[i].size();
      if (turning.empty() || bytes > max_picture_bytes) continue;
      views_[i] = turning_difference(*answer.scene, turning);
      bytes += views_[i].size();
    }
  }

  // Hidden until the script shows them.
  void controls() {
    page_.open("form", {{"id", "controls"}, {"hidden", ""}});
    page_.open("p").element("label", "In contact at ", {{"for", "filter"}});
    page_.single("input", {{"id", "filter"},
                           {"type", "search"},
                           {"list", "candidates"},
                           {"autocomplete", "off"},
                           {"placeholder", "name of a candidate"}});
    page_.open("datalist", {{"id", "candidates"}});
    for (const auto& each : reader_.list(reader_.at(reader_.all(), "problem"), "contact"))
      page_.single("option", {{"value", reader_.text(each, "node")}});
    page_.close().close();
    page_.open("p").element("label", "Sort by ", {{"for", "order"}});
    page_.open("select", {{"id", "order"}});
    page_.element("option", "groups", {{"value", "groups"}});
    if (!list_.ranked_by.empty())
      page_.element("option", list_.ranked_by + " first", {{"value", "rank"}});
    page_.element("option", "number", {{"value", "number"}});
    page_.element("option", "number of candidates in contact", {{"value", "size"}}).close().close();
    page_.open("p").element("button", "Show all", {{"type", "reset"}}).words(" ");
    page_.element("output", "", {{"id", "shown"}, {"aria-live", "polite"}}).close();
    page_.close();
  }

  [[nodiscard]] bool in_groups() const { return list_.groups.groups.size() > 1; }

  void group(std::size_t number) {
    const auto& own = list_.groups.groups[number];
    page_.open("div", {{"class", "group"}});
    if (in_groups()) {
      page_.element(
          "h3",
          own.members.size() == 1
              ? fmt::format("Group {}: one of the {}", number + 1, list_.things)
              : fmt::format("Group {}: {} {} that differ in up to {}", number + 1,
                            own.members.size(), list_.things,
                            answer::counted(std::min(2 * list_.groups.apart, own.varying.size()),
                                            "candidate")));
    }
    if (own.members.size() > 1) {
      page_.element("p",
                    fmt::format("In contact in all of them: {}; in some: {}.",
                                list_.names.of(own.always), list_.names.of(own.varying)),
                    {{"class", "remark"}});
    }
    page_.open("ul", {{"class", "gallery sorted"}});
    for (const auto i : own.members) {
      if (!pictures_[i].empty()) card(i);
    }
    page_.close().close();
  }

  void card(std::size_t i) {
    const auto& answer = list_.answers[i];
    open_answer(page_, "li", rank_[i] < max_printed ? "answer large" : "answer", answer, rank_[i]);
    page_.element(in_groups() ? "h4" : "h3", title_of(list_, answer));
    page_.open("div", {{"data-view", views_[i]}}).verbatim(pictures_[i]).close();
    add_terms(page_, list_, answer);
    add_reactions(page_, reader_, list_, answer);
    page_.open("div", {{"class", "legend"}, {"hidden", ""}});
    page_.verbatim(large_legend(reader_, answer, fmt::format("legend-{}", answer.number))).close();
    page_.close();
  }

  // Rows of answers without a picture; those of others are on paper only.
  void table() {
    if (list_.answers.size() <= max_printed && std::ranges::count(pictures_, std::string()) == 0)
      return;
    open_table(page_, fmt::format("The {} as rows", list_.things));
    page_.open("thead").open("tr");
    const auto column = [this](const std::string& name) {
      page_.element("th", name, {{"scope", "col"}});
    };
    column("number"), column("in contact"), column("separated");
    for (const auto& number : list_.answers.front().numbers) column(meaning(list_, number.key));
    column("reactions need μ");
    page_.close().close().open("tbody", {{"class", "sorted"}});
    for (const auto i : list_.order) row(i);
    page_.close().close().close();
  }

  void row(std::size_t i) {
    const auto& answer = list_.answers[i];
    if (!pictures_[i].empty()) {
      if (rank_[i] >= max_printed_rows) return;
      page_.open("tr", {{"class", "on-paper"}});
    } else {
      open_answer(page_, "tr", rank_[i] < max_printed_rows ? "answer" : "answer late", answer,
                  rank_[i]);
    }
    page_.element("th", std::to_string(answer.number), {{"scope", "row"}});
    page_.element("td", list_.names.of(answer.contact));
    page_.element("td", list_.names.of(answer.separated));
    for (const auto& number : answer.numbers) {
      page_.open("td", {{"class", number.key}});
      add_number(page_, number);
      page_.close();
    }
    page_.open("td");
    add_needed(page_, answer);
    page_.close().close();
  }

  Markup& page_;
  const ResultReader& reader_;
  const AnswerList& list_;
  std::vector<std::size_t> rank_;      // of each answer
  std::vector<std::string> pictures_;  // empty: none
  std::vector<std::string> views_;     // data of views that turn, as far as they differ
};

}  // namespace

namespace {

// Names of the contact candidates; a truss under loads has none.
std::vector<std::string> candidates(const ResultReader& reader) {
  std::vector<std::string> names;
  if (const auto* const list = ResultReader::find(reader.at(reader.all(), "problem"), "contact")) {
    for (const auto& each : *list) names.push_back(reader.text(each, "node"));
  }
  return names;
}

}  // namespace

AnswerList answer_list(const ResultReader& reader) {
  static_cast<void>(reader.at(reader.all(), "problem"));  // the first that another file lacks
  const auto command = reader.text(reader.all(), "command");
  AnswerList list{.things = command == "rays"   ? "rays"
                            : command == "hold" ? "states"
                                                : "patterns",
                  .ranked_by = command == "patterns" ? "largest margin" : "least friction",
                  .answers = answers(reader),
                  .order = {},
                  .groups = {},
                  .names = ShortNames(candidates(reader))};
  list.order = by_rank(reader, list.answers);
  // Most extremal rays need all of the friction, and states all act at one coefficient.
  const auto alike = [&](const Answer& each) { return each.needed == list.answers.front().needed; };
  if (command == "hold" || (command == "rays" && std::ranges::all_of(list.answers, alike)))
    list.ranked_by.clear();
  list.groups = answer_groups(list.answers, list.order, max_groups);
  if (list.groups.groups.size() == list.answers.size() && list.answers.size() > 1)
    list.groups = answer_groups(list.answers, list.order, 1);  // none has a second one
  return list;
}

std::vector<std::size_t> pictured(const AnswerList& list) {
  std::vector<bool> chosen(list.answers.size());
  std::size_t count = 0;
  const auto choose = [&](std::size_t i) {
    if (chosen[i] || count == max_pictures) return;
    chosen[i] = true;
    ++count;
  };
  for (const auto& group : list.groups.groups) choose(group.members.front());
  for (const auto i : list.order) choose(i);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) indices.push_back(i);
  }
  return indices;
}

namespace {

// Choice of the answer in the large picture; hidden until the script shows it.
void add_choice(Markup& page, const AnswerList& list) {
  page.open("p", {{"id", "choice"}, {"hidden", ""}});
  page.element("label", "Shown large: ", {{"for", "chosen"}}).open("select", {{"id", "chosen"}});
  for (const auto i : list.order) {
    const auto& answer = list.answers[i];
    if (answer.scene == nullptr) continue;
    page.element("option",
                 fmt::format("{}: {}", title_of(list, answer),
                             list.names.of(answer.contact, longest_choice)),
                 {{"value", fmt::format("answer-{}", answer.number)}});
  }
  page.close().close();
}

}  // namespace

void add_leading(Markup& page, const ResultReader& reader, const AnswerList& list) {
  const auto& answer = list.answers[list.order.front()];
  const bool alone = list.answers.size() == 1;
  page.open("section", {{"id", "leading"}, {"class", "beside"}});
  if (!alone) add_choice(page, list);
  if (answer.scene != nullptr) {
    open_figure(page, turning_data(*answer.scene));
    page.verbatim(
        inline_svg({"leading-picture", title_of(list, answer), description(list, answer), true},
                   *answer.scene));
    page.close();
  }
  if (alone) {
    open_answer(page, "div", "answer large", answer, 0);
  } else {
    page.open("div", {{"id", "leading-text"}, {"aria-live", "polite"}});
  }
  const bool named = alone || list.ranked_by.empty();
  page.element("h2", named ? title_of(list, answer)
                           : fmt::format("{}, {}", title_of(list, answer), list.ranked_by));
  add_terms(page, list, answer);
  add_reactions(page, reader, list, answer);
  if (answer.scene != nullptr) page.verbatim(large_legend(reader, answer, "legend"));
  page.close().close();
}

void add_gallery(Markup& page, const ResultReader& reader, const AnswerList& list) {
  Gallery(page, reader, list).add();
}

}  // namespace kusabi::run
