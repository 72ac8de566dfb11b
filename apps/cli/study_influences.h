#pragma once

#include "apps/cli/document.h"
#include "libvehicle/model/bound_study.h"
#include "libvehicle/study/summary.h"

namespace vehicle::cli {

/// What the factors do to the outputs of a study: for people a table an output, for other programs one of them all.
void addInfluences(const StudySummary& summary, const BoundStudy& bound, Format format, Document& document);

}  // namespace vehicle::cli
