/// What a model made in C++ needs besides the elements that it adds. Models that are read get it from
/// the registry.
#pragma once

namespace dynamy {

class Model;

/// Before build(): shapes with a material touch each other (ShapeContacts), and bodies take minimal
/// coordinates where the model asks for them (composeTrees).
void completeStandardElements(Model& model);

}  // namespace dynamy
