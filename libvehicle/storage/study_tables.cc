#include "libvehicle/storage/study_tables.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace vehicle {

namespace {

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

/// Names for SQLite, which takes "A.x" and "a.x" for the same column.
class ColumnNames {
 public:
  std::string nameFor(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !taken_.insert(lower(name)).second; ++number) name = fmt::format("{} ({})", wanted, number);
    return name;
  }

 private:
  static std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
  }
  std::set<std::string> taken_ = {"id", "status", "message", "warnings"};
};

std::int64_t pragma(SqliteConnection& connection, const std::string& name) {
  SqliteStatement statement(connection, "PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

}  // namespace

void writeStudyTables(SqliteConnection& connection, const StudyRecord& record) {
  connection.run(fmt::format("PRAGMA application_id={}; PRAGMA user_version={};", kStudyApplication, kStudyFormat));
  connection.run(
      "CREATE TABLE study(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE input_files(position INTEGER PRIMARY KEY, name TEXT NOT NULL, content BLOB NOT NULL);"
      "CREATE TABLE columns(position INTEGER PRIMARY KEY, role TEXT NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,"
      " column_name TEXT NOT NULL);");

  SqliteStatement study(connection, "INSERT INTO study VALUES(?,?)");
  const auto tell = [&study](std::string_view key, const std::string& value) {
    study.bind(1, key);
    study.bind(2, std::string_view(value));
    study.runOnce();
  };
  tell("program", record.program);
  tell("designs", std::to_string(record.designs));

  SqliteStatement input(connection, "INSERT INTO input_files VALUES(?,?,CAST(? AS BLOB))");
  for (std::size_t i = 0; i < record.inputs.size(); ++i) {
    input.bind(1, static_cast<std::int64_t>(i));
    input.bind(2, std::string_view(record.inputs[i].name));
    input.bind(3, std::string_view(record.inputs[i].text));
    input.runOnce();
  }

  std::string table = "CREATE TABLE designs(id INTEGER PRIMARY KEY, status TEXT NOT NULL, message TEXT";
  SqliteStatement column(connection, "INSERT INTO columns VALUES(?,?,?,?,?)");
  ColumnNames names;
  std::int64_t position = 0;
  const auto enter = [&](const Channel& channel, std::string_view role) {
    const std::string own = names.nameFor(channel.name);
    table += ", " + quoted(own) + " REAL";
    column.bind(1, position++);
    column.bind(2, role);
    column.bind(3, std::string_view(channel.name));
    column.bind(4, std::string_view(channel.unit));
    column.bind(5, std::string_view(own));
    column.runOnce();
  };
  for (const Channel& each : record.parameters) enter(each, "parameter");
  for (const Channel& each : record.metrics) enter(each, "metric");
  connection.run(table + ", warnings TEXT)");  // last: format 1 has none
}

std::string whyNoStudy(SqliteConnection& connection) {
  if (pragma(connection, "application_id") != kStudyApplication) return "holds no study";
  const std::int64_t format = pragma(connection, "user_version");
  if (format >= kOldestStudyFormat && format <= kStudyFormat) return "";
  return fmt::format("holds a study in format {}, this program reads formats {} to {}", format, kOldestStudyFormat,
                     kStudyFormat);
}

std::string whyOnlyShown(SqliteConnection& connection) {
  const std::int64_t format = pragma(connection, "user_version");
  if (format == kStudyFormat) return "";
  return fmt::format(
      "holds a study in format {}, which an older program wrote: it can be shown, but numbers of two "
      "programs are not mixed; write to a new file",
      format);
}

StudyRecord readStudyTables(SqliteConnection& connection) {
  StudyRecord record;
  SqliteStatement study(connection, "SELECT key, value FROM study");
  while (study.step()) {
    if (study.text(0) == "program") record.program = study.text(1);
    if (study.text(0) == "designs") record.designs = static_cast<std::uint64_t>(study.integer(1));
  }
  SqliteStatement input(connection, "SELECT name, content FROM input_files ORDER BY position");
  while (input.step()) record.inputs.push_back({std::string(input.text(0)), std::string(input.text(1))});
  SqliteStatement column(connection, "SELECT role, name, unit FROM columns ORDER BY position");
  while (column.step()) {
    std::vector<Channel>& list = column.text(0) == "parameter" ? record.parameters : record.metrics;
    list.push_back({std::string(column.text(1)), std::string(column.text(2))});
  }
  return record;
}

}  // namespace vehicle
