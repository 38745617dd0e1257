/// Shapes of mesh files: the attributes `file` and `scale`, beside a list of points.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/mesh/mesh_file.hpp>

namespace dynamy {

/// Declares `points` (optional, with this meaning), `file` and `scale`.
void declareShapeFile(Attributes& a, const char* points);

/// Vectors of three numbers each. Throws ModelError for another count or fewer than `least`.
std::vector<Vec3> triples(const ParameterValue& value, const char* what, std::size_t least);

/// The mesh of `file`, scaled; none if points are given. Throws ModelError if neither or both are,
/// or if the file cannot be read.
bool readShapeFile(const Parameters& x, TriangleMesh& mesh);

}  // namespace dynamy
