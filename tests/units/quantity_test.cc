#include "libvehicle/units/quantity.h"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

using enum Dimension;

const std::vector<Dimension> kAll = {kNumber,  kLength,  kTime,      kSpeed,   kAcceleration,        kMass,
                                     kInertia, kForce,   kStiffness, kDamping, kRotationalStiffness, kRotationalDamping,
                                     kHertzConstant, kAngle, kAngularVelocity, kFrequency, kAngularAcceleration};

double si(const std::string& text, Dimension dimension) {
  const ParsedQuantity parsed = parseQuantity(text, dimension);
  EXPECT_TRUE(parsed.si.has_value()) << text << " " << parsed.message << "; " << parsed.remedy;
  return parsed.si.value_or(std::nan(""));
}

std::string refusal(const std::string& text, Dimension dimension) {
  const ParsedQuantity parsed = parseQuantity(text, dimension);
  EXPECT_FALSE(parsed.si.has_value()) << text;
  return parsed.message + "; " + parsed.remedy;
}

// Every expected value below is written as the quotient or product of whole numbers that it is; EXPECT_EQ on
// doubles is meant: a correctly rounded reader has no other answer.
TEST(ParseQuantity, PrefixesAreExactPowersOfTen) {
  EXPECT_EQ(si("9 mm", kLength), 9.0 / 1000.0);
  EXPECT_EQ(si("6.2 mm", kLength), 6.2e-3);
  EXPECT_EQ(si("0.1 mm", kLength), 1e-4);
  EXPECT_EQ(si("3 um", kLength), 3.0 / 1e6);
  EXPECT_EQ(si("3 \u00b5m", kLength), 3.0 / 1e6);
  EXPECT_EQ(si("3 \u03bcm", kLength), 3.0 / 1e6);
  EXPECT_EQ(si("7 nm", kLength), 7.0 / 1e9);
  EXPECT_EQ(si("7 cm", kLength), 7.0 / 100.0);
  EXPECT_EQ(si("7 dm", kLength), 7.0 / 10.0);
  EXPECT_EQ(si("2 km", kLength), 2000.0);
  EXPECT_EQ(si("3040 kN/m", kStiffness), 3040e3);
  EXPECT_EQ(si("2.4 GN/m", kStiffness), 2.4e9);
  EXPECT_EQ(si("3.04 MN/m", kStiffness), 3040e3);
  EXPECT_EQ(si("2 N/mm", kStiffness), 2000.0);
  EXPECT_EQ(si("1.2 mrad", kAngle), 1.2e-3);
}

TEST(ParseQuantity, SpeedsInKilometresPerHourAreRoundedOnce) {
  EXPECT_EQ(si("72 km/h", kSpeed), 20.0);
  EXPECT_EQ(si("110 km/h", kSpeed), 110.0 * 1000.0 / 3600.0);
  for (int kmh = 1; kmh <= 500; ++kmh) EXPECT_EQ(si(std::to_string(kmh) + " km/h", kSpeed), kmh * 1000.0 / 3600.0);
  EXPECT_EQ(si("0.1 km/h", kSpeed), 100.0 / 3600.0);
  EXPECT_EQ(si("3 m/min", kSpeed), 3.0 / 60.0);
  EXPECT_EQ(si("9.87 m/min", kSpeed), 987.0 / 6000.0);
}

TEST(ParseQuantity, OldTechnicalUnits) {
  EXPECT_EQ(si("1 tf", kForce), 9806.65);
  EXPECT_EQ(si("70 tf*m*s^2", kInertia), 686465.5);
  EXPECT_EQ(si("3 tf/m", kStiffness), 3.0 * 980665.0 / 100.0);
}

TEST(ParseQuantity, EveryDimensionReadsItsUsualUnits) {
  EXPECT_EQ(si("0.5", kNumber), 0.5);
  EXPECT_EQ(si("3", kNumber), 3.0);
  EXPECT_EQ(si("5 %", kNumber), 0.05);
  EXPECT_EQ(si("5 ms", kTime), 0.005);
  EXPECT_EQ(si("2 min", kTime), 120.0);
  EXPECT_EQ(si("1 h", kTime), 3600.0);
  EXPECT_EQ(si("9.81 m/s^2", kAcceleration), 9.81);
  EXPECT_EQ(si("57 t", kMass), 57e3);
  EXPECT_EQ(si("250 g", kMass), 0.25);
  EXPECT_EQ(si("1813 kg", kMass), 1813.0);
  EXPECT_EQ(si("70 t*m^2", kInertia), 70e3);
  EXPECT_EQ(si("120 kN", kForce), 120e3);
  EXPECT_EQ(si("30 kN*s/m", kDamping), 30e3);
  EXPECT_EQ(si("30 kg/s", kDamping), 30.0);
  EXPECT_EQ(si("940 kN*m/rad", kRotationalStiffness), 940e3);
  EXPECT_EQ(si("940 kN*m", kRotationalStiffness), 940e3);
  EXPECT_EQ(si("25 kN*m*s/rad", kRotationalDamping), 25e3);
  EXPECT_EQ(si("25 kN*m*s", kRotationalDamping), 25e3);
  EXPECT_EQ(si("93.7 GN/m^1.5", kHertzConstant), 93.7e9);
  EXPECT_EQ(si("180 deg", kAngle), std::numbers::pi);
  EXPECT_EQ(si("5.03 rad/s", kAngularVelocity), 5.03);
  EXPECT_EQ(si("1.1 Hz", kFrequency), 1.1);
}

TEST(ParseQuantity, UnitsAreProductsQuotientsPowersAndParentheses) {
  EXPECT_EQ(si("30 kN\u00b7s/m", kDamping), 30e3);
  EXPECT_EQ(si("30 kN/(m/s)", kDamping), 30e3);
  EXPECT_EQ(si("30 kN*s*m^-1", kDamping), 30e3);
  EXPECT_EQ(si("30 s*kN / m", kDamping), 30e3);
  EXPECT_EQ(si("9 m/s/s", kAcceleration), 9.0);
  EXPECT_EQ(si("9 m\u00b2*kg", kInertia), 9.0);
  EXPECT_EQ(si("9 (m/s)^2/m", kAcceleration), 9.0);
  // 10^4.5 is irrational: the last digit is the power function's.
  EXPECT_DOUBLE_EQ(si("1 N/mm^1.5", kHertzConstant), std::pow(10.0, 4.5));
}

TEST(ParseQuantity, SpacesSignsAndExponentsAreFree) {
  EXPECT_EQ(si("  -3.725 m ", kLength), -3.725);
  EXPECT_EQ(si("+3.725m", kLength), 3.725);
  EXPECT_EQ(si("\t1e3\n mm", kLength), 1.0);
  EXPECT_EQ(si("1E-3 m", kLength), 1e-3);
  EXPECT_EQ(si(".5 m", kLength), 0.5);
  EXPECT_EQ(si("5. m", kLength), 5.0);
  EXPECT_EQ(si("0 m", kLength), 0.0);
  EXPECT_TRUE(std::signbit(si("-0 m", kLength)));
}

TEST(ParseQuantity, ADecimalCommaLocaleChangesNothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "C.UTF-8"}) std::setlocale(LC_ALL, name);
  EXPECT_EQ(si("1.5 m", kLength), 1.5);
  EXPECT_EQ(formatQuantity(1.5, kLength), "1.5 m");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ParseQuantity, SaysWhichKindOfQuantityStandsThereInstead) {
  EXPECT_EQ(refusal("30 kN/m", kDamping), "is a stiffness; a damping is expected, e.g. \"30 kN*s/m\"");
  EXPECT_EQ(refusal("5 mm", kAngle), "is a length; an angle is expected, e.g. \"1.2 mrad\"");
  EXPECT_EQ(refusal("5 Hz", kAngularVelocity), "is a frequency; an angular velocity is expected, e.g. \"5.03 rad/s\"");
  EXPECT_EQ(refusal("9 m/s^2", kSpeed), "is an acceleration; a speed is expected, e.g. \"72 km/h\"");
  EXPECT_EQ(refusal("57 tf", kMass), "is a force; a mass is expected, e.g. \"57 t\"");
  EXPECT_EQ(refusal("5 %", kLength), "is a plain number; a length is expected, e.g. \"3.725 m\"");
  EXPECT_EQ(refusal("3 m", kNumber), "is a length; a plain number is expected, e.g. \"3\"");
  EXPECT_EQ(refusal("9 kN*m", kForce), "has the unit \"kN*m\"; a force is expected, e.g. \"120 kN\"");
}

TEST(ParseQuantity, RefusesWhatIsNoNumber) {
  EXPECT_EQ(refusal("", kLength), "is empty; a length is expected, e.g. \"3.725 m\"");
  EXPECT_EQ(refusal(" \n", kLength), "is empty; a length is expected, e.g. \"3.725 m\"");
  for (const char* text :
       {"m", "abc m", "--3 m", "- 3 m", ". m", "1.2.3 m", "1, m", "1-2 m", "e3 m", "\u22123 m"}) {
    EXPECT_EQ(refusal(text, kLength), "is not a number; a length is expected, e.g. \"3.725 m\"") << text;
  }
  EXPECT_EQ(refusal("1,5 m", kLength),
            "has a comma in its number; the decimal sign is a point: write \"1.5 m\"");
}

TEST(ParseQuantity, RefusesWhatIsNotFinite) {
  for (const char* text : {"nan", "NaN m", "inf m", "-inf m", "+Infinity m"}) {
    EXPECT_EQ(refusal(text, kLength), "is not finite; a length is expected, e.g. \"3.725 m\"") << text;
  }
  for (const char* text : {"1e999 m", "-1e999 m", "1e308 km", "1e99999999999999999999 m"}) {
    EXPECT_EQ(refusal(text, kLength), "is not finite; a number holds up to 1.8e308 in SI units") << text;
  }
  for (const char* text : {"1e-999 m", "1e-306 mm", "-1e-310 m", "1e-99999999999999999999 m"}) {
    EXPECT_EQ(refusal(text, kLength),
              "is too close to zero; a number holds down to 2.3e-308 in SI units; write 0 for none")
        << text;
  }
}

TEST(ParseQuantity, RefusesAMissingOrUnknownUnitAndNamesTheNearest) {
  const std::string length = "; a length is expected, e.g. \"3.725 m\"";
  EXPECT_EQ(refusal("3", kLength), "has no unit" + length);
  EXPECT_EQ(refusal("0", kLength), "has no unit" + length);
  EXPECT_EQ(refusal("3 furlong", kLength), "has the unknown unit \"furlong\"" + length);
  EXPECT_EQ(refusal("3 kM", kLength), "has the unknown unit \"kM\"" + length + "; did you mean \"3 km\"?");
  EXPECT_EQ(refusal("3 MM", kLength), "has the unknown unit \"MM\"" + length + "; did you mean \"3 mm\"?");
  const std::string damping = "; a damping is expected, e.g. \"30 kN*s/m\"";
  EXPECT_EQ(refusal("3 kNs/m", kDamping), "has the unknown unit \"kNs\"" + damping + "; did you mean \"3 kN*s/m\"?");
  EXPECT_EQ(refusal("3 KN*s/m", kDamping), "has the unknown unit \"KN\"" + damping + "; did you mean \"3 kN*s/m\"?");
  EXPECT_EQ(refusal("70 kmh", kSpeed),
            "has the unknown unit \"kmh\"; a speed is expected, e.g. \"72 km/h\"; did you mean \"70 km/h\"?");
  EXPECT_EQ(refusal("5 sec", kTime),
            "has the unknown unit \"sec\"; a time is expected, e.g. \"5 ms\"; did you mean \"5 s\"?");
}

TEST(ParseQuantity, RefusesAMalformedUnit) {
  const std::string end = "; a moment of inertia is expected, e.g. \"70 t*m^2\"";
  for (const char* unit : {"t*", "*t", "t**m", "t/", "t*(m", "t*m)", "t*m^", "t*m^x", "t^99", "((((((((((t))))))))))",
                           "()", "1/s", "t#m", "(((h^9)^9)^9)"}) {
    EXPECT_EQ(refusal(std::string("70 ") + unit, kInertia),
              "has the malformed unit \"" + std::string(unit) + "\"" + end);
  }
  EXPECT_EQ(refusal("70 t*m2", kInertia),
            "has the malformed unit \"t*m2\"" + end + "; did you mean \"70 t*m^2\"?");
  EXPECT_EQ(refusal("70 t m^2", kInertia),
            "has the malformed unit \"t m^2\"" + end + "; did you mean \"70 t*m^2\"?");
  EXPECT_EQ(refusal("7 " + std::string(100, '('), kInertia),
            "has the malformed unit \"" + std::string(32, '(') + "...\"" + end);
}

TEST(ParseQuantity, SurvivesEveryShortTextOfItsAlphabet) {
  const std::string alphabet = "1.e-+ mkts^*/()%,h";
  const std::size_t n = alphabet.size();
  for (std::size_t i = 0; i < n * n * n * n; ++i) {
    const std::string text = {alphabet[i % n], alphabet[i / n % n], alphabet[i / n / n % n], alphabet[i / n / n / n]};
    const ParsedQuantity parsed = parseQuantity(text, kLength);
    EXPECT_NE(parsed.si.has_value(), !parsed.message.empty()) << text;
    EXPECT_TRUE(std::isfinite(parsed.si.value_or(0.0))) << text;
  }
}

TEST(FormatQuantity, UsesTheCustomaryUnitWhereItIsShorter) {
  EXPECT_EQ(formatQuantity(3040e3, kStiffness), "3040 kN/m");
  EXPECT_EQ(formatQuantity(2.4e9, kStiffness), "2.4 GN/m");
  EXPECT_EQ(formatQuantity(30e3, kDamping), "30 kN*s/m");
  EXPECT_EQ(formatQuantity(57e3, kMass), "57 t");
  EXPECT_EQ(formatQuantity(1813.0, kMass), "1813 kg");
  EXPECT_EQ(formatQuantity(70e3, kInertia), "70 t*m^2");
  EXPECT_EQ(formatQuantity(686465.5, kInertia), "686.4655 t*m^2");
  EXPECT_EQ(formatQuantity(0.005, kLength), "5 mm");
  EXPECT_EQ(formatQuantity(-3.725, kLength), "-3.725 m");
  EXPECT_EQ(formatQuantity(0.005, kTime), "5 ms");
  EXPECT_EQ(formatQuantity(10.0, kTime), "10 s");
  EXPECT_EQ(formatQuantity(20.0, kSpeed), "20 m/s");
  EXPECT_EQ(formatQuantity(110.0 * 1000.0 / 3600.0, kSpeed), "110 km/h");
  EXPECT_EQ(formatQuantity(93.7e9, kHertzConstant), "93.7 GN/m^1.5");
  EXPECT_EQ(formatQuantity(1.2e-3, kAngle), "1.2 mrad");
  EXPECT_EQ(formatQuantity(std::numbers::pi / 2, kAngle), "90 deg");
  EXPECT_EQ(formatQuantity(0.0, kLength), "0 m");
  EXPECT_EQ(formatQuantity(0.0, kMass), "0 kg");
  EXPECT_EQ(formatQuantity(0.0, kStiffness), "0 kN/m");
  EXPECT_EQ(formatQuantity(-0.0, kLength), "-0 m");
  EXPECT_EQ(formatQuantity(3.0, kNumber), "3");
  EXPECT_EQ(formatQuantity(1e-3, kNumber), "0.001");
  EXPECT_EQ(formatQuantity(1.5e300, kNumber), "1.5e300");
}

TEST(FormatQuantity, RefusesWhatIsNotFinite) {
  EXPECT_THROW((void)formatQuantity(std::nan(""), kLength), std::invalid_argument);
  EXPECT_THROW((void)formatQuantity(std::numeric_limits<double>::infinity(), kLength), std::invalid_argument);
}

TEST(FormatQuantity, ReadsBackToTheSameBitsForEveryDimension) {
  std::mt19937_64 random(20240117);
  std::uniform_real_distribution<double> decade(-12.0, 12.0);
  for (const Dimension dimension : kAll) {
    for (int i = 0; i < 2000; ++i) {
      // Half of them any bit pattern, half of them of the size that parts of vehicles have.
      double value = std::bit_cast<double>(random());
      if (i % 2 == 0) value = std::pow(10.0, decade(random)) * (i % 4 == 0 ? 1.0 : -1.0);
      if (!std::isnormal(value)) continue;
      const std::string text = formatQuantity(value, dimension);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(si(text, dimension)), std::bit_cast<std::uint64_t>(value)) << text;
    }
  }
}

TEST(FormatQuantity, ReadsBackToTheSameBitsAtTheEdges) {
  using Limits = std::numeric_limits<double>;
  for (const Dimension dimension : kAll) {
    for (const double value : {0.0, -0.0, Limits::max(), Limits::lowest(), Limits::min(), -Limits::min(), 1.0, 0.1}) {
      const std::string text = formatQuantity(value, dimension);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(si(text, dimension)), std::bit_cast<std::uint64_t>(value)) << text;
    }
  }
}

TEST(Describe, ExamplesAndSiUnitsReadAsTheirOwnDimension) {
  for (const Dimension dimension : kAll) {
    const DimensionInfo& info = describe(dimension);
    (void)si(std::string(info.example), dimension);
    EXPECT_EQ(si("1 " + std::string(info.siUnit), dimension), 1.0) << info.name;
    for (const Dimension other : kAll) {
      EXPECT_EQ(parseQuantity(info.example, other).si.has_value(), other == dimension) << info.example;
    }
  }
}

}  // namespace
}  // namespace vehicle
