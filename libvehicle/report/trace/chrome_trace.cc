#include "libvehicle/report/trace/chrome_trace.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "libvehicle/storage/output_kind.h"

namespace vehicle::report {
namespace {

using Json = nlohmann::ordered_json;

Json nameEvent(const char* of, int thread, const std::string& name) {
  return {{"name", of}, {"ph", "M"}, {"pid", 1}, {"tid", thread}, {"args", {{"name", name}}}};
}

Json spanEvent(const Span& span) {
  const bool waits = span.kind == Span::Kind::kWait;
  return {{"name", waits ? fmt::format("wait for thread {}", span.for_whom + 1) : "compute"},
          {"cat", waits ? "wait" : "compute"},
          {"ph", "X"},
          {"pid", 1},
          {"tid", span.thread + 1},
          {"ts", 1e6 * span.begin_s},
          {"dur", 1e6 * (span.end_s - span.begin_s)},
          {"args", {{"step", span.step}}}};
}

// One event a line: a trace of a hundred thousand spans can be looked at with any tool.
void addLine(std::string& text, const Json& event) {
  text += text.back() == '[' ? "\n" : ",\n";
  text += event.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string chromeTraceOf(const Trace& trace, const std::string& title) {
  std::string text = fmt::format("{{\"displayTimeUnit\":\"ns\",{},\"traceEvents\":[", kTraceMark);
  addLine(text, nameEvent("process_name", 0, title));
  for (int i = 1; i <= trace.threads; ++i) addLine(text, nameEvent("thread_name", i, fmt::format("thread {}", i)));
  for (const Span& span : trace.spans) addLine(text, spanEvent(span));
  return text + "\n]}\n";
}

}  // namespace vehicle::report
