#include <algorithm>
#include <cmath>
#include <dynamy/solver/local/packed_kernels.hpp>

namespace dynamy {
namespace {

// Functions of registers are always inlined: how registers would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

template <int n>
struct RegisterOf;
template <>
struct RegisterOf<2> {
  using Type = double __attribute__((vector_size(16)));
};
template <>
struct RegisterOf<4> {
  using Type = double __attribute__((vector_size(32)));
};
template <>
struct RegisterOf<8> {
  using Type = double __attribute__((vector_size(64)));
};

/// No lane has a normal impulse now or had one before the last sweep (then T = S = 0, too).
[[gnu::always_inline]] inline bool carriesNothing(const PackedBatch& c) {
  double sum = 0.0;  // of numbers that are never negative
  for (int k = 0; k < kLanes; ++k) sum += c.Lambda[0][k] + c.last[0][k];
  return sum == 0.0;
}

/// `n` lanes in one register, and the loops over them. A batch of eight takes 8/n passes; each lane
/// has the same operations in the same order for every n.
template <int n>
struct Kernel {
  using Register = typename RegisterOf<n>::Type;
  struct Sides {
    Register a[kLanes], b[kLanes];  ///< number k of the velocities of each body
  };

  [[gnu::always_inline]] static Register load(const double* x) {
    return *reinterpret_cast<const Register*>(x);
  }
  [[gnu::always_inline]] static void store(double* x, Register value) {
    *reinterpret_cast<Register*>(x) = value;
  }
  [[gnu::always_inline]] static Register root(Register x) {
    Register out;
    for (int k = 0; k < n; ++k) out[k] = std::sqrt(x[k]);
    return out;
  }
  [[gnu::always_inline]] static Register larger(Register x, Register y) { return x > y ? x : y; }

  /// Transposes n rows of n numbers: pairs, then pairs of pairs, then halves.
  [[gnu::always_inline]] static void transpose(Register* x) {
    if constexpr (n == 2) {
      const Register a = __builtin_shufflevector(x[0], x[1], 0, 2);
      x[1] = __builtin_shufflevector(x[0], x[1], 1, 3), x[0] = a;
    } else if constexpr (n == 4) {
      Register y[4];
      for (int k = 0; k < 4; k += 2) {
        y[k] = __builtin_shufflevector(x[k], x[k + 1], 0, 4, 2, 6);
        y[k + 1] = __builtin_shufflevector(x[k], x[k + 1], 1, 5, 3, 7);
      }
      for (int k = 0; k < 2; ++k) {
        x[k] = __builtin_shufflevector(y[k], y[k + 2], 0, 1, 4, 5);
        x[k + 2] = __builtin_shufflevector(y[k], y[k + 2], 2, 3, 6, 7);
      }
    } else {
      Register y[8], z[8];
      for (int k = 0; k < 8; k += 2) {
        y[k] = __builtin_shufflevector(x[k], x[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        y[k + 1] = __builtin_shufflevector(x[k], x[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
      }
      for (int k = 0; k < 8; k += 4)
        for (int j = k; j < k + 2; ++j) {
          z[j] = __builtin_shufflevector(y[j], y[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
          z[j + 2] = __builtin_shufflevector(y[j], y[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
      for (int j = 0; j < 4; ++j) {
        x[j] = __builtin_shufflevector(z[j], z[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        x[j + 4] = __builtin_shufflevector(z[j], z[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
      }
    }
  }

  [[gnu::always_inline]] static void gather(const PackedVelocity* v, const std::int32_t* body,
                                            Register* x) {
    for (int q = 0; q < kNumbers; q += n) {
      for (int k = 0; k < n; ++k) x[q + k] = load(v[body[k]].v + q);
      transpose(x + q);
    }
  }
  [[gnu::always_inline]] static void scatter(Register* x, const std::int32_t* body,
                                             PackedVelocity* v) {
    for (int q = 0; q < kNumbers; q += n) {
      transpose(x + q);
      for (int k = 0; k < n; ++k) store(v[body[k]].v + q, x[q + k]);
    }
  }

  /// A row of ξ: c plus row · v of both sides.
  [[gnu::always_inline]] static Register product(const PackedBatch& c, int row, int lane,
                                                 const Sides& v) {
    Register sum = load(c.c[row] + lane);
    for (int k = 0; k < kNumbers; ++k) sum += load(c.a[kNumbers * row + k] + lane) * v.a[k];
    for (int k = 0; k < kNumbers; ++k) sum += load(c.b[kNumbers * row + k] + lane) * v.b[k];
    return sum;
  }
  /// v += Aᵀ (N, T, S) of both sides.
  [[gnu::always_inline]] static void push(const PackedBatch& c, int lane, Register N, Register T,
                                          Register S, Sides& v) {
    for (int k = 0; k < kNumbers; ++k) {
      v.a[k] +=
          load(c.a[k] + lane) * N + load(c.a[6 + k] + lane) * T + load(c.a[12 + k] + lane) * S;
      v.b[k] +=
          load(c.b[k] + lane) * N + load(c.b[6 + k] + lane) * T + load(c.b[12 + k] + lane) * S;
    }
  }

  /// Lanes `lane` … `lane` + n − 1; returns −Σ w (Λ⁺ − Λ̃)·(Λ⁺ − Λ) of each.
  [[gnu::always_inline]] static Register solve(PackedBatch& c, int lane, PackedVelocity* v,
                                               double beta) {
    Sides x;
    gather(v, c.bodyA + lane, x.a);
    gather(v, c.bodyB + lane, x.b);
    Register old[3], from[3];
    for (int k = 0; k < 3; ++k) {
      old[k] = load(c.Lambda[k] + lane);
      from[k] = old[k] + beta * (old[k] - load(c.last[k] + lane));
    }
    const Register zero = {}, rN = load(c.rN + lane), rT = load(c.rT + lane);
    const Register N = larger(from[0] - rN * product(c, 0, lane, x), zero), dN = N - from[0];
    Register T = from[1] - rT * (product(c, 1, lane, x) + load(c.dT + lane) * dN);
    Register S = from[2] - rT * (product(c, 2, lane, x) + load(c.dS + lane) * dN);
    const Register limit = load(c.mu + lane) * N, square = T * T + S * S;
    const auto slips = square > limit * limit;
    const Register part = limit / root(square);
    T = slips ? T * part : T, S = slips ? S * part : S;
    const Register dT = T - from[1], dS = S - from[2];
    push(c, lane, dN, dT, dS, x);
    scatter(x.a, c.bodyA + lane, v);
    scatter(x.b, c.bodyB + lane, v);
    for (int k = 0; k < 3; ++k) store(c.last[k] + lane, old[k]);
    store(c.Lambda[0] + lane, N), store(c.Lambda[1] + lane, T), store(c.Lambda[2] + lane, S);
    // w = 1/r; unused lanes have none.
    const Register wN = rN > zero ? 1.0 / rN : zero, wT = rT > zero ? 1.0 / rT : zero;
    return -(wN * dN * (N - old[0]) + wT * (dT * (T - old[1]) + dS * (S - old[2])));
  }

  [[gnu::always_inline]] static double sweep(PackedBatch* batch, int batches, PackedVelocity* v,
                                             double beta, bool all) {
    Register uphill[kLanes / n] = {};
    for (int i = 0; i < batches; ++i) {
      if (!all && carriesNothing(batch[i])) continue;
      for (int k = 0; k < kLanes / n; ++k) uphill[k] += solve(batch[i], n * k, v, beta);
    }
    double sum = 0.0;
    for (int k = 0; k < kLanes; ++k) sum += uphill[k / n][k % n];
    return sum;
  }

  [[gnu::always_inline]] static void impulses(const PackedBatch* batch, int batches,
                                              PackedVelocity* v) {
    for (int i = 0; i < batches; ++i)
      for (int lane = 0; lane < kLanes; lane += n) {
        const PackedBatch& c = batch[i];
        Sides x;
        gather(v, c.bodyA + lane, x.a);
        gather(v, c.bodyB + lane, x.b);
        push(c, lane, load(c.Lambda[0] + lane), load(c.Lambda[1] + lane), load(c.Lambda[2] + lane),
             x);
        scatter(x.a, c.bodyA + lane, v);
        scatter(x.b, c.bodyB + lane, v);
      }
  }

  struct Most {
    Register velocity2 = {}, force2 = {}, Lambda2 = {};
  };

  [[gnu::always_inline]] static void naturalMap(const PackedBatch& c, int lane,
                                                const PackedVelocity* v, Most& most) {
    Sides x;
    gather(v, c.bodyA + lane, x.a);
    gather(v, c.bodyB + lane, x.b);
    const Register N = load(c.Lambda[0] + lane), T = load(c.Lambda[1] + lane),
                   S = load(c.Lambda[2] + lane);
    const Register xN = product(c, 0, lane, x), xT = product(c, 1, lane, x),
                   xS = product(c, 2, lane, x);
    const Register zero = {}, mu = load(c.mu + lane), rho = load(c.rho + lane);
    // z = Λ − ρ ξ^, projected on the cone |T| ≤ μN.
    const Register zN = N - rho * (xN + mu * root(xT * xT + xS * xS));
    const Register zT = T - rho * xT, zS = S - rho * xS, length = root(zT * zT + zS * zS);
    const auto inside = length <= mu * zN, polar = mu * length <= -zN;
    const Register edge = (zN + mu * length) / (1.0 + mu * mu);
    const Register part = length > zero ? mu * edge / length : zero;
    Register pN = polar ? zero : edge, pT = polar ? zero : zT * part, pS = polar ? zero : zS * part;
    pN = inside ? zN : pN, pT = inside ? zT : pT, pS = inside ? zS : pS;
    const Register eN = N - pN, eT = T - pT, eS = S - pS, e2 = eN * eN + eT * eT + eS * eS;
    most.velocity2 = larger(rho > zero ? e2 / (rho * rho) : zero, most.velocity2);
    most.force2 = larger(e2, most.force2);
    most.Lambda2 = larger(N * N + T * T + S * S, most.Lambda2);
  }

  [[gnu::always_inline]] static void measure(const PackedBatch* batch, int batches,
                                             const PackedVelocity* v, PackedMeasure& out) {
    Most most;
    for (int i = 0; i < batches; ++i)
      for (int lane = 0; lane < kLanes; lane += n) naturalMap(batch[i], lane, v, most);
    for (int k = 0; k < n; ++k) {
      out.velocity2 = std::max(out.velocity2, most.velocity2[k]);
      out.force2 = std::max(out.force2, most.force2[k]);
      out.Lambda2 = std::max(out.Lambda2, most.Lambda2[k]);
    }
  }

  static constexpr int kNumbers = 6;  ///< velocities of a body; gather() reads up to eight
};

double sweepPlain(PackedBatch* batch, int batches, PackedVelocity* v, double beta, bool all) {
  return Kernel<2>::sweep(batch, batches, v, beta, all);
}
void impulsesPlain(const PackedBatch* batch, int batches, PackedVelocity* v) {
  Kernel<2>::impulses(batch, batches, v);
}
void measurePlain(const PackedBatch* batch, int batches, const PackedVelocity* v,
                  PackedMeasure& out) {
  Kernel<2>::measure(batch, batches, v, out);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] double sweepAvx2(PackedBatch* batch, int batches, PackedVelocity* v,
                                         double beta, bool all) {
  return Kernel<4>::sweep(batch, batches, v, beta, all);
}
[[gnu::target("avx2")]] void impulsesAvx2(const PackedBatch* batch, int batches,
                                          PackedVelocity* v) {
  Kernel<4>::impulses(batch, batches, v);
}
[[gnu::target("avx2")]] void measureAvx2(const PackedBatch* batch, int batches,
                                         const PackedVelocity* v, PackedMeasure& out) {
  Kernel<4>::measure(batch, batches, v, out);
}
[[gnu::target("avx512f,avx512dq")]] double sweepAvx512(PackedBatch* batch, int batches,
                                                       PackedVelocity* v, double beta, bool all) {
  return Kernel<8>::sweep(batch, batches, v, beta, all);
}
[[gnu::target("avx512f,avx512dq")]] void impulsesAvx512(const PackedBatch* batch, int batches,
                                                        PackedVelocity* v) {
  Kernel<8>::impulses(batch, batches, v);
}
[[gnu::target("avx512f,avx512dq")]] void measureAvx512(const PackedBatch* batch, int batches,
                                                       const PackedVelocity* v,
                                                       PackedMeasure& out) {
  Kernel<8>::measure(batch, batches, v, out);
}
constexpr PackedKernels kKernels[] = {{sweepPlain, impulsesPlain, measurePlain},
                                      {sweepAvx2, impulsesAvx2, measureAvx2},
                                      {sweepAvx512, impulsesAvx512, measureAvx512}};
std::size_t levels() {
  if (!__builtin_cpu_supports("avx2")) return 1;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? 3 : 2;
}
#else
constexpr PackedKernels kKernels[] = {{sweepPlain, impulsesPlain, measurePlain}};
std::size_t levels() { return 1; }
#endif

}  // namespace

std::span<const PackedKernels> packedLevels() { return {kKernels, levels()}; }

}  // namespace dynamy
