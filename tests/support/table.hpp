/// What a run records, kept in memory.
#pragma once
#include <dynamy/core/archive.hpp>
#include <dynamy/simulation/report/record_sink.hpp>
#include <vector>

namespace dynamy {

/// Keeps all rows of signals.
class Table final : public RecordSink {
 public:
  void row(double at, std::span<const double> values) override {
    t.push_back(at);
    rows.emplace_back(values.begin(), values.end());
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void archive(Archive& a) override { a(t), a(rows); }
  std::vector<double> t;
  std::vector<std::vector<double>> rows;
};

}  // namespace dynamy
