/// RecordSink: where the numbers of a run go (files of the run folder, a table in memory).
#pragma once
#include <array>
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/core/archive.hpp>
#include <dynamy/core/types.hpp>
#include <span>
#include <string_view>

namespace dynamy {

struct FramePose {
  Vec3 r_OS_I = Vec3::Zero();  ///< [m]
  Mat3 A_IK = Mat3::Identity();
  bool absent = false;  ///< the body takes no part at present: it is not drawn
};

/// The instant of a picture.
struct FilmInstant {
  double t = 0.0;     ///< [s]
  double step = 0.0;  ///< Δt of the step whose Λ/Δt are the forces [s]; 0: there is none yet
};

/// A closed contact in a picture.
struct ContactRecord {
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();  ///< [m], [–]
  Vec3 force = Vec3::Zero();  ///< Λ/Δt on the body the normal points to [N]
  double limit = 0.0;         ///< largest friction the law allows at this normal force [N]
  Status status = Status::open;
  bool impact = false;  ///< approached faster than smooth forces alone can cause in a step
  bool spin = false;    ///< slips by drilling or rolling while its point hardly slides
};

/// An impact, a contact that changed its status, or what happened to a system.
struct ContactEvent {
  enum class Of : std::uint8_t {
    contact,
    jump,   ///< the system jumped (Renewable)
    sleep,  ///< the system rests from now on
    wake    ///< the system moves again
  };
  double t = 0.0;  ///< end of the step [s]
  ContactKey key;
  Status from = Status::open, to = Status::open;
  bool impact = false;
  double speed = 0.0;    ///< of an impact: −γ_N^A [m/s]
  double impulse = 0.0;  ///< Λ_N of the step [N s]
  Of of = Of::contact;
  int system = -1;  ///< of an event of a system, which has no contact
};

/// The energy ledger up to t, and the worst figures of the solver since the row before.
struct LedgerRow {
  static constexpr std::size_t kNumbers = 12;
  static constexpr std::array<const char*, kNumbers> kNames{
      "kinetic",    "potential",      "nonPotential", "friction",   "normal",   "joints",
      "boundaries", "discretisation", "residual",     "iterations", "contacts", "penetration"};
  static constexpr std::array<const char*, kNumbers> kUnits{"J", "J", "J", "J", "J", "J",
                                                            "J", "J", "",  "",  "",  "m"};
  double t = 0.0;                        ///< [s]
  std::array<double, kNumbers> value{};  ///< energies and works [J], residual, counts, [m]
};

/// Receives the recorded numbers. The spans are valid during the call only.
class RecordSink {
 public:
  virtual ~RecordSink() = default;
  virtual void row(double t, std::span<const double> values) = 0;
  virtual void frame(FilmInstant at, std::span<const FramePose> poses,
                     std::span<const ContactRecord> contacts) = 0;
  virtual void event(const ContactEvent&) {}
  virtual void ledger(const LedgerRow&) {}
  /// False: the sink does not use the ledger's rows, so none are computed.
  virtual bool wantsLedger() const { return false; }
  /// Why the sink can store no more, e.g. a full disk; empty: it can. A run then ends as if it were
  /// stopped.
  virtual std::string_view fault() const { return {}; }
  /// Writing: stores the numbers received so far safely and archives the position in the files.
  /// Reading: goes back to that position.
  virtual void archive(Archive&) {}
};

}  // namespace dynamy
