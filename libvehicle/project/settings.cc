#include "libvehicle/project/settings.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/definition/parameter.h"

namespace vehicle {

namespace {

std::string trimmed(const std::string& text) {
  constexpr const char* kSpaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpaces);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
}

/// As the command line has it, on one line.
std::string asOption(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return fmt::format("--set \"{}\"", text);
}

bool has(const Vehicle&, const std::string&) { return true; }
bool has(const Scenario& scenario, const std::string& address) { return address != "speed" || wheelsRoll(scenario); }

}  // namespace

Settings::Settings(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    const std::size_t equal = std::min(text.find('='), text.size());
    Given given{{trimmed(text.substr(0, equal)), trimmed(text.substr(std::min(equal + 1, text.size())))},
                asOption(text)};
    const Place place{given.shown, 0};
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const Given& each) {
      return each.setting.address == given.setting.address && !given.setting.address.empty();
    });
    if (given.setting.address.empty() || given.setting.value.empty()) {
      given.problems.add(place, "", given.setting.address.empty() ? "names no parameter" : "gives no value",
                         "write PART.ATTRIBUTE=VALUE with its unit, e.g. --set \"secondary.stiffness_z=600 kN/m\"");
    } else if (same != all_.end()) {
      given.problems.add(place, "", fmt::format("{} is set already, by {}", given.setting.address, same->shown),
                         "set it once");
    }
    all_.push_back(std::move(given));
  }
}

template <class Owner>
void Settings::applyTo(Owner& owner) {
  if (all_.empty()) return;
  const std::vector<ParameterOf<Owner>> parameters = parametersOf(owner);
  for (const ParameterOf<Owner>& each : parameters) addresses_.push_back(each.address);
  Owner changed = owner;
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    Given& given = all_[i];
    const ParameterOf<Owner>* parameter = findParameter(parameters, given.setting.address);
    if (parameter == nullptr || !has(owner, given.setting.address)) continue;
    given.is_found = true;
    if (given.setting.value.empty()) continue;
    const ParsedQuantity value = parseQuantity(given.setting.value, parameter->dimension);
    if (!value.si) {
      given.problems.addNew({given.shown, 0}, "", fmt::format("\"{}\" {}", given.setting.value, value.message),
                            value.remedy);
    } else if (given.problems.empty()) {
      parameter->setIn(changed, *value.si);
      taken.push_back(i);
    }
  }
  if (taken.empty()) return;
  if (check(changed).empty()) {
    owner = std::move(changed);
  } else {
    judge(owner, changed, taken);
  }
}

void Settings::apply(Vehicle& vehicle) { applyTo(vehicle); }

void Settings::apply(Scenario& scenario) {
  has_scenario_ = true;
  applyTo(scenario);
}

/// Lays what is wrong with a definition at the settings that make it so by themselves, or else at all that it took.
template <class Owner>
void Settings::judge(const Owner& before, const Owner& after, const std::vector<std::size_t>& taken) {
  const std::vector<ParameterOf<Owner>> parameters = parametersOf(before);
  std::vector<ProblemList> alone;
  std::string shown;
  for (const std::size_t i : taken) {
    Owner changed = before;
    const ParameterOf<Owner>& parameter = *findParameter(parameters, all_[i].setting.address);
    parameter.setIn(changed, *parameter.valueIn(after));
    alone.push_back(check(changed));
    shown += (shown.empty() ? "" : ", ") + all_[i].shown;
  }
  for (const Problem& problem : check(after)) {
    bool is_of_one = false;
    for (std::size_t k = 0; k < taken.size(); ++k) {
      if (!alone[k].contains(problem)) continue;
      is_of_one = true;
      Given& given = all_[taken[k]];
      given.problems.addNew({given.shown, 0}, problem.element, problem.message, problem.remedy);
    }
    if (!is_of_one) of_several_.addNew({shown, 0}, problem.element, problem.message, problem.remedy);
  }
}

void Settings::refuse(std::string_view address, const std::string& message, const std::string& remedy) {
  for (Given& each : all_) {
    if (each.setting.address == address) each.problems.addNew({each.shown, 0}, "", message, remedy);
  }
}

std::vector<Setting> Settings::all() const {
  std::vector<Setting> settings;
  for (const Given& each : all_) settings.push_back(each.setting);
  return settings;
}

Problem Settings::unknown(const Given& given) const {
  const std::string& address = given.setting.address;
  const bool is_speed = address == "speed";
  if ((is_speed || address.starts_with("scenario.")) && !has_scenario_) {
    return {{given.shown, 0},
            "",
            fmt::format("{} is of a scenario, and none is read here", address),
            address == "scenario.gravity" ? "omit it; info and modes take --gravity" : "omit it"};
  }
  if (is_speed) return {{given.shown, 0}, "", "has no effect: no wheel rolls on a rig with a duration", "omit it"};
  Problem problem = unknownParameter(address, addresses_);
  problem.place.file = given.shown;
  return problem;
}

ProblemList Settings::problems() const {
  ProblemList all;
  for (const Given& each : all_) {
    all.append(each.problems);
    if (each.problems.empty() && !each.is_found) all.add(unknown(each));
  }
  all.append(of_several_);
  return all;
}

void Settings::requireRight() const {
  const ProblemList all = problems();
  if (all.empty()) return;
  std::string lines;
  for (const Problem& each : all) {
    lines += fmt::format("{}{}: {}{}{}; {}", lines.empty() ? "" : "\n", each.place.file, each.element,
                         each.element.empty() ? "" : ": ", each.message, each.remedy);
  }
  throw std::invalid_argument(lines);
}

std::vector<InputFile> keptSettings(const Settings& settings) {
  std::vector<std::string> lines;
  for (const Setting& each : settings.all()) lines.push_back(each.address + '=' + each.value + '\n');
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& each : lines) text += each;
  if (text.empty()) return {};
  return {{kSettingsName, text}};
}

Settings settingsIn(const std::vector<InputFile>& kept) {
  std::vector<std::string> lines;
  for (const InputFile& each : kept) {
    if (each.name != kSettingsName) continue;
    std::istringstream text(each.text);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }
  return Settings(lines);
}

}  // namespace vehicle
