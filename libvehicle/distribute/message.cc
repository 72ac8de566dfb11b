#include "libvehicle/distribute/message.h"

namespace vehicle {

namespace {

/// Failures or gaps: a design and its message each.
template <class DesignNote>
void putNotes(const std::vector<DesignNote>& notes, Packer& message) {
  message.put<std::uint64_t>(notes.size());
  for (const DesignNote& each : notes) {
    message.put(each.design);
    message.putText(each.message);
  }
}

template <class DesignNote>
void getNotes(Unpacker& message, std::vector<DesignNote>& notes) {
  const auto count = message.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto design = message.get<std::int64_t>();
    notes.push_back({design, message.getText()});
  }
}

}  // namespace

std::vector<std::byte> packBatch(const Batch& batch) {
  Packer message;
  message.put(batch.range);
  message.put<std::uint64_t>(batch.values.size());
  message.putAll(std::span<const double>(batch.values));
  putNotes(batch.failures, message);
  putNotes(batch.gaps, message);
  message.put<std::uint64_t>(batch.warnings.size());
  message.putAll(std::span<const DesignWarnings>(batch.warnings));
  return message.take();
}

void unpackBatch(std::span<const std::byte> bytes, std::size_t columns, Batch& batch) {
  Unpacker message(bytes);
  batch.reset(message.get<DesignSpan>(), columns);
  if (message.get<std::uint64_t>() != batch.values.size()) {
    throw std::runtime_error(
        "ranks see different studies: let every machine read the same files with the same program");
  }
  message.getAll(std::span<double>(batch.values));
  getNotes(message, batch.failures);
  getNotes(message, batch.gaps);
  batch.warnings.resize(message.get<std::uint64_t>());
  message.getAll(std::span<DesignWarnings>(batch.warnings));
}

std::vector<std::byte> packPortion(const Task& task) {
  Packer message;
  message.put(task.range);
  message.putAll(task.given);
  return message.take();
}

Portion unpackPortion(std::span<const std::byte> bytes, std::size_t given) {
  Unpacker message(bytes);
  Portion portion;
  portion.range = message.get<DesignSpan>();
  portion.given.resize(static_cast<std::size_t>(portion.range.size()) * given);
  message.getAll(std::span<double>(portion.given));
  return portion;
}

}  // namespace vehicle
