#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/config/config.hpp"

/// A made-up configuration with every kind of member.
namespace scarab::gait {

enum class Kind { kTripod, kTetrapod, kWave };

struct Leg {
  double length_m = 0;
  bool present = false;
};

struct Gait {
  std::string name;
  Kind kind = Kind::kTripod;
  double frequency_hz = 0;
  int offset = 0;
  unsigned legs = 0;
  std::uint64_t seed = 0;
  std::array<double, 3> phases{};
  double weights[2] = {0, 0};
  std::vector<int> order;
  std::map<std::string, Leg> parts;
  std::optional<Leg> tail;
  std::vector<Leg> spares;
  double trim = 0.25;
};

inline std::array<std::pair<std::string_view, Kind>, 3> enum_names(Kind) {
  return {{{"tripod", Kind::kTripod}, {"tetrapod", Kind::kTetrapod}, {"wave", Kind::kWave}}};
}

template <class Fields>
void visit_fields(Fields& f, Leg& c) {
  f("length_m", c.length_m, config::kPositive);
  f("present", c.present);
}

template <class Fields>
void visit_fields(Fields& f, Gait& c) {
  f("name", c.name);
  f("kind", c.kind);
  f("frequency_hz", c.frequency_hz, config::Range{0.1, 5});
  f("offset", c.offset);
  f("legs", c.legs, config::Range{0, 8});
  f("seed", c.seed);
  f("phases", c.phases, config::kFraction);
  f("weights", c.weights);
  f("order", c.order);
  f("parts", c.parts);
  f("tail", c.tail);
  f("spares", c.spares);
  f.optional("trim", c.trim, config::Range{-1, 1});
}

inline void validate(const Gait& gait, const config::Check& check) {
  check.require(gait.order.size() == gait.legs, "order", "needs one entry for each leg");
  for (const auto& [name, leg] : gait.parts) {
    check.require(leg.length_m < 1, "parts." + name + ".length_m", "longer than the robot");
  }
}

inline constexpr const char* kGood = R"(name: walk
kind: wave
frequency_hz: 1.5
offset: -2
legs: 2
seed: 18446744073709551615
phases: [0, 0.25, 0.5]
weights: [1e-3, -2]
order: [2, 1]
parts:
  left: {length_m: 0.3, present: true}
  right:
    length_m: 0.4
    present: false
tail: absent
spares:
  - {length_m: 0.1, present: true}
)";

}  // namespace scarab::gait
