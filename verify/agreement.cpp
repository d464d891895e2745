// One thing after the other, the cheap ones first.
#include "verify/agreement.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <optional>

#include "verify/assembly.hpp"
#include "verify/condensation.hpp"

namespace kusabi::verify {
namespace {

std::string text_of(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::optional<std::string> other_candidates(const Certificate& certificate,
                                            const Structure& structure) {
  if (certificate.dimension != structure.dimension) {
    return "it is about dimension " + std::to_string(certificate.dimension) +
           ", the structure has dimension " + std::to_string(structure.dimension);
  }
  if (certificate.candidates() != structure.contact.size()) {
    return "it has " + std::to_string(certificate.candidates()) +
           " contact candidates, the structure has " + std::to_string(structure.contact.size());
  }
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto name = on_one_line(structure.names[structure.contact[i].node]);
    if (name != certificate.names[i]) {
      return "its contact candidate " + std::to_string(i + 1) + " is " + certificate.names[i] +
             ", that of the structure " + name;
    }
  }
  return {};
}

// mu_i = mu times the relative friction, but for rounding.
std::variant<double, std::string> common_friction(const Certificate& certificate,
                                                  const Structure& structure) {
  constexpr double roundings = 0x1p-50;
  double mu = 0;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const double relative = structure.contact[i].friction;
    const double own = certificate.friction[i];
    if (mu == 0 && relative != 0) mu = own / relative;
    if (!(std::abs(own - mu * relative) <= roundings * own)) {
      return "the friction at " + certificate.names[i] + " is " + text_of(own) +
             ", but with the relative frictions of the structure expected to be " +
             text_of(mu * relative) + ", as at the candidates before";
    }
  }
  return mu;
}

std::optional<std::string> other_blocks(const Certificate& certificate,
                                        const Structure& structure) {
  const auto piece = pieces(structure, Freedom(structure));
  for (const auto block : certificate.blocks) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const bool one = ((block >> i) & 1U) != 0;
      const bool other = ((block >> piece[i]) & 1U) != 0;
      if (one != other) {
        return certificate.names[piece[i]] + " and " + certificate.names[i] +
               " are in different blocks, but the structure connects them";
      }
    }
  }
  return {};
}

std::string direction_name(const Certificate& certificate, std::size_t displacement) {
  constexpr std::array<const char*, 3> kinds{"n", "t1", "t2"};
  const auto d = certificate.dimension;
  return certificate.names[displacement / d] + " (" +
         (d == 2 && displacement % d == 1 ? "t" : kinds[displacement % d]) + ")";
}

std::optional<std::string> other_stiffness(const Certificate& certificate,
                                           const EnclosedMatrix& stiffness) {
  const auto d = certificate.dimension;
  const auto size = certificate.displacements();
  const auto& entries = stiffness.middle.entries;
  std::vector<double> scale(certificate.candidates(), 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    scale[i / d] = std::max(scale[i / d], std::sqrt(entries[size * i + i].nearest()));
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double true_one = entries[size * i + j].nearest();
      const double own = certificate.stiffness[size * i + j];
      // Written so that NaN fails too.
      if (!(std::abs(own - true_one) <= stiffness_tolerance * scale[i / d] * scale[j / d])) {
        return "its K is not that of the structure: between " + direction_name(certificate, i) +
               " and " + direction_name(certificate, j) + " it is " + text_of(own) + ", expected " +
               text_of(true_one);
      }
    }
  }
  return {};
}

}  // namespace

std::string on_one_line(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || c == '\x7f') {
      constexpr std::string_view digits = "0123456789abcdef";
      text += "\\x";
      text += digits[byte / 16];
      text += digits[byte % 16];
    } else {
      text += c;
    }
  }
  return text;
}

std::variant<Agreement, std::string> agreement(const Certificate& certificate,
                                               const Structure& structure) {
  if (auto why = other_candidates(certificate, structure)) return *why;
  auto friction = common_friction(certificate, structure);
  if (auto* why = std::get_if<std::string>(&friction)) return *why;
  if (auto why = other_blocks(certificate, structure)) return *why;
  auto stiffness = condensed_stiffness(structure);
  if (auto* why = std::get_if<std::string>(&stiffness)) {
    return "K of the structure was not enclosed: " + *why;
  }
  auto& enclosed = std::get<EnclosedMatrix>(stiffness);
  if (auto why = other_stiffness(certificate, enclosed)) return *why;
  return Agreement{std::move(enclosed), std::get<double>(friction)};
}

}  // namespace kusabi::verify
