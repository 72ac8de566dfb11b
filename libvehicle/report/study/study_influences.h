#pragma once

#include "libvehicle/model/bound_study.h"
#include "libvehicle/report/document/document.h"
#include "libvehicle/study/summary.h"

namespace vehicle::report {

/// What the factors do to the outputs of a study: for people a table an output, for other programs one of them all.
void addInfluences(const StudySummary& summary, const BoundStudy& bound, Format format, Document& document);

}  // namespace vehicle::report
