#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/topic/topic_report.hpp"

namespace scarab::topic {

/// A line a topic: its name, type, writers and readers; below it, indented and marked with !, what
/// is wrong with it. Where the lines are wider than `width` (0: any width is right), names beyond
/// the first become a number. `verbose`: below each topic its endpoints with their QoS.
std::string topic_table(const DomainView& view, const std::vector<TopicReport>& reports,
                        std::size_t width, bool verbose);

}  // namespace scarab::topic
