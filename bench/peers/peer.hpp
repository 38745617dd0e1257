/// What the programs of the peers share: the lines they print, and the clock.
///
///   peer_NAME                          engine NAME VERSION; note TEXT; point SCENE METHOD SETTING
///   peer_NAME SCENE METHOD SETTING     values V …; cpu S; evaluations N; note TEXT
///
/// The values are those of the checks of bench/work_precision/scenes, in their order. The clock
/// runs from the first step to the last; a short scene is run again until 0.05 s have passed.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace peer {

inline double processTime() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// What a scene measured. Its function calls start() when the world stands and stop() at the end.
class Answer {
 public:
  void start() { begin_ = processTime(); }
  void stop() { cpu = processTime() - begin_; }
  void add(double value) { values.push_back(value); }
  std::vector<double> values;
  long evaluations = 0;
  double cpu = 0.0;  ///< [s]
  std::string note;

 private:
  double begin_ = 0.0;
};

/// A scene by one method; `setting` is a step [s] or an accuracy.
struct Line {
  std::string scene, method;
  std::vector<std::string> settings;  ///< those with * are quick
  std::function<void(double setting, Answer& answer)> run;
};

/// Calls `step` from t = 0 to `until`, and `sample(k)` when times[k] is reached; steps of the last
/// place are shortened by nobody: the times are multiples of h.
template <class Step, class Sample>
void march(double h, double until, const std::vector<double>& times, Answer& answer, Step&& step,
           Sample&& sample) {
  const long n = std::lround(until / h);
  std::size_t next = 0;
  for (long i = 1; i <= n; ++i) {
    step();
    ++answer.evaluations;
    while (next < times.size() && i >= std::lround(times[next] / h)) sample(next), ++next;
  }
}

/// Angle of the direction (x, z) from straight down, in (−π/2 − π, π/2 + π/5].
inline double angleFromDown(double x, double z) {
  const double pi = std::acos(-1.0);
  double phi = std::atan2(z, x);
  if (phi > 0.7) phi -= 2.0 * pi;
  return phi + 0.5 * pi;
}

/// Horizontal place of a block that has gone `way` along the slope of 20 degrees; its centre stands
/// 0.05 m above the slope.
inline double placeOnSlope(double way) {
  const double angle = 20.0 * std::acos(-1.0) / 180.0;
  return way * std::cos(angle) - 0.05 * std::sin(angle);
}

inline int answer(const Line& line, double setting) {
  std::vector<double> times;
  Answer first;
  for (double all = 0.0; times.empty() || (all < 0.05 && times.size() < 20);) {
    Answer a;
    line.run(setting, a);
    times.push_back(a.cpu);
    all += a.cpu;
    if (times.size() == 1) first = a;
  }
  std::sort(times.begin(), times.end());
  std::printf("\nvalues");
  for (const double v : first.values) std::printf(" %.17g", v);
  std::printf("\ncpu %.9g\nevaluations %ld\n",
              0.5 * (times[(times.size() - 1) / 2] + times[times.size() / 2]), first.evaluations);
  if (!first.note.empty()) std::printf("note %s\n", first.note.c_str());
  return 0;
}

inline int serve(int argc, char** argv, const std::string& engine,
                 const std::vector<std::string>& notes, const std::vector<Line>& lines) {
  if (argc < 4) {
    std::printf("\nengine %s\n", engine.c_str());
    for (const std::string& n : notes) std::printf("note %s\n", n.c_str());
    for (const Line& l : lines)
      for (const std::string& s : l.settings)
        std::printf("point %s\t%s\t%s\n", l.scene.c_str(), l.method.c_str(), s.c_str());
    return 0;
  }
  for (const Line& l : lines)
    if (l.scene == argv[1] && l.method == argv[2]) return answer(l, std::stod(argv[3]));
  std::printf("\nnote no such scene or method\n");
  return 1;
}

inline const std::vector<std::string> kBallSteps = {"1e-2*", "5e-3", "2e-3*", "1e-3",
                                                    "2e-4",  "1e-4", "2e-5"};
inline const std::vector<std::string> kSmoothSteps = {"2e-2*", "1e-2*", "5e-3", "2e-3",
                                                      "1e-3",  "5e-4",  "2e-4", "1e-4"};
inline const std::vector<std::string> kRestSteps = {"1e-2*", "5e-3", "2e-3", "1e-3*"};

}  // namespace peer
