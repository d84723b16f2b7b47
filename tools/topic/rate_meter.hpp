#pragma once

#include <cstdint>
#include <optional>

#include "tools/topic/meter.hpp"
#include "tools/topic/moments.hpp"

namespace scarab::topic {

/// How often samples arrive, and how regularly: rate and the intervals between arrivals.
class RateMeter : public Meter {
 public:
  void add(const bus::RawSample& sample) override;
  void end_second(double elapsed_s, std::size_t seconds) override;
  std::vector<Column> columns() const override;
  std::vector<std::string> row() const override;
  std::string json() const override;

 private:
  struct Part {
    std::uint64_t samples = 0;
    double elapsed_s = 0.0;
    Moments interval_s;
    void add(const Part& other);
  };
  static double rate_hz(const Part& part);

  Rolling<Part> parts_;
  std::optional<std::int64_t> last_ns_;
};

}  // namespace scarab::topic
