/// Binds the signals that formulas of elements read (system/read_signals.hpp).
#pragma once

namespace dynamy {

class Model;

/// Called once by Model::build(), when all elements have described themselves. Throws ModelError
/// with the places of names that no signal has, of signals of contact forces, and with the signals
/// of an algebraic loop.
void bindSignals(Model& model);

}  // namespace dynamy
