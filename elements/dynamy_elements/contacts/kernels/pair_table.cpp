#include <algorithm>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy_elements/contacts/kernels/pair_table.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

/// Distances of two shapes without an inside, and of a line and an edge, have no sign: one shape
/// would pass through the other. A mesh has one side: a body deeper than its own size counts as on
/// the other side, a point immediately.
bool wouldPassThrough(const TouchingShape& A, const TouchingShape& B, PairTable::Room room) {
  if (A.kind == Touch::halfSpace || A.kind == Touch::ball) return false;
  if (B.isThin() && A.isThin()) return true;
  if (room == PairTable::Room::plane) return false;
  return (B.thickness == 0.0 && (A.kind == Touch::box || A.surface)) ||
         (B.isThin() && A.kind == Touch::surface);
}

}  // namespace

PairTable::Side PairTable::sideOf(const ShapeFamily& family) {
  if (&family == &ShapeFamily::halfSpace) return {Touch::halfSpace};
  if (&family == &ShapeFamily::ball) return {Touch::ball};
  return {Touch::own, &family};
}

PairTable::Key PairTable::keyOf(const Side& a, const Side& b, Room room) {
  return {std::max(a, b), std::min(a, b), room};
}

void PairTable::add(std::unique_ptr<const PairKernel> kernel, std::initializer_list<Room> rooms,
                    std::initializer_list<Kinds> kinds) {
  kernels_.push_back(std::move(kernel));
  for (const Room room : rooms)
    for (const auto& [a, b] : kinds)
      if (!of_.try_emplace(keyOf({a}, {b}, room), kernels_.back().get()).second)
        throw ModelError("the contact of two kinds of shapes is given twice",
                         "each pair has one kernel");
}

void PairTable::add(std::unique_ptr<const PairKernel> kernel, const ShapeFamily& a,
                    const ShapeFamily& b) {
  kernels_.push_back(std::move(kernel));
  const Key key = keyOf(sideOf(a), sideOf(b), Room::space);
  if (!of_.try_emplace(key, kernels_.back().get()).second)
    throw ModelError("the contact of a " + a.name + " with a " + b.name + " is given twice",
                     "of two families, one names their pair");
}

const PairKernel* PairTable::find(const TouchingShape& A, const TouchingShape& B, Room room) const {
  const auto at = of_.find(keyOf({A.kind, A.family}, {B.kind, B.family}, room));
  if (at == of_.end() || wouldPassThrough(A, B, room)) return nullptr;
  return at->second->fits(A, B) ? at->second : nullptr;
}

bool PairTable::neverTouch(const TouchingShape& A, const TouchingShape& B) {
  const bool balls = A.kind == Touch::ball && B.kind == Touch::ball;
  return (A.kind == Touch::halfSpace && B.kind == Touch::halfSpace) ||
         (A.kind == Touch::bore && B.kind == Touch::bore) || (balls && !(A.bound + B.bound > 0.0));
}

}  // namespace dynamy
