#pragma once

#include "tools/topic/meter.hpp"
#include "tools/topic/moments.hpp"

namespace scarab::topic {

/// How many bytes arrive: serialised samples with their header of 4 bytes, without what RTPS, UDP
/// and IP add.
class BandwidthMeter : public Meter {
 public:
  void add(const bus::RawSample& sample) override;
  void end_second(double elapsed_s, std::size_t seconds) override;
  std::vector<Column> columns() const override;
  std::vector<std::string> row() const override;
  std::string json() const override;

 private:
  struct Part {
    double elapsed_s = 0.0;
    Moments size_bytes;
    void add(const Part& other);
    double per_second(double amount) const { return elapsed_s > 0.0 ? amount / elapsed_s : 0.0; }
    double samples() const { return static_cast<double>(size_bytes.count()); }
    double bytes() const { return size_bytes.count() == 0 ? 0.0 : size_bytes.mean() * samples(); }
  };

  Rolling<Part> parts_;
};

}  // namespace scarab::topic
