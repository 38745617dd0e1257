/// PairTable: which kernel finds the contacts of which two kinds of shapes.
///
///   (kind of A, kind of B, in space or in a plane)  →  PairKernel
///
/// The standard shapes have their pairs in standard_pairs.hpp. Shapes of plug-ins bring theirs:
/// addFamily() puts them into the same table (given_pair.hpp).
#pragma once
#include <compare>
#include <dynamy_elements/contacts/kernels/pair_kernel.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace dynamy {

class PairTable {
 public:
  enum class Room : std::uint8_t { space, plane };
  /// Two standard kinds, in any order: A is the one that comes later.
  using Kinds = std::pair<TouchingShape::Kind, TouchingShape::Kind>;

  /// Makes `kernel` the one of all these kinds. Throws ModelError if two of them have a kernel.
  void add(std::unique_ptr<const PairKernel> kernel, std::initializer_list<Room> rooms,
           std::initializer_list<Kinds> kinds);
  /// Makes `kernel` the one of two families in space, in any order. Throws ModelError if they have
  /// a kernel.
  void add(std::unique_ptr<const PairKernel> kernel, const ShapeFamily& a, const ShapeFamily& b);
  /// The kernel of A with B, whose kind comes earlier or is the same; null: their contact is not
  /// available.
  const PairKernel* find(const TouchingShape& A, const TouchingShape& B, Room room) const;
  /// Two half spaces, two bores, and two points, never touch: no kernel is missing.
  static bool neverTouch(const TouchingShape& A, const TouchingShape& B);

 private:
  /// What a shape is: a standard kind, or a family of a plug-in.
  struct Side {
    TouchingShape::Kind kind;
    const ShapeFamily* family = nullptr;
    auto operator<=>(const Side&) const = default;
  };
  using Key = std::tuple<Side, Side, Room>;
  static Side sideOf(const ShapeFamily& family);
  static Key keyOf(const Side& a, const Side& b, Room room);

  std::vector<std::unique_ptr<const PairKernel>> kernels_;
  std::map<Key, const PairKernel*> of_;
};

}  // namespace dynamy
