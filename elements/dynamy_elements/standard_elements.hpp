/// Completion of a model that is made in C++: it adds what follows from the model's elements.
/// Models that are read from files get it from the registry.
#pragma once

namespace dynamy {

class Model;

/// To be called before build(): shapes with a material can then touch each other (ShapeContacts),
/// and bodies take minimal coordinates where the model requests them (composeTrees).
void completeStandardElements(Model& model);

}  // namespace dynamy
