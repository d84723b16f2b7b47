#include "tools/sim/sample_log.hpp"

#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sim {

SampleLog::SampleLog(const std::filesystem::path& path) {
  if (path.empty()) return;
  mcap::WriterOptions options;
  options.overwrite = true;
  writer_ = std::make_unique<mcap::Writer>(path, options);
}

void SampleLog::close() {
  if (writer_) writer_->close();
}

void SampleLog::write_bytes(const std::string& topic, const dds_topic_descriptor_t& type,
                            const sample::Bytes& bytes) {
  auto [entry, fresh] = channels_.try_emplace(topic);
  if (fresh) entry->second.id = add_channel(topic, type);
  mcap::Message message;
  message.channel_id = entry->second.id;
  message.sequence = entry->second.sequence++;
  message.log_time_ns = static_cast<std::uint64_t>(bus::now_ns());
  message.publish_time_ns = message.log_time_ns;
  message.data = {bytes.data(), bytes.size()};
  writer_->write(message);
}

std::uint16_t SampleLog::add_channel(const std::string& topic, const dds_topic_descriptor_t& type) {
  const auto model = bus::model_of(type);
  const auto schema = writer_->add_schema(model.name(), "omgidl", sample::idl_text(model));
  return writer_->add_channel(schema, topic, "cdr");
}

}  // namespace scarab::sim
