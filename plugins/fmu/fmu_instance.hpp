/// FmuInstance: an instance of an FMU that is stepped, declared from the texts of FMI 2.0 and 3.0.
///
///   start(t) → exchange(inputs) → advance(t, h) → exchange(inputs) → …
///
/// Every function throws std::runtime_error with the name of the call and what the FMU logged.
#pragma once
#include <memory>
#include <span>
#include <utility>

#include "fmu_library.hpp"

namespace dynamy {

class FmuInstance {
 public:
  using Values = std::vector<std::pair<const FmuVariable*, double>>;
  using Bytes = std::vector<std::uint8_t>;

  static std::unique_ptr<FmuInstance> make(const std::shared_ptr<const FmuFile>& file,
                                           const std::string& name);
  FmuInstance(const FmuInstance&) = delete;
  FmuInstance& operator=(const FmuInstance&) = delete;
  virtual ~FmuInstance() = default;

  /// Initializes it at t with these parameters and inputs; once.
  void start(double t, const Values& parameters, const Values& inputs);
  /// Steps from t to t + h; the inputs stay.
  virtual void advance(double t, double h) = 0;
  /// Sets the inputs at the present instant; `ticks`: the clocks tick. Discrete states are updated.
  virtual void exchange(const Values& inputs, bool ticks) = 0;
  double get(const FmuVariable& v) const;
  void set(const Values& values);
  Bytes state() const;
  void setBack(std::span<const std::uint8_t> bytes) const;

 protected:
  explicit FmuInstance(std::shared_ptr<const FmuFile> file) : library(std::move(file)) {}
  void release() const;
  virtual void begin(double t) = 0;
  virtual void initialized() = 0;
  virtual const char* functionFor(FmuType type) const = 0;  ///< "Real", "Float64", …
  FmuLibrary library;
  void* component = nullptr;

 private:
  /// Reads the variable (`write` is null) or writes it, as the type T of the interface.
  template <class T>
  double exchangeAs(const FmuVariable& v, const double* write) const;
  double exchangeOne(const FmuVariable& v, const double* write) const;
};

}  // namespace dynamy
