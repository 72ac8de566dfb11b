#include "libvehicle/definition/study.h"
#include "libvehicle/definition/wrong_lines.h"

namespace vehicle {

Study soundPartOf(const Study& study, const ProblemList& problems) {
  const WrongLines wrong(problems);
  Study sound = study;
  wrong.eraseFrom(sound.varies);
  for (StudyDesign& design : sound.designs) wrong.eraseFrom(design.sets);
  wrong.eraseFrom(sound.designs);
  wrong.eraseFrom(sound.metrics);
  wrong.eraseFrom(sound.objectives);
  wrong.eraseFrom(sound.limits);
  return sound;
}

}  // namespace vehicle
