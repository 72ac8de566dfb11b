#include "libvehicle/report/document/document.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vehicle::report {
namespace {

Document sample() {
  Table table{"bodies", {{"body", ""}, {"mass", "kg"}, {"steps", ""}, {"fits", ""}}, {}};
  table.rows.push_back({std::string("carbody"), 57e3, 12L, true});
  table.rows.push_back({std::string("a \"b\", c"), 100.1 + 200.2, {}, false});
  return {{{"speed", 20.0, "m/s"}, {"vehicle", std::string("coach"), ""}},
          {table, {"empty", {{"x", ""}}, {}}},
          {"all well"}};
}

std::string printed(const Document& document, Format format) {
  std::ostringstream out;
  print(document, format, out);
  return out.str();
}

TEST(Document, TableIsAlignedWithHandyUnitsAndFiveDigits) {
  EXPECT_EQ(printed(sample(), Format::kTable),
            "speed    72 km/h\n"
            "vehicle  coach\n"
            "\n"
            "bodies\n"
            "  body      mass [t]  steps  fits\n"
            "  carbody         57     12  yes\n"
            "  a \"b\", c    0.3003      -  no\n"
            "\n"
            "all well\n");
}

TEST(Document, CsvHoldsTheTablesAndEveryBit) {
  EXPECT_EQ(printed(sample(), Format::kCsv),
            "body,mass [kg],steps,fits\ncarbody,57000,12,true\n\"a \"\"b\"\", c\",300.29999999999995,,false\n");
}

TEST(Document, JsonHoldsAllAndNullWhereThereIsNoNumber) {
  Document document = sample();
  document.tables[0].rows[0][1] = std::numeric_limits<double>::infinity();
  const nlohmann::json read = nlohmann::json::parse(printed(document, Format::kJson));
  EXPECT_EQ(read["facts"]["speed"]["value"], 20.0);
  EXPECT_EQ(read["facts"]["speed"]["unit"], "m/s");
  EXPECT_EQ(read["tables"]["bodies"]["units"]["mass"], "kg");
  EXPECT_TRUE(read["tables"]["bodies"]["rows"][0]["mass"].is_null());
  EXPECT_EQ(read["tables"]["bodies"]["rows"][1]["mass"].get<double>(), 100.1 + 200.2);
  EXPECT_TRUE(read["tables"]["empty"]["rows"].empty());
  EXPECT_EQ(read["remarks"][0], "all well");
}

TEST(Document, BytesThatAreNoUtf8DoNotBreakTheJson) {
  Document document;
  document.facts = {{"file", std::string("\xff.xml"), ""}};
  EXPECT_TRUE(nlohmann::json::accept(printed(document, Format::kJson)));
}

TEST(Document, MinusZeroIsZeroForTheEye) {
  Document document;
  document.facts = {{"difference", -0.0, "m"}};
  EXPECT_EQ(printed(document, Format::kTable), "difference  0 m\n");
}

}  // namespace
}  // namespace vehicle::report
