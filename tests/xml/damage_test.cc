#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "libvehicle/xml/writer.h"
#include "tests/xml/files.h"

// Damaged files: whatever happens to the bytes, the reader answers with problems or with a sane value.
namespace vehicle {
namespace {

void expectFinite(const Value& value, const std::string& where) {
  const double* number = std::get_if<double>(&value);
  EXPECT_TRUE(number == nullptr || std::isfinite(*number)) << where;
}

void expectFinite(const ElementRow& row, const void* object, const std::string& text) {
  for (const AttributeRow& each : row.attributes) {
    if (each.get != nullptr) expectFinite(each.get(object), std::string(each.name) + " in\n" + text);
  }
  for (const ElementRow& child : row.children) {
    for (std::size_t i = 0; child.count != nullptr && i < child.count(object); ++i) {
      expectFinite(child, child.at(object, i), text);
    }
  }
}

template <class Definition>
bool survives(const Outcome<Definition>& outcome, FileKind kind, const std::string& text) {
  EXPECT_NE(outcome.value.has_value(), !outcome.problems.empty()) << text;
  for (const Problem& problem : outcome.problems) {
    EXPECT_FALSE(problem.message.empty()) << text;
    EXPECT_EQ(problem.text().find('\n'), std::string::npos) << problem.text();
  }
  if (outcome.value) expectFinite(schemaOf(kind), &*outcome.value, text);
  return outcome.value.has_value();
}

std::string damaged(std::string text, std::mt19937& random) {
  // Bytes that mean something to XML or to numbers are likelier to get through than random ones.
  using std::string_literals::operator""s;
  static const std::string kTelling = "<>/\"'=&;!-?[] \n\t0123456789eE+.*^kMmNstinfa\0\xFF"s;
  const auto below = [&random](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t edits = 1 + below(3);
  for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(text.size() - at, 1 + below(12));
    const std::size_t digit = text.find_first_of("0123456789", at);
    switch (below(8)) {
      case 0:
        text[at] = kTelling[below(kTelling.size())];
        break;
      case 1:
        text.insert(at, 1, kTelling[below(kTelling.size())]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 4:
        text[at] = static_cast<char>(below(256));
        break;
      default:  // numbers, which a file survives
        if (digit != std::string::npos) text[digit] = "0123456789eE.-+"[below(15)];
    }
  }
  return text;
}

TEST(DamagedFiles, NeverCrashAndNeverGiveNumbersThatAreNotFinite) {
  std::mt19937 random(7);
  int accepted = 0;
  int refused = 0;
  const std::string vehicle = test::textOf(test::kVehicleLines);
  const std::string scenario = test::textOf(test::kScenarioLines);
  const std::string rig = test::textOf(test::kRigLines);
  const std::string suite = test::textOf(test::kSuiteLines);
  for (int i = 0; i < 2000; ++i) {
    for (const std::string* whole : {&vehicle, &scenario, &rig, &suite}) {
      const std::string text = damaged(*whole, random);
      const bool good = whole == &vehicle ? survives(readVehicleText(text, "v.xml"), FileKind::kVehicle, text)
                        : whole == &suite ? survives(readSuiteText(text, "u.xml"), FileKind::kSuite, text)
                                          : survives(readScenarioText(text, "s.xml"), FileKind::kScenario, text);
      ++(good ? accepted : refused);
    }
  }
  // Both ways are walked: some edits only change a number, most spoil the file.
  EXPECT_GT(accepted, 200);
  EXPECT_GT(refused, 2000);
}

TEST(DamagedFiles, EveryTruncationIsRefused) {
  const std::string whole = test::textOf(test::kVehicleLines);
  const std::size_t end = whole.rfind('>');  // behind it only the last newline is lost
  for (std::size_t length = 0; length <= end; ++length) {
    EXPECT_FALSE(readVehicleText(whole.substr(0, length), "v.xml").ok()) << length;
  }
}

// What is accepted can be written and read again: nothing gets in that the writer cannot say.
TEST(DamagedFiles, WhatIsAcceptedComesBackFromTheWriter) {
  std::mt19937 random(11);
  const std::string whole = test::textOf(test::kVehicleLines);
  int accepted = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto outcome = readVehicleText(damaged(whole, random), "v.xml");
    if (!outcome.value) continue;
    ++accepted;
    EXPECT_EQ(readVehicleText(write(*outcome.value), "again.xml").orThrow(), *outcome.value);
  }
  EXPECT_GT(accepted, 50);
}

}  // namespace
}  // namespace vehicle
