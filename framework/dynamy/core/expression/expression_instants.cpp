// ExpressionSet: where formulas of time have jumps and kinks.
#include <cmath>
#include <dynamy/core/expression/expression.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Relative distance: an instant that is so close after the present one has just been passed.
constexpr double kInstantPassed = 1e-13;

/// Value a t + b of an operation, valid on its branches right after an instant and up to the next
/// one; `known` is false for other values.
struct Line {
  bool known = false;
  double a = 0.0, b = 0.0;
};

Line constant(double value) { return {true, 0.0, value}; }

/// Computes the line of a result from the lines of its operands, and notes where branches end.
class Branches {
 public:
  explicit Branches(double after) : behind_(after + kInstantPassed * std::abs(after)) {}
  double next() const { return next_; }

  Line apply(Op op, const Line& a, const Line& b, const Line& c) {
    switch (op) {
      case Op::negate:
        return {a.known, -a.a, -a.b};
      case Op::add:
        return {a.known && b.known, a.a + b.a, a.b + b.b};
      case Op::subtract:
        return difference(a, b);
      case Op::multiply:
        return product(a, b);
      case Op::divide:
        return {a.known && b.known && b.a == 0.0 && b.b != 0.0, a.a / b.b, a.b / b.b};
      case Op::abs:
        return side(a) < 0.0 ? Line{a.known, -a.a, -a.b} : a;
      case Op::sign:
        return {a.known, 0.0, side(a)};
      case Op::floor:
        return floorOf(a);
      case Op::ceil: {
        const Line low = floorOf(a);
        return {a.known, 0.0, a.a == 0.0 ? std::ceil(a.b) : low.b + 1.0};
      }
      case Op::mod: {
        if (!b.known || b.a != 0.0 || b.b == 0.0) return {};
        const Line turns = floorOf({a.known, a.a / b.b, a.b / b.b});
        return {a.known, a.a, a.b - b.b * turns.b};
      }
      case Op::select:
        return !a.known ? Line{} : a.b != 0.0 ? b : c;
      default:
        return compare(op, a, b);
    }
  }

 private:
  static Line difference(const Line& a, const Line& b) {
    return {a.known && b.known, a.a - b.a, a.b - b.b};
  }

  static Line product(const Line& a, const Line& b) {
    if (!a.known || !b.known || (a.a != 0.0 && b.a != 0.0)) return {};
    return {true, a.a * b.b + a.b * b.a, a.b * b.b};
  }

  Line compare(Op op, const Line& a, const Line& b) {
    const bool known = a.known && b.known;
    switch (op) {
      case Op::logicalNot:
        return {a.known, 0.0, a.b == 0.0 ? 1.0 : 0.0};
      case Op::logicalAnd:
        return {known, 0.0, a.b != 0.0 && b.b != 0.0 ? 1.0 : 0.0};
      case Op::logicalOr:
        return {known, 0.0, a.b != 0.0 || b.b != 0.0 ? 1.0 : 0.0};
      default:
        break;
    }
    if (!known) return {};
    const auto s = [&] { return side(difference(a, b)); };
    switch (op) {
      case Op::min:
        return s() < 0.0 ? a : b;
      case Op::max:
        return s() < 0.0 ? b : a;
      case Op::less:
        return constant(s() < 0.0 ? 1.0 : 0.0);
      case Op::lessEqual:
        return constant(s() <= 0.0 ? 1.0 : 0.0);
      case Op::equal:
        return constant(s() == 0.0 ? 1.0 : 0.0);
      case Op::notEqual:
        return constant(s() != 0.0 ? 1.0 : 0.0);
      default:
        return {};  // sin …
    }
  }

  void note(double root) {
    if (root > behind_ && root < next_) next_ = root;
  }

  /// Sign of the line right after the instant; notes where it changes.
  double side(const Line& x) {
    if (!x.known) return 0.0;
    if (x.a != 0.0) note(-x.b / x.a);
    const double value = x.a * behind_ + x.b, of = value == 0.0 ? x.a : value;
    return of > 0.0 ? 1.0 : of < 0.0 ? -1.0 : 0.0;
  }

  Line floorOf(const Line& x) {
    const double value = x.a * behind_ + x.b;
    const double low = x.a < 0.0 ? std::ceil(value) - 1.0 : std::floor(value);
    if (x.known && x.a != 0.0) note(((x.a > 0.0 ? low + 1.0 : low) - x.b) / x.a);
    return {x.known, 0.0, low};
  }

  double behind_, next_ = std::numeric_limits<double>::infinity();
};

}  // namespace

double ExpressionSet::nextInstant(double after, int variable) const {
  std::vector<Line> lines;
  for (int i = 0; i < inputCount_; ++i) lines.push_back({i == variable, 1.0, 0.0});
  for (const double value : constants_) lines.push_back(constant(value));
  Branches branches(after);
  for (const Instruction& k : tape_)
    lines.push_back(branches.apply(k.op, lines[k.a], lines[k.b], lines[k.c]));
  return branches.next();
}

}  // namespace dynamy
