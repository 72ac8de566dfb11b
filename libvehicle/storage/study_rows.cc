#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/csv_text.h"
#include "libvehicle/storage/study_open.h"
#include "libvehicle/storage/study_refusal.h"

// Designs into the database and out of it.
namespace vehicle {

namespace {

constexpr int kFirstValue = 3;  // after id, status, message

void requireStorable(const StudyRecord& record, const DesignBatch& batch) {
  if (batch.parameters() != record.parameters.size() || batch.metrics() != record.metrics.size()) {
    throw std::invalid_argument(fmt::format("StudyDatabase: the batch has {} + {} columns, the study {} + {}",
                                            batch.parameters(), batch.metrics(), record.parameters.size(),
                                            record.metrics.size()));
  }
  for (std::size_t row = 0; row < batch.size(); ++row) {
    const std::uint64_t id = batch.rows()[row].id;
    if (id >= record.designs) {
      throw std::invalid_argument(fmt::format("StudyDatabase: id {} of a study of {} designs", id, record.designs));
    }
    const std::span<const double> values = batch.values(row);
    const std::size_t parameters = record.parameters.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool is_parameter = i < parameters;
      if (std::isfinite(values[i]) || (!is_parameter && std::isnan(values[i]))) continue;
      const Channel& column = is_parameter ? record.parameters[i] : record.metrics[i - parameters];
      throw std::invalid_argument(fmt::format("StudyDatabase: id {}: {} = {}, must be finite{}", id, column.name,
                                              values[i], is_parameter ? "" : ", or NaN where there is no value"));
    }
  }
}

}  // namespace

std::uint64_t StudyDatabase::stored() const {
  try {
    SqliteStatement count(*open_->connection, "SELECT count(*) FROM designs");
    count.step();
    return static_cast<std::uint64_t>(count.integer(0));
  } catch (const SqliteError& error) {
    refuseReading(open_->shown, error);
  }
}

std::vector<DesignRange> StudyDatabase::missing() const {
  std::vector<DesignRange> ranges;
  std::uint64_t next = 0;
  const auto gapTo = [&](std::uint64_t end) {
    if (next < end) ranges.push_back({next, end - 1});
  };
  try {
    SqliteStatement ids(*open_->connection, "SELECT id FROM designs ORDER BY id");
    while (ids.step()) {
      const auto id = static_cast<std::uint64_t>(ids.integer(0));
      if (id < next || id >= open_->record.designs) {
        refuseDatabase(open_->shown, fmt::format("is damaged: it holds a row {} of {}", id, open_->record.designs),
                       "go on with a copy, or begin a new study");
      }
      gapTo(id);
      next = id + 1;
    }
  } catch (const SqliteError& error) {
    refuseReading(open_->shown, error);
  }
  gapTo(open_->record.designs);
  return ranges;
}

void StudyDatabase::append(const DesignBatch& batch) {
  if (open_->insert == nullptr) throw std::invalid_argument("StudyDatabase: opened for reading, cannot append");
  requireStorable(open_->record, batch);
  SqliteConnection& connection = *open_->connection;
  SqliteStatement& insert = *open_->insert;
  std::uint64_t at_hand = 0;
  try {
    connection.run("BEGIN IMMEDIATE");
    for (std::size_t row = 0; row < batch.size(); ++row) {
      const DesignBatch::Row& head = batch.rows()[row];
      const std::span<const double> values = batch.values(row);
      at_hand = head.id;
      insert.bind(1, static_cast<std::int64_t>(head.id));
      insert.bind(2, std::string_view(head.status == DesignStatus::kDone ? "done" : "failed"));
      if (head.message) {
        insert.bind(3, std::string_view(batch.messages()[*head.message]));
      } else {
        insert.bindNothing(3);
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        const int place = kFirstValue + 1 + static_cast<int>(i);
        if (std::isnan(values[i])) {
          insert.bindNothing(place);
        } else {
          insert.bind(place, values[i] + 0.0);  // -0 + 0 = 0: SQLite keeps no sign of zero, whoever asks it
        }
      }
      const std::string warnings = head.warnings.words();
      const int last = kFirstValue + 1 + static_cast<int>(values.size());
      if (warnings.empty()) {
        insert.bindNothing(last);
      } else {
        insert.bind(last, std::string_view(warnings));
      }
      insert.runOnce();
    }
    connection.run("COMMIT");
  } catch (const SqliteError& error) {
    // After a full disk SQLite may have rolled back by itself; then there is nothing to undo.
    if (sqlite3_get_autocommit(connection.get()) == 0) {
      sqlite3_exec(connection.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
    if ((error.code & 0xff) == SQLITE_CONSTRAINT) {
      throw std::invalid_argument(fmt::format("StudyDatabase: id {} is stored already", at_hand));
    }
    open_->fail("cannot be written", error, "what was stored before is safe; make room and go on with it");
  }
}

void StudyDatabase::forEach(const std::function<bool(const StoredDesign&)>& visit) const {
  const std::size_t parameters = open_->record.parameters.size();
  const std::size_t metrics = open_->record.metrics.size();
  std::vector<double> values(parameters + metrics);
  try {
    SqliteStatement rows(*open_->connection, "SELECT * FROM designs ORDER BY id");
    while (rows.step()) {
      StoredDesign design;
      design.id = static_cast<std::uint64_t>(rows.integer(0));
      design.status = rows.text(1) == "done" ? DesignStatus::kDone : DesignStatus::kFailed;
      design.message = rows.text(2);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = rows.numberOrNan(kFirstValue + static_cast<int>(i));
      const int last = kFirstValue + static_cast<int>(values.size());
      if (rows.columns() > last) design.warnings = WarningSet::ofWords(rows.text(last));
      design.parameters = std::span(values).first(parameters);
      if (design.status == DesignStatus::kDone) design.metrics = std::span(values).last(metrics);
      if (!visit(design)) return;
    }
  } catch (const SqliteError& error) {
    refuseReading(open_->shown, error);
  }
}

void StudyDatabase::writeCsv(const std::filesystem::path& path,
                             const std::function<std::string(std::uint64_t)>& nameOf) const {
  AtomicFile file(path);
  std::string text = nameOf ? "id,design,status" : "id,status";
  for (const std::vector<Channel>* list : {&open_->record.parameters, &open_->record.metrics}) {
    for (const Channel& each : *list) {
      text += ',';
      appendField(text, fmt::format("{} [{}]", each.name, each.unit));
    }
  }
  text += ",warnings,message\n";
  constexpr std::size_t kBlock = 1 << 20;
  const std::size_t metrics = open_->record.metrics.size();
  forEach([&](const StoredDesign& design) {
    text += std::to_string(design.id);
    if (nameOf) {
      text += ',';
      appendField(text, nameOf(design.id));
    }
    text += design.status == DesignStatus::kDone ? ",done" : ",failed";
    for (const double value : design.parameters) {
      text += ',';
      appendNumber(text, value);
    }
    for (std::size_t i = 0; i < metrics; ++i) {
      text += ',';
      if (i < design.metrics.size() && !std::isnan(design.metrics[i])) appendNumber(text, design.metrics[i]);
    }
    text += ',' + design.warnings.words() + ',';
    appendField(text, design.message);
    text += '\n';
    if (text.size() >= kBlock) {
      file.write(text);
      text.clear();
    }
    return true;
  });
  file.write(text);
  file.publish();
}

}  // namespace vehicle
