// The distance from the curve is a statement about the numbers of the file, so all digits are shown.
#include "run/report/load_curve.hpp"

#include <fmt/format.h>

#include "answer/words.hpp"
#include "run/report/facts.hpp"

namespace kusabi::run {

void add_load_curve(pictures::Markup& page, const ResultReader& reader, const std::string& key,
                    const std::string& variable, const std::string& load) {
  const auto& result = reader.at(reader.all(), "result");
  const auto& pieces = reader.list(result, key.c_str());
  if (pieces.empty()) return;
  begin_table(page, "Linear pieces of the curve",
              {variable + " from", "to", "factor from", "to", "off by at most", "standing",
               "along the reference load", "yielding members"});
  for (const auto& piece : pieces) {
    page.open("tr");
    for (const char* const column : {"from", "to", "factor_from", "factor_to"}) {
      page.open("td");
      add_number(page, &reader.at(piece, column), all_digits);
      page.close();
    }
    const auto* const error = ResultReader::find(piece, "error");
    page.open("td");
    add_number(page, error, few_digits, Rounding::up);
    page.close();
    page.element("td", answer::standing_word(support::proved_if(error != nullptr)));
    const auto* const along = ResultReader::find(piece, "along_reference_load");
    page.element("td", along == nullptr ? "–" : *along == true ? "yes" : "no");
    page.element("td", joined(reader.names(piece, "yielding"))).close();
  }
  end_table(page);
  if (const auto* const end = ResultReader::find(result, (key + "_end").c_str()))
    add_facts(page, fmt::format("End of the curve: beyond it, {} is carried at no factor", load),
              *end);
}

}  // namespace kusabi::run
