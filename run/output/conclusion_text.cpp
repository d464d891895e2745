// One line for each part of the verdict.
#include "run/output/conclusion_text.hpp"

#include "answer/words.hpp"

namespace kusabi::run {

std::string conclusion_text(const answer::Verdict& verdict, const Page& page) {
  std::string text;
  const auto sentence = answer::headline(verdict);
  if (!sentence.empty()) {
    text = '\n' + page.strong(sentence);
    for (const auto& each : verdict.details) text += ' ' + each;
    text += '\n';
  }
  for (const auto& each : answer::reservations(verdict)) text += page.warning(each.sentence) + '\n';
  for (const auto& each : verdict.warnings) text += page.warning("Warning: " + each) + '\n';
  return text;
}

}  // namespace kusabi::run
