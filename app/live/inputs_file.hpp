/// inputs.csv: what a person did in a live run, and between which steps.
///
///     step,t,what,name,values
///     120,0.12,set,mu,0.5
///     240,0.24,grab,ball,1 0 0 0.05 0.3 0 1.2 98.1 12
///
/// `step`: number of steps that the run had taken, `t`: its time then [s], for a check. Numbers have
/// the shortest text that reads back to the same double, so that a repeated run takes the same
/// numbers before the same steps. Rejected: instants alone, because steps of another length end
/// elsewhere and the repeated run would go on unnoticed.
#pragma once
#include <dynamy/io/files/output_file.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

struct Action {
  enum class What {
    set,      ///< a parameter of the model has another value
    input,    ///< an <Input> of the model has another value
    grab,     ///< the hand holds a point; values: frame, point, target, stiffness, damping
    move,     ///< the hand pulls elsewhere; values: target
    release,  ///< the hand lets go
    end       ///< the run ends here
  };
  long step = 0;
  double t = 0.0;  ///< [s]
  What what = What::end;
  std::string name;  ///< of the parameter, the input or the frame
  std::vector<double> values;
};

inline constexpr const char* kInputsName = "inputs.csv";  ///< in the run folder

/// "set", "input", "grab", …
const char* nameOf(Action::What what);

class InputsFile {
 public:
  /// Creates or replaces the file. Throws WriteError.
  explicit InputsFile(const std::filesystem::path& path);
  void add(const Action& action);
  long actions() const { return actions_; }

 private:
  OutputFile file_;
  long actions_ = 0;
};

/// The actions of a file, in their order. Throws FileError, with the line, if it is no such file.
std::vector<Action> readInputs(const std::filesystem::path& path);

}  // namespace dynamy::app
