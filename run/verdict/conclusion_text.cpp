// One line for each part of the verdict.
#include "run/verdict/conclusion_text.hpp"

#include "run/verdict/words.hpp"

namespace kusabi::run {

std::string conclusion_text(const Verdict& verdict, const Page& page) {
  std::string text;
  const auto sentence = headline(verdict);
  if (!sentence.empty()) {
    text = '\n' + page.strong(sentence);
    for (const auto& each : verdict.details) text += ' ' + each;
    text += '\n';
  }
  for (const auto& each : reservations(verdict)) text += page.warning(each.sentence) + '\n';
  for (const auto& each : verdict.warnings) text += page.warning("Warning: " + each) + '\n';
  return text;
}

}  // namespace kusabi::run
