#include "tools/topic/named_type.hpp"

#include "common/bus/known_types.hpp"
#include "common/bus/topic_type.hpp"
#include "tools/topic/failure.hpp"

namespace scarab::topic {
namespace {

Failure unknown_type(const std::string& name, const DomainView& view) {
  std::vector<std::string> names = bus::known_type_names();
  for (const auto& endpoint : view.endpoints) names.push_back(endpoint.type);
  return Failure(kExitNoType, "nobody in the domain has a type " + name +
                                  ", and it is none of Scarab's own" + did_you_mean(name, names));
}

}  // namespace

bus::TopicType find_named_type(Session& session, const std::string& name, Clock::time_point end) {
  if (const auto* known = bus::find_known_type(name)) return bus::borrow_compiled(*known);
  bool more = true;
  while (!session.interrupted()) {
    const DomainView view = session.view();
    std::vector<bus::DiscoveredEndpoint> of_type;
    for (const auto& endpoint : view.endpoints) {
      if (endpoint.type == name && endpoint.sends_type) of_type.push_back(endpoint);
    }
    if (!of_type.empty()) return session.type_of(of_type);
    if (!more) throw unknown_type(name, view);
    more = session.wait(end);
  }
  throw Interrupted{};
}

sample::TypeModel understood(const bus::TopicType& type) {
  try {
    return bus::model_of(*type);
  } catch (const bus::Error& error) {
    throw Failure(kExitNoType, error.what());
  }
}

}  // namespace scarab::topic
