#include "tools/log/selection.hpp"

#include <stdexcept>

#include "services/logger/core/sample_header.hpp"

namespace scarab::log {
namespace {

/// Why a channel cannot have messages of the selection; empty when it can.
std::string misfit(const LogChannel& channel, const SelectionOptions& options) {
  const bool needs_type = options.trial || !options.filter.empty() || !options.fields.empty();
  if (needs_type && !channel.type) return channel.no_type;
  if (options.trial && !channel.has_header) return "its samples have no header, so no trial";
  try {
    if (!options.filter.empty()) sample::SampleFilter(*channel.type, options.filter);
    for (const std::string& field : options.fields) sample::FieldPath(*channel.type, field);
  } catch (const bus::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

Selection::Selection(const Log& log, const SelectionOptions& options)
    : trial_(options.trial),
      has_query_(!options.filter.empty() || !options.fields.empty()),
      options_(options) {
  for (const std::string& topic : options.topics) {
    const std::string reason = misfit(require_topic(log, topic), options);
    if (!reason.empty()) throw std::invalid_argument(topic + ": " + reason);
    topics_.insert(topic);
  }
  if (!options.topics.empty()) return;
  std::string reasons;
  for (const std::string& topic : log.topics()) {
    const std::string reason = misfit(*log.find(topic), options);
    if (reason.empty()) {
      topics_.insert(topic);
    } else {
      reasons += "\n  " + topic + ": " + reason;
    }
  }
  if (topics_.empty() && !reasons.empty()) {
    throw std::invalid_argument("no topic of the log fits:" + reasons);
  }
}

const Selection::Query* Selection::query_of(const LogChannel& channel) const {
  if (!has_query_) return nullptr;
  const auto [entry, fresh] = queries_.try_emplace(&channel);
  // A topic may have several channels, not all of a type that the query makes sense for.
  if (fresh && misfit(channel, options_).empty()) {
    Query query;
    if (!options_.filter.empty()) query.filter.emplace(*channel.type, options_.filter);
    for (const std::string& field : options_.fields) {
      query.fields.emplace_back(*channel.type, field);
    }
    entry->second = std::move(query);
  }
  return entry->second ? &*entry->second : nullptr;
}

bool Selection::takes(const LogChannel& channel, const mcap::Message& message) const {
  if (trial_) {
    const auto header = logger::read_sample_header(message.data.data(), message.data.size());
    if (!channel.has_header || !header || header->trial != *trial_) return false;
  }
  if (!has_query_) return true;
  const Query* query = query_of(channel);
  return query != nullptr && (!query->filter || query->filter->matches(cdr_of(message)));
}

const std::vector<sample::FieldPath>& Selection::fields(const LogChannel& channel) const {
  static const std::vector<sample::FieldPath> kAll;
  const Query* query = query_of(channel);
  return query == nullptr ? kAll : query->fields;
}

}  // namespace scarab::log
