#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/units/quantity.h"

namespace vehicle {
namespace {

using enum Dimension;

struct Meant {
  const char* text;
  Dimension dimension;
  const char* suggestion;
};

std::string suggestionFor(const std::string& text, Dimension dimension) {
  const std::string remedy = parseQuantity(text, dimension).remedy;
  constexpr std::string_view kBegin = "did you mean \"";
  const std::size_t at = remedy.find(kBegin);
  return at == std::string::npos ? "" : remedy.substr(at + kBegin.size(), remedy.size() - at - kBegin.size() - 2);
}

TEST(UnitSuggestion, CommonSpellingsLeadToTheUnitOfTheDimensionExpected) {
  const std::vector<Meant> cases = {
      {"20 km/hr", kSpeed, "20 km/h"},
      {"20 kmh", kSpeed, "20 km/h"},
      {"20 kph", kSpeed, "20 km/h"},
      {"20 km per hour", kSpeed, "20 km/h"},
      {"20 Km/H", kSpeed, "20 km/h"},
      {"5 m/sec", kSpeed, "5 m/s"},
      {"5 m.s^-1", kSpeed, "5 m*s^-1"},
      {"5 metres per second", kSpeed, "5 m/s"},
      {"2 sec", kTime, "2 s"},
      {"2 seconds", kTime, "2 s"},
      {"2 msec", kTime, "2 ms"},
      {"2 Ms", kTime, "2 ms"},
      {"9.81 m/s2", kAcceleration, "9.81 m/s^2"},
      {"9.81 m/s**2", kAcceleration, "9.81 m/s^2"},
      {"2 MN m^-1", kStiffness, "2 MN*m^-1"},
      {"2 kN per m", kStiffness, "2 kN/m"},
      {"2 kM/m", kStiffness, "2 kN/m"},
      {"2 KN/mm", kStiffness, "2 kN/mm"},
      {"30 kNs/m", kDamping, "30 kN*s/m"},
      {"30 kN s/m", kDamping, "30 kN*s/m"},
      {"30 kN.s/m", kDamping, "30 kN*s/m"},
      {"30 kN-s/m", kDamping, "30 kN*s/m"},
      {"100 Newton", kForce, "100 N"},
      {"100 kilonewtons", kForce, "100 kN"},
      {"57 Kg", kMass, "57 kg"},
      {"57 tonnes", kMass, "57 t"},
      {"57 T", kMass, "57 t"},
      {"70 t m2", kInertia, "70 t*m^2"},
      {"70 kgm^2", kInertia, "70 kg*m^2"},
      {"200 grad", kAngle, "200 deg"},
      {"200 Grad", kAngle, "200 deg"},
      {"20 \u00b0", kAngle, "20 deg"},
      {"20 degrees", kAngle, "20 deg"},
      {"5 MM", kLength, "5 mm"},
      {"5 Mm", kLength, "5 mm"},
      {"5 millimetres", kLength, "5 mm"},
      {"1 hz", kFrequency, "1 Hz"},
      {"80 percent", kNumber, "80%"},
      {"90 GN/m1.5", kHertzConstant, "90 GN/m^1.5"},
  };
  for (const Meant& each : cases) {
    EXPECT_FALSE(parseQuantity(each.text, each.dimension).si.has_value()) << each.text;
    EXPECT_EQ(suggestionFor(each.text, each.dimension), each.suggestion) << each.text;
    EXPECT_TRUE(parseQuantity(each.suggestion, each.dimension).si.has_value()) << each.suggestion;
  }
}

// Whatever is suggested for a mistyped unit is of the dimension that was asked for, or nothing is.
TEST(UnitSuggestion, IsNeverOfAnotherDimension) {
  const std::vector<std::string> words = {"grad", "kM", "KN", "tm", "Kg", "sek", "N/mn", "kn*s", "rda", "htz", "mm/", "m^",
                                          "hour", "to/m", "q", "kNm/rd", "(m", "t**m2", "per", "", "m/s2/kG"};
  for (int i = 0; i <= static_cast<int>(kAngularAcceleration); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    for (const std::string& word : words) {
      const std::string suggestion = suggestionFor("3 " + word, dimension);
      if (suggestion.empty()) continue;
      EXPECT_TRUE(parseQuantity(suggestion, dimension).si.has_value()) << word << " -> " << suggestion;
    }
  }
}

TEST(UnitSuggestion, UnitsOfOtherSystemsComeWithTheirValue) {
  EXPECT_NE(parseQuantity("60 mph", kSpeed).remedy.find("1 mph = 1.609344 km/h"), std::string::npos);
  EXPECT_NE(parseQuantity("60 kgf", kForce).remedy.find("1 kgf = 9.80665 N"), std::string::npos);
  EXPECT_NE(parseQuantity("60 daN/mm", kStiffness).remedy.find("1 daN = 10 N"), std::string::npos);
  EXPECT_NE(parseQuantity("200 gon", kAngle).remedy.find("1 gon = 0.9 deg"), std::string::npos);
  EXPECT_EQ(parseQuantity("60 mph", kMass).remedy.find("mph ="), std::string::npos);
}

TEST(NumberSeparators, AreNamedAndTheNumberIsWrittenWithoutThem) {
  struct Case {
    const char* text;
    const char* message;
    const char* remedy;
  };
  const std::vector<Case> cases = {
      {"57 000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"57'000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"57\u2019000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"57\u00a0000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"57\u202f000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"57_000 kg", "has a thousands separator", "write the number without it, \"57000 kg\""},
      {"1,234,567 kg", "has a thousands separator", "write the number without it, \"1234567 kg\""},
      {"1.234.567 kg", "has a thousands separator", "write the number without it, \"1234567 kg\""},
      {"-1,234.5 kg", "has a thousands separator", "write the number without it, \"-1234.5 kg\""},
      {"1.234,5 kg", "has a thousands separator", "write the number without it, \"1234.5 kg\""},
      {"57 000,5 kg", "has a thousands separator", "write the number without it, \"57000.5 kg\""},
      {"57,000 kg", "has a thousands separator or a decimal comma",
       "write \"57000 kg\", or \"57.000 kg\" if the comma is decimal"},
      {"3,5 kg", "has a comma in its number", "the decimal sign is a point: write \"3.5 kg\""},
      {"0,500 kg", "has a comma in its number", "the decimal sign is a point: write \"0.500 kg\""},
  };
  for (const Case& each : cases) {
    const ParsedQuantity parsed = parseQuantity(each.text, kMass);
    EXPECT_FALSE(parsed.si.has_value()) << each.text;
    EXPECT_EQ(parsed.message, each.message) << each.text;
    EXPECT_EQ(parsed.remedy, each.remedy) << each.text;
  }
  EXPECT_EQ(parseQuantity("57.000 kg", kMass).si, 57.0);
  EXPECT_EQ(parseQuantity("1e3 kg", kMass).si, 1000.0);
}

// A capital letter too many must not make a wavelength of 5 mm one of 5000 km.
TEST(ParseQuantity, RefusesPrefixesThatNobodyMeans) {
  for (const char* text : {"5 Mm", "5 Gm"}) EXPECT_FALSE(parseQuantity(text, kLength).si.has_value()) << text;
  for (const char* text : {"5 ks", "5 Ms", "5 Gs"}) EXPECT_FALSE(parseQuantity(text, kTime).si.has_value()) << text;
  for (const char* text : {"5 krad", "5 Mrad", "5 Grad"}) EXPECT_FALSE(parseQuantity(text, kAngle).si.has_value()) << text;
}

}  // namespace
}  // namespace vehicle
