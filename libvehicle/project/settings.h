#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/run_record.h"

namespace vehicle {

/// A number that takes the place of a file's: "secondary.stiffness_z=600 kN/m".
struct Setting {
  std::string address;  // as in studies (definition/parameter.h)
  std::string value;    // with its unit, as it was given
};

/// The settings of a command line, --set, on their way into the definitions that its files hold.
///
/// Every definition is passed to apply() when it has been read without problems. It takes the values whose addresses it
/// has, as if its file gave them: the same bits, judged by the same check(). A train takes them as one vehicle:
/// "coach_2.carbody.mass". What is wrong is collected, of all settings at once, and requireRight() throws it when all
/// files have been read; until then a definition keeps its own values where a setting of it is wrong.
class Settings {
 public:
  Settings() = default;
  /// @param texts  "ADDRESS=VALUE"; what is none is reported by problems()
  explicit Settings(const std::vector<std::string>& texts);

  void apply(Vehicle& vehicle);
  void apply(Scenario& scenario);
  /// Adds a problem of the setting of that address, if there is one.
  void refuse(std::string_view address, const std::string& message, const std::string& remedy);

  [[nodiscard]] bool empty() const { return all_.empty(); }
  /// In the order given.
  [[nodiscard]] std::vector<Setting> all() const;

  /// Everything that is wrong, in the order given; places are the options. Addresses that none of the definitions has
  /// are among it.
  [[nodiscard]] ProblemList problems() const;
  /// @throws std::invalid_argument  with all problems, a line each
  void requireRight() const;

 private:
  struct Given {
    Setting setting;
    std::string shown;  // --set "carbody.mass=57 t"
    bool is_found = false;
    ProblemList problems = {};
  };

  template <class Owner>
  void applyTo(Owner& owner);
  template <class Owner>
  void judge(const Owner& before, const Owner& after, const std::vector<std::size_t>& taken);
  [[nodiscard]] Problem unknown(const Given& given) const;

  std::vector<Given> all_;
  ProblemList of_several_;              // what no setting does by itself
  std::vector<std::string> addresses_;  // of all definitions so far
  bool has_scenario_ = false;
};

/// The name under which a study's database keeps its settings beside the input files, "ADDRESS=VALUE" a line.
inline constexpr const char* kSettingsName = "--set";

/// What a database keeps; nothing of no settings. Their order is no matter.
[[nodiscard]] std::vector<InputFile> keptSettings(const Settings& settings);
/// The settings among what a database keeps.
[[nodiscard]] Settings settingsIn(const std::vector<InputFile>& kept);

}  // namespace vehicle
