#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_mesh.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>
#include <dynamy_elements/contacts/search/feature_pairs.hpp>
#include <dynamy_elements/contacts/search/meeting.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>

namespace dynamy {

using Touch = TouchingShape::Kind;

namespace {

/// Is it a concave contour? Such a contour may touch a plane at more than one point.
bool goesIn(const TouchingShape& s) {
  return s.kind == Touch::contour && !s.features[0].contour->convex();
}

bool isDisc(const TouchingShape& s) {
  return s.kind == Touch::cylinder || s.kind == Touch::torus || s.kind == Touch::cone;
}

}  // namespace

namespace {

/// Contacts in a plane of ellipses, and of capsules on polygons.
Meeting roundInPlane(const TouchingShape& A, const TouchingShape& B) {
  const bool polygon = !A.polygon_K.empty();
  if (polygon && B.kind == Touch::capsule) return Meeting::capsuleOnPolygon;
  if (polygon && B.kind == Touch::smooth) return Meeting::smoothOnPolygon;
  if (A.kind != Touch::smooth) return Meeting::missing;
  if (B.kind == Touch::capsule) return Meeting::capsuleOnSmooth;
  return B.kind == Touch::smooth || B.kind == Touch::ball ? Meeting::smoothInPlane
                                                          : Meeting::missing;
}

}  // namespace

Meeting meeting(const TouchingShape& A, const TouchingShape& B, bool inPlane) {
  if (A.kind == Touch::none || B.kind == Touch::none) return Meeting::missing;
  if (A.kind == Touch::halfSpace)
    return B.kind == Touch::halfSpace        ? Meeting::never
           : B.features.empty() || goesIn(B) ? Meeting::missing
                                             : Meeting::overHalfSpace;
  if (A.kind == Touch::ball) return A.bound + B.bound > 0.0 ? Meeting::balls : Meeting::never;
  // Distances of two shapes without an inside, and of a line and an edge, have no sign: one shape
  // would pass through the other. A mesh has one side: a body deeper than its own size counts as on
  // the other side, a point immediately.
  if (B.isThin() && A.isThin()) return Meeting::missing;
  if (!inPlane && B.thickness == 0.0 && (A.kind == Touch::box || A.surface))
    return Meeting::missing;
  if (!inPlane && B.isThin() && A.kind == Touch::surface) return Meeting::missing;
  if (inPlane && !A.polygon_K.empty() && !B.polygon_K.empty()) return Meeting::polygons;
  if (inPlane)
    if (const Meeting found = roundInPlane(A, B); found != Meeting::missing) return found;
  if (A.kind == Touch::contour && B.kind == Touch::ball) return Meeting::ballOnContour;
  if (inPlane && A.kind != Touch::box && !A.polygon_K.empty() && B.kind == Touch::ball)
    return Meeting::ballOnPolygon;
  if (A.kind == Touch::box && B.kind == Touch::box)
    return A.isBox(8) && B.isBox(8) ? Meeting::boxes : Meeting::missing;
  if (A.kind == Touch::box && B.kind == Touch::ball)
    return inPlane == A.isBox(4) ? Meeting::ballOnBox : Meeting::missing;
  if (!inPlane && B.kind == Touch::smooth && A.polyhedron) return Meeting::smoothOnPolyhedron;
  if (!inPlane && isDisc(B) && A.polyhedron) return Meeting::discOnPolyhedron;
  if (!inPlane && isDisc(A) && (isDisc(B) || B.kind == Touch::capsule)) return Meeting::discs;
  if (!inPlane && A.kind == Touch::torus && B.kind == Touch::ball) return Meeting::discs;
  if (!inPlane && A.kind == Touch::smooth && (isDisc(B) || B.kind == Touch::capsule))
    return Meeting::smoothOnDisc;
  if (!inPlane && A.kind == Touch::smooth)
    return B.kind == Touch::smooth || B.kind == Touch::ball ? Meeting::smooth : Meeting::missing;
  if (!inPlane && A.surface) {
    if (B.kind == Touch::ball) return Meeting::ballOnSurface;
    if (B.kind == Touch::capsule) return Meeting::capsuleOnSurface;
    if (isDisc(B)) return Meeting::discOnMesh;
    if (B.kind == Touch::smooth) return Meeting::smoothOnMesh;
    if (B.polyhedron) return A.polyhedron ? Meeting::polyhedra : Meeting::polyhedronOnMesh;
  }
  if (A.kind == Touch::capsule)
    return B.kind == Touch::capsule ? Meeting::capsules : Meeting::ballOnCapsule;
  if (A.kind == Touch::cylinder && B.kind == Touch::ball) return Meeting::ballOnCylinder;
  if (A.kind == Touch::cone && B.kind == Touch::ball) return Meeting::ballOnCone;
  if (A.kind == Touch::box && B.kind == Touch::capsule && !inPlane && A.isBox(8))
    return Meeting::capsuleOnBox;
  return Meeting::missing;
}

Traits traits(const TouchingShape& s) {
  const auto number = [](auto n) { return static_cast<std::uint64_t>(n); };
  Traits out{number(s.kind),         number(s.features.size()),  number(!s.grain_K.isZero(0.0)),
             number(s.bound == 0.0), number(s.thickness == 0.0), number(s.polygon_K.size()),
             number(goesIn(s))};
  if (s.surface) {
    out[7] = 1, out[8] = number(s.surface->corners());
    out[9] = number(s.surface->edges()), out[10] = number(s.surface->faces().size());
  }
  if (s.polyhedron) {
    out[11] = 1, out[12] = number(s.polyhedron->corners().size());
    out[13] = number(s.polyhedron->edges().size()), out[14] = number(s.polyhedron->faces().size());
  }
  return out;
}

std::uint64_t followedOf(Meeting meets, const TouchingShape& A, const TouchingShape& B) {
  if (meets == Meeting::polygons)
    return static_cast<std::uint64_t>(featurePairs(A.polygon_K, B.polygon_K));
  if (meets != Meeting::boxes && meets != Meeting::polyhedra) return 0;
  return static_cast<std::uint64_t>(featurePairs(*A.polyhedron, *B.polyhedron));
}

std::uint64_t featuresOf(Meeting meets, const TouchingShape& A, const TouchingShape& B) {
  switch (meets) {
    case Meeting::overHalfSpace:
      return B.features.size();
    case Meeting::ballOnSurface:
    case Meeting::smoothOnMesh:
      return static_cast<std::uint64_t>(A.surface->features()) + (A.polyhedron ? 1 : 0);
    case Meeting::capsules:
      return kCapsules;
    case Meeting::capsuleOnBox:
      return kCapsuleOnBox;
    case Meeting::capsuleOnSurface:
      return static_cast<std::uint64_t>(capsuleFeatures(*A.surface));
    case Meeting::polyhedra:
      return static_cast<std::uint64_t>(polyhedraFeatures(*A.polyhedron, *B.polyhedron)) +
             followedOf(meets, A, B);
    case Meeting::polyhedronOnMesh:
      return meshFeatures(*A.surface, *B.polyhedron);
    case Meeting::polygons:
      return A.polygon_K.size() + B.polygon_K.size() + followedOf(meets, A, B);
    case Meeting::capsuleOnPolygon:
      return 2 + A.polygon_K.size();
    case Meeting::boxes:
      return kBoxFeatures + followedOf(meets, A, B);
    case Meeting::discs:
      return kDiscPair;
    case Meeting::discOnMesh:
      return discOnMeshFeatures(*A.surface);
    case Meeting::discOnPolyhedron:
      return static_cast<std::uint64_t>(discFeatures(*A.polyhedron));
    default:
      return 1;
  }
}

namespace {

std::string boxFeature(std::uint64_t f) {
  if (f < 8) return "B.corner" + std::to_string(f);
  if (f < 16) return "A.corner" + std::to_string(f - 8);
  return "edges" + std::to_string((f - 16) / 12) + "-" + std::to_string((f - 16) % 12);
}

std::string edgePair(std::uint64_t i, std::size_t edgesOfB) {
  return "edges" + std::to_string(i / edgesOfB) + "-" + std::to_string(i % edgesOfB);
}

std::string ofPolyhedra(const Polyhedron& A, const Polyhedron& B, std::uint64_t f) {
  const std::size_t b = B.corners().size(), a = A.corners().size();
  if (f < b) return "B.corner" + std::to_string(f);
  if (f < a + b) return "A.corner" + std::to_string(f - b);
  return edgePair(f - a - b, B.edges().size());
}

/// Name of a pair of features that is followed on its own.
std::string followedName(std::size_t cornersA, std::size_t facesA, std::size_t cornersB,
                         std::size_t facesB, std::size_t edgesB, std::uint64_t f) {
  const auto over = [](const char* corner, std::uint64_t i, const char* face, std::uint64_t j) {
    return corner + std::to_string(i) + face + std::to_string(j);
  };
  if (f < cornersB * facesA) return over("B.corner", f / facesA, "-A.face", f % facesA);
  f -= cornersB * facesA;
  if (f < cornersA * facesB) return over("A.corner", f / facesB, "-B.face", f % facesB);
  return edgePair(f - cornersA * facesB, edgesB);
}

std::string followedName(Meeting meets, const TouchingShape& A, const TouchingShape& B,
                         std::uint64_t f) {
  if (meets == Meeting::polygons)
    return followedName(A.polygon_K.size(), A.polygon_K.size(), B.polygon_K.size(),
                        B.polygon_K.size(), 1, f);
  return followedName(A.polyhedron->corners().size(), A.polyhedron->faces().size(),
                      B.polyhedron->corners().size(), B.polyhedron->faces().size(),
                      B.polyhedron->edges().size(), f);
}

std::string ofRim(std::uint64_t rim, std::uint64_t k) {
  return "rim" + std::to_string(rim) + "." + std::to_string(k);
}

std::string ofDisc(const Polyhedron& A, std::uint64_t f) {
  const std::size_t corners = A.corners().size(), edges = A.edges().size();
  if (f < 2) return "B.rim" + std::to_string(f);
  if (f < 10) return "B.rim" + std::to_string((f - 2) / 4) + ".point" + std::to_string((f - 2) % 4);
  f -= 10;
  if (f < corners) return "A.corner" + std::to_string(f);
  f -= corners;
  if (f < edges) return "edge" + std::to_string(f) + "-side";
  f -= edges;
  return "edge" + std::to_string(f / 4) + "-" + ofRim(f / 2 % 2, f % 2);
}

std::string ofDiscOnMesh(const Surface& A, std::uint64_t f) {
  const std::size_t faces = A.faces().size(), corners = static_cast<std::size_t>(A.corners()),
                    edges = static_cast<std::size_t>(A.edges());
  const std::string over = "-face" + std::to_string(f % faces);
  if (f < 2 * faces) return "B.rim" + std::to_string(f / faces) + over;
  if (f < 10 * faces) {
    const std::uint64_t point = f / faces - 2;
    return "B.rim" + std::to_string(point / 4) + ".point" + std::to_string(point % 4) + over;
  }
  f -= 10 * faces;
  if (f < corners) return "A.corner" + std::to_string(f);
  f -= corners;
  if (f < edges) return "edge" + std::to_string(f) + "-side";
  f -= edges;
  return "edge" + std::to_string(f / 4) + "-" + ofRim(f / 2 % 2, f % 2);
}

std::string ofDiscs(std::uint64_t f) {
  if (f >= kRimPairs) {
    f -= kRimPairs;
    return "A.rim" + std::to_string(f / 4) + "-B." + ofRim(f / 2 % 2, f % 2);
  }
  if (f >= kBOnSide) return "side-B." + ofRim((f - kBOnSide) / 2, f % 2 == kBOnSide % 2 ? 0 : 1);
  if (f >= kAOnSide) return "side-A." + ofRim((f - kAOnSide) / 2, f % 2 == kAOnSide % 2 ? 0 : 1);
  if (f == kSides) return "sides";
  const std::string of = f < 10 ? "B.rim" : "A.rim";
  f %= 10;
  if (f < 2) return of + std::to_string(f);
  return of + std::to_string((f - 2) / 4) + ".point" + std::to_string((f - 2) % 4);
}

std::string onMesh(const Surface& A, const Polyhedron& B, std::uint64_t f) {
  const std::size_t faces = A.faces().size(), b = B.corners().size() * faces,
                    a = static_cast<std::size_t>(A.corners());
  if (f < b) return "B.corner" + std::to_string(f / faces) + "-face" + std::to_string(f % faces);
  if (f < a + b) return "A.corner" + std::to_string(f - b);
  return edgePair(f - a - b, B.edges().size());
}

std::string ofCapsule(const Surface& A, std::uint64_t f) {
  const auto all = static_cast<std::uint64_t>(A.features()),
             edges = static_cast<std::uint64_t>(A.edges());
  if (f < 2 * all)
    return "B.end" + std::to_string(f / all) + "-" + A.featureName(static_cast<int>(f % all));
  f -= 2 * all;
  return f < edges ? "edge" + std::to_string(f) : "A.corner" + std::to_string(f - edges);
}

}  // namespace

std::string featureName(Meeting meets, const TouchingShape& A, const TouchingShape& B,
                        std::uint64_t f) {
  if (const std::uint64_t followed = followedOf(meets, A, B); followed > 0)
    if (const std::uint64_t first = featuresOf(meets, A, B) - followed; f >= first)
      return followedName(meets, A, B, f - first);
  if (meets == Meeting::boxes) return boxFeature(f);
  if (meets == Meeting::polygons) {
    const std::size_t b = B.polygon_K.size();
    return f < b ? "B.corner" + std::to_string(f) : "A.corner" + std::to_string(f - b);
  }
  if (meets == Meeting::polyhedra) return ofPolyhedra(*A.polyhedron, *B.polyhedron, f);
  if (meets == Meeting::polyhedronOnMesh) return onMesh(*A.surface, *B.polyhedron, f);
  if (meets == Meeting::discs) return ofDiscs(f);
  if (meets == Meeting::discOnMesh) return ofDiscOnMesh(*A.surface, f);
  if (meets == Meeting::discOnPolyhedron) return ofDisc(*A.polyhedron, f);
  if (meets == Meeting::capsuleOnSurface) return ofCapsule(*A.surface, f);
  if (meets == Meeting::capsuleOnPolygon)
    return f < 2 ? "B.end" + std::to_string(f) : "A.corner" + std::to_string(f - 2);
  if (meets == Meeting::ballOnSurface || meets == Meeting::smoothOnMesh) {
    const int number = static_cast<int>(f);
    return number < A.surface->features() ? A.surface->featureName(number) : "nearest";
  }
  if (meets == Meeting::capsules)
    return f == 0 ? "crossing" : (f < 3 ? "B.end" : "A.end") + std::to_string((f - 1) % 2);
  if (meets == Meeting::capsuleOnBox) {
    if (f < 2) return "B.end" + std::to_string(f);
    return f < 14 ? "edge" + std::to_string(f - 2) : "A.corner" + std::to_string(f - 14);
  }
  if (meets == Meeting::overHalfSpace && B.features.size() > 1) return B.features[f].name;
  return {};
}

}  // namespace dynamy
