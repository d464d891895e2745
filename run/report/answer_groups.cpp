// Contact sets as bits, so that ten thousand of them are compared in milliseconds.
#include "run/report/answer_groups.hpp"

#include <bit>
#include <cstdint>
#include <map>

namespace kusabi::run {
namespace {

using Bits = std::vector<std::uint64_t>;

constexpr std::size_t word_size = 64;

std::size_t distance(const Bits& a, const Bits& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += static_cast<std::size_t>(std::popcount(a[i] ^ b[i]));
  return count;
}

std::vector<Bits> contact_bits(const std::vector<Answer>& answers) {
  std::map<std::string, std::size_t> index;
  for (const auto& answer : answers) {
    for (const auto& name : answer.contact) index.emplace(name, index.size());
  }
  std::vector<Bits> all(answers.size(), Bits(index.size() / word_size + 1));
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (const auto& name : answers[i].contact) {
      const auto at = index.at(name);
      all[i][at / word_size] |= std::uint64_t{1} << (at % word_size);
    }
  }
  return all;
}

// Empty if there are more than `maximum` groups.
std::vector<AnswerGroup> around_leading(const std::vector<Bits>& bits,
                                        const std::vector<std::size_t>& order, std::size_t apart,
                                        std::size_t maximum) {
  std::vector<AnswerGroup> groups;
  for (const auto i : order) {
    AnswerGroup* own = nullptr;
    for (auto& group : groups) {
      if (distance(bits[group.members.front()], bits[i]) <= apart) {
        own = &group;
        break;
      }
    }
    if (own == nullptr) {
      if (groups.size() == maximum) return {};
      own = &groups.emplace_back();
    }
    own->members.push_back(i);
  }
  return groups;
}

void take_names(AnswerGroup& group, const std::vector<Answer>& answers) {
  std::map<std::string, std::size_t> counts;
  for (const auto i : group.members) {
    for (const auto& name : answers[i].contact) ++counts[name];
  }
  for (const auto& [name, count] : counts)
    (count == group.members.size() ? group.always : group.varying).push_back(name);
}

}  // namespace

AnswerGroups answer_groups(const std::vector<Answer>& answers,
                           const std::vector<std::size_t>& order, std::size_t maximum) {
  const auto bits = contact_bits(answers);
  AnswerGroups found;
  if (answers.empty()) return found;
  for (found.apart = 2; found.groups.empty(); found.apart *= 2)
    found.groups = around_leading(bits, order, found.apart, maximum);
  found.apart /= 2;
  for (auto& group : found.groups) take_names(group, answers);
  return found;
}

}  // namespace kusabi::run
