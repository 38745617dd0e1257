/// Mutated models: whatever stands in values, names and tags, loading gives a model or a ModelError
/// whose every message has a line of the file. The seed is printed; DYNAMY_SEED repeats a run.

#include <gtest/gtest.h>

#include <fuzz/chosen_seed.hpp>
#include <random>
#include <unit/io/model/load_text.hpp>

namespace dynamy {
namespace {

const std::string kModel = R"(<dynamy version="1">
  <doc>Text.</doc>
  <parameter name="n" value="2" min="0" max="{m}"/><parameter name="m" value="3"/>
  <defaults><Ball mass="1kg"/><Ball class="high" z="{n}"/></defaults>
  <systems>
    <Ball name="a" class="high" velocity="0 {n} 1mm/s" drive="t*{m}"><Disc radius="0.1"/></Ball>
    <replicate count="3" index="i"><Ball name="b" z="{i + n}"/></replicate>
  </systems>
  <forces><Weight acceleration="0 0 -9.81"/></forces>
  <elements>
    <Stop name="s" on="a" frames="b[0] b[{n}].tip"><Law mu="0.3"/></Stop>
    <replicate count="2"><Stop on="b"><Law/></Stop></replicate>
  </elements>
  <simulation until="5" step="1e-3" gTol="1um" onNonConvergence="stop"/>
  <record signals="a.z b[1].*" every="10ms" frames="60Hz" view="xz"/>
  <check signal="a.z" at="4" value="1" tolerance="1"/>
  <check signal="a.z" measure="max" over="1 5" between="0 {n}"/>
</dynamy>
)";

class ModelMutator {
 public:
  explicit ModelMutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text) {
    for (std::size_t i = below(3) + 1; i > 0; --i) mutateOnce(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }

  void mutateOnce(std::string& text) {
    static const std::string values[] = {"",
                                         " ",
                                         "0",
                                         "-1",
                                         "1e400",
                                         "nan",
                                         "inf",
                                         "30deg",
                                         "5 5",
                                         "1 2 3 4",
                                         "{",
                                         "}",
                                         "{}",
                                         "{n",
                                         "{n}}",
                                         "{{n}}",
                                         "{i}",
                                         "{1/0}",
                                         "{n+}",
                                         "{q}",
                                         "a",
                                         "b",
                                         "b[1]",
                                         "a.b",
                                         "a/b",
                                         "*",
                                         ".",
                                         "stop",
                                         "true",
                                         "??",
                                         "999999999999",
                                         "0.5",
                                         "{0/0}",
                                         "t*??",
                                         "{n}{m}",
                                         "µ",
                                         "high",
                                         "{-n} {n} {m}",
                                         "[",
                                         "1e5"};
    static const std::string words[] = {"Ball",    "Disc",     "Law",    "Stop",       "Weight",
                                        "systems", "forces",   "record", "simulation", "replicate",
                                        "include", "defaults", "doc",    "nothing",    "dynamy"};
    static const std::string names[] = {"name", "class", "mass", "z",     "count", "value",
                                        "min",  "on",    "mu",   "index", "file",  "signals"};
    switch (below(3)) {
      case 0:
        replace(text, '"', '"', values[below(std::size(values))]);
        break;
      case 1:  // a tag; its end tag does not follow, so take elements without children
        replace(text, '<', ' ', words[below(std::size(words))]);
        break;
      default:
        replace(text, ' ', '=', names[below(std::size(names))]);
    }
  }

  /// Replaces the text between a random `open` and the next `close`.
  void replace(std::string& text, char open, char close, const std::string& by) {
    std::size_t at = text.find(open, below(text.size()));
    if (at == std::string::npos) return;
    const std::size_t end = text.find(close, at + 1);
    if (end == std::string::npos || end - at > 40) return;
    text.replace(at + 1, end - at - 1, by);
  }

  std::mt19937 random_;
};

TEST(ModelFuzz, GivesAModelOrErrorsWithLines) {
  const unsigned seed = fuzz::chosenSeed();
  SCOPED_TRACE("DYNAMY_SEED=" + std::to_string(seed));
  ASSERT_EQ(dummy::errors(kModel), "");
  ModelMutator mutator(seed);
  for (int i = 0; i < 5000; ++i) {
    const std::string text = mutator.mutate(kModel);
    try {
      dummy::load(text);
    } catch (const ModelError& e) {
      ASSERT_FALSE(e.diagnostics().empty()) << text;
      for (const Diagnostic& d : e.diagnostics()) {
        EXPECT_GT(d.place.line, 0) << e.what() << '\n' << text;
        EXPECT_FALSE(d.text.empty()) << text;
      }
    } catch (const std::exception& e) {
      FAIL() << e.what() << '\n' << text;
    }
  }
}

}  // namespace
}  // namespace dynamy
