#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/sample/field_values.hpp"
#include "tools/topic/meter.hpp"

namespace scarab::topic {

/// How old samples are when they are received, by the wall clocks of both hosts.
class DelayMeter : public Meter {
 public:
  /// `field`: the time at which a sample was made, in ns since the Unix epoch, or as a struct of
  /// `sec` and `nanosec`; empty: the source time stamp that DDS sends along.
  explicit DelayMeter(std::string field) : field_(std::move(field)) {}

  void begin(const sample::TypeModel* model) override;
  void add(const bus::RawSample& sample) override;
  void end_second(double elapsed_s, std::size_t seconds) override;
  std::vector<Column> columns() const override;
  std::vector<std::string> row() const override;
  std::string json() const override;

 private:
  struct Part {
    std::vector<double> delays_s;
    void add(const Part& other);
  };
  struct Summary;
  Summary summary() const;
  std::int64_t made_at_ns(const bus::RawSample& sample) const;

  std::string field_;
  std::unique_ptr<sample::FieldValues> values_;  ///< one: ns; two: sec and nanosec; null: no field
  Rolling<Part> parts_;
};

}  // namespace scarab::topic
