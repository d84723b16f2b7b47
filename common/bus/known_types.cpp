#include "common/bus/known_types.hpp"

#include <algorithm>

#include "common/bus/topics.hpp"

namespace scarab::bus {

namespace {

template <class T>
const dds_topic_descriptor_t* descriptor_of(const Topic<T>&) {
  return &descriptor<T>();
}

}  // namespace

const dds_topic_descriptor_t* find_known_type(const std::string& type_name) {
  const dds_topic_descriptor_t* found = nullptr;
  for_each_topic([&](const auto& topic) {
    const dds_topic_descriptor_t* candidate = descriptor_of(topic);
    if (type_name == candidate->m_typename) found = candidate;
  });
  return found;
}

std::vector<std::string> known_type_names() {
  std::vector<std::string> names;
  for_each_topic([&](const auto& topic) { names.emplace_back(descriptor_of(topic)->m_typename); });
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace scarab::bus
