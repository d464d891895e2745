// A proof for each block, and which of them a node needs.
#include "verify/proof.hpp"

#include <bit>
#include <utility>

namespace kusabi::verify {
namespace {

std::vector<std::size_t> members_of(std::uint64_t set) {
  std::vector<std::size_t> members;
  for (; set != 0; set &= set - 1) {
    members.push_back(static_cast<std::size_t>(std::countr_zero(set)));
  }
  return members;
}

// A set of candidates as bits of the block.
std::uint64_t within(std::uint64_t block, std::uint64_t set) {
  std::uint64_t result = 0;
  std::uint64_t bit = 1;
  for (; block != 0; block &= block - 1, bit <<= 1U) {
    if ((set & block & (~block + 1)) != 0) result |= bit;
  }
  return result;
}

ContactBlock part(const Certificate& certificate, const EnclosedMatrix& stiffness,
                  std::uint64_t block) {
  const auto d = certificate.dimension;
  ContactBlock result;
  result.dimension = d;
  std::vector<std::size_t> rows;
  for (const auto candidate : members_of(block)) {
    result.friction.push_back(certificate.friction[candidate]);
    result.names.push_back(certificate.names[candidate]);
    for (std::size_t k = 0; k < d; ++k) rows.push_back(d * candidate + k);
  }
  const auto& [middle, radius] = stiffness;
  result.stiffness.radius = radius;
  result.stiffness.middle.size = rows.size();
  auto& entries = result.stiffness.middle.entries;
  entries.exponent = middle.entries.exponent;
  for (const auto row : rows) {
    for (const auto column : rows) {
      entries.mantissas.push_back(middle.entries.mantissas[middle.size * row + column]);
    }
  }
  return result;
}

}  // namespace

EnclosedMatrix recorded_stiffness(const Certificate& certificate) {
  return {{certificate.displacements(), DyadicList(certificate.stiffness)}, Dyadic()};
}

Proof::Proof(const Certificate& certificate)
    : Proof(certificate, recorded_stiffness(certificate)) {}

Proof::Proof(const Certificate& certificate, const EnclosedMatrix& stiffness)
    : certificate_(certificate) {
  for (const auto block : certificate.blocks) {
    blocks_.emplace_back(part(certificate, stiffness, block));
    const auto& own = blocks_.back().least_eigenvalue();
    if (!own) {
      least_.reset();
      return;
    }
    if (!least_ || *own < *least_) least_ = own;
  }
}

std::optional<std::string> Proof::refusal(const Record& record) const {
  const auto block = certificate_.blocks[record.block];
  const auto contact = within(block, record.contact);
  const auto separated = within(block, record.separated);
  const auto& proof = blocks_[record.block];
  switch (record.claim) {
    case Claim::dead:
      return proof.refusal_of_dead(contact, separated, record.numbers);
    case Claim::alive:
      return proof.refusal_of_alive(contact, separated, record.numbers);
    default:
      return {};
  }
}

}  // namespace kusabi::verify
