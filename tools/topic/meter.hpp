#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/raw_cdr.hpp"
#include "common/runtime/options.hpp"
#include "common/sample/type_model.hpp"

namespace CLI {
class App;
}

namespace scarab::topic {

/// What is measured of a topic, over a window of seconds. measure() tells it of samples and time.
class Meter {
 public:
  struct Column {
    std::string heading;
    std::string unit;
  };

  Meter() = default;
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  virtual ~Meter() = default;

  /// The type is known now. Throws Failure for options that do not fit it.
  virtual void begin(const sample::TypeModel* /*model: null where not understood*/) {}
  virtual void add(const bus::RawSample& sample) = 0;
  /// A second of `elapsed_s` is over; no more than `seconds` of them are to be remembered.
  virtual void end_second(double elapsed_s, std::size_t seconds) = 0;

  virtual std::vector<Column> columns() const = 0;
  /// A cell for each column.
  virtual std::vector<std::string> row() const = 0;
  virtual std::string json() const = 0;
};

/// The last seconds of a measurement. A Part needs `add(const Part&)`.
template <class Part>
class Rolling {
 public:
  Part& now() { return now_; }

  void end_second(std::size_t seconds) {
    past_.push_back(std::move(now_));
    now_ = Part{};
    while (past_.size() > seconds) past_.pop_front();
  }

  /// All of them together, without the one that goes on.
  Part sum() const {
    Part out;
    for (const Part& part : past_) out.add(part);
    return out;
  }

 private:
  Part now_;
  std::deque<Part> past_;
};

struct MeasureOptions {
  std::string topic;
  std::optional<std::uint64_t> lines;  ///< nothing: until Ctrl-C
  std::size_t window_s = 10;
  double timeout_s = 2.0;
  bool json = false;
};

/// The operand and options that all measuring commands have.
void add_measure_options(CLI::App& command, MeasureOptions& options);

/// Prints a line a second. Returns the exit code.
int measure(const runtime::BusOptions& bus_options, const MeasureOptions& options, Meter& meter);

}  // namespace scarab::topic
