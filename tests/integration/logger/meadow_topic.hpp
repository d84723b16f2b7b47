#pragma once

#include <meadow.h>

#include "common/bus/topic.hpp"

namespace scarab::bus {

template <>
inline const dds_topic_descriptor_t& descriptor<meadow_Weather>() {
  return meadow_Weather_desc;
}

template <>
inline const dds_topic_descriptor_t& descriptor<meadow_Reading>() {
  return meadow_Reading_desc;
}

inline constexpr Topic<meadow_Weather> kMeadowWeather{"meadow/weather", Profile::kStream};

}  // namespace scarab::bus
