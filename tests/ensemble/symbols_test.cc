#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/ensemble/isa.h"

namespace vehicle::test {
namespace {

std::vector<std::string> linesOf(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<std::string> lines;
  std::array<char, 8192> line{};
  while (pipe && std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr) {
    lines.emplace_back(line.data());
  }
  return lines;
}

// A weak symbol of a kernel file may serve baseline code after linking, with instructions that the machine lacks. Only
// those may stay that no other file has: of the instruction set's own namespace, or made of SIMD types of its width.
TEST(Kernels, LeaveNoFunctionThatOtherCodeWouldLinkWith) {
  int kernels = 0;
  std::map<std::string, std::string> owners;  // of mergeable symbols
  std::string own;                            // namespace of the kernel file that is being read
  for (const std::string& line : linesOf(std::string(VEHICLE_NM) + " -C \"" VEHICLE_ENSEMBLE_LIBRARY "\"")) {
    const auto name = line.find("kernel_v");
    if (line.find(".o:") != std::string::npos) {
      own = name == std::string::npos ? "" : "vehicle::ensemble::" + line.substr(name + 7, 2) + "::";
      if (!own.empty()) ++kernels;
      continue;
    }
    if (own.empty() || line.size() < 20) continue;
    const char kind = line[17];
    const std::string symbol = line.substr(19);
    const bool mergeable = kind == 'W' || kind == 'V' || kind == 'u' || kind == 'w' || kind == 'v' || kind == 'T';
    // The pointer to the C++ runtime's own personality routine is data, and the same in every file.
    if (!mergeable || symbol.starts_with("DW.ref.__gxx_personality")) continue;
    EXPECT_TRUE(symbol.find(own) != std::string::npos || symbol.find("std::experimental::") != std::string::npos)
        << own << " holds " << line;
    const auto [first, is_new] = owners.emplace(symbol, own);
    EXPECT_TRUE(is_new || first->second == own) << own << " and " << first->second << " hold " << symbol;
  }
  EXPECT_EQ(kernels, 3);
}

TEST(Isa, IsNamedAndOrdered) {
  EXPECT_EQ(nameOf(Isa::kBaseline), "baseline");
  EXPECT_EQ(nameOf(Isa::kV3), "v3");
  EXPECT_EQ(nameOf(Isa::kV4), "v4");
  EXPECT_TRUE(supports(Isa::kBaseline));
  EXPECT_TRUE(supports(bestIsa()));
  EXPECT_LE(lanesOf(Isa::kBaseline), lanesOf(Isa::kV3));
  EXPECT_LE(lanesOf(Isa::kV3), lanesOf(Isa::kV4));
}

}  // namespace
}  // namespace vehicle::test
