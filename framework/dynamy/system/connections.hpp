/// Connections: which systems each force and contact element acts on, noted while the elements are
/// connected one after the other.
#pragma once
#include <utility>
#include <vector>

namespace dynamy {

class Element;

/// What one force or contact element requested while it was connected.
struct Connection {
  const Element* element = nullptr;
  std::vector<int> systems;  ///< systems whose frames or coordinates it requested, ascending
  bool shapes = false;       ///< true: all shapes with a material, of all systems
};

class Connections {
 public:
  /// Until the next call, what is requested is noted as a connection of `element`; null: not noted.
  void begin(const Element* element);
  /// A frame or the coordinates of system number `system` are requested.
  void note(int system);
  /// All shapes with a material are requested.
  void noteShapes();
  /// `element` acts by what these systems do, too.
  void add(const Element& element, const std::vector<int>& systems);
  void add(Connection connection) { list_.push_back(std::move(connection)); }
  /// One entry per element, in the order in which they were connected.
  const std::vector<Connection>& list() const { return list_; }

 private:
  std::vector<Connection> list_;
  bool noting_ = false;
};

}  // namespace dynamy
