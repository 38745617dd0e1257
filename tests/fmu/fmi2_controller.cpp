// A controller as an FMU 2.0, written from the text of the standard, without any header of dynamY:
//
//   doStep:  I += ki e h, count += 1
//   u = on ? kp e + I : 0,   running = on
//
// It can neither read nor write its state. With e above 1000 a step fails, and is logged.
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

enum Variable : unsigned { kE, kKp, kKi, kU, kOn, kCount, kRunning };
using Log = void (*)(void*, const char*, int, const char*, const char*, ...);

struct Callbacks {
  Log log;
  void* (*allocate)(std::size_t, std::size_t);
  void (*release)(void*);
  void (*finished)(void*, int);
  void* environment;
};

struct Controller {
  const Callbacks* callbacks;
  double e = 0.0, kp = 1.0, ki = 0.0, I = 0.0;
  int on = 1, count = 0;
};

Controller& of(void* c) { return *static_cast<Controller*>(c); }
constexpr int kOk = 0, kError = 3;

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

void* fmi2Instantiate(const char*, int type, const char* token, const char*, const Callbacks* calls,
                      int, int) {
  const bool good = type == 1 && token[0] == '{';
  return good ? new (std::nothrow) Controller{calls} : nullptr;
}
void fmi2FreeInstance(void* c) { delete &of(c); }
int fmi2SetupExperiment(void*, int, double, double, int, double) { return kOk; }
int fmi2EnterInitializationMode(void*) { return kOk; }
int fmi2ExitInitializationMode(void*) { return kOk; }

int fmi2SetReal(void* c, const unsigned* r, std::size_t n, const double* x) {
  for (std::size_t i = 0; i < n; ++i) {
    if (r[i] == kE) of(c).e = x[i];
    if (r[i] == kKp) of(c).kp = x[i];
    if (r[i] == kKi) of(c).ki = x[i];
  }
  return kOk;
}
int fmi2GetReal(void* c, const unsigned*, std::size_t n, double* x) {
  for (std::size_t i = 0; i < n; ++i) x[i] = of(c).on != 0 ? of(c).kp * of(c).e + of(c).I : 0.0;
  return kOk;
}
int fmi2SetBoolean(void* c, const unsigned*, std::size_t, const int* x) {
  of(c).on = *x;
  return kOk;
}
int fmi2GetBoolean(void* c, const unsigned*, std::size_t, int* x) {
  *x = of(c).on;
  return kOk;
}
int fmi2GetInteger(void* c, const unsigned*, std::size_t, int* x) {
  *x = of(c).count;
  return kOk;
}
int fmi2DoStep(void* c, double, double h, int) {
  Controller& x = of(c);
  if (x.e > 1000.0) {
    x.callbacks->log(x.callbacks->environment, "", kError, "logStatusError", "e is %g", x.e);
    return kError;
  }
  x.I += x.ki * x.e * h, ++x.count;
  return kOk;
}

}  // extern "C"
#pragma GCC visibility pop
