#include "common/bus/dynamic_sample.hpp"

#include <utility>

namespace scarab::bus {

DynamicSample::DynamicSample(TopicType type, ByteView cdr)
    : type_(std::move(type)), memory_(dds_alloc(type_->m_size)) {
  try {
    decode_sample(*type_, cdr, memory_);
  } catch (...) {
    dds_free(memory_);
    throw;
  }
}

DynamicSample::~DynamicSample() { dds_sample_free(memory_, type_.get(), DDS_FREE_ALL); }

}  // namespace scarab::bus
