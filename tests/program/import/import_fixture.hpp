/// Tests of dynamy import: a file is imported, and the model that comes of it is looked at.
#pragma once
#include <cmath>
#include <program/program_fixture.hpp>

namespace dynamy {

class ImportTest : public ProgramTest {
 protected:
  /// Imports a file of this content; the model is then model.xml, the notes are in err().
  int import(const std::string& file, const std::string& content, const std::string& options = "") {
    write(file, content);
    const int status = call("import " + file + " -o model.xml " + options);
    notes_ = err();
    return status;
  }
  std::string model() const { return readWholeFile(path("model.xml")); }
  /// The line of the model that holds `text`; "" if there is none.
  std::string line(const std::string& text) const {
    const std::string all = model();
    const std::size_t at = all.find(text);
    if (at == std::string::npos) return {};
    const std::size_t begin = all.rfind('\n', at) + 1;
    return all.substr(begin, all.find('\n', at) - begin);
  }
  void expectChecks() { EXPECT_EQ(call("check model.xml"), 0) << out() << err() << model(); }
  /// Value of a signal at the end of the run.
  double atEnd(const std::string& signal, const std::string& options) {
    EXPECT_EQ(call("run model.xml --quiet --out r " + options), 0) << out() << err();
    const std::string csv = readWholeFile(path("r/signals.csv"));
    const std::string head = csv.substr(0, csv.find('\n'));
    const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
    const auto cell = [](const std::string& row, std::size_t k) {
      std::size_t begin = 0;
      for (; k > 0; --k) begin = row.find(',', begin) + 1;
      return row.substr(begin, row.find(',', begin) - begin);
    };
    for (std::size_t k = 0; k < 100; ++k)
      if (cell(head, k).find(signal) == 0) return std::stod(cell(last, k));
    ADD_FAILURE() << "no signal " << signal << " in " << head;
    return 0.0;
  }
  std::string notes_;
};

}  // namespace dynamy
