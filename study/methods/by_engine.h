// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "pipeline/engrave.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// Returns the spot's request with the published steps [Papp 2022], without the greatest depth of our defaults.
EngraveRequest publishedRequest(const StudyPlacement& spot, ModulePattern modules, FinderPattern finders);

/// Carves a spot with the program itself: by its own methods, by the published steps of Papp 2022, or by a search of
/// the study on the light that the program measures.
/// @param request     the spot's, with other depths, patterns or symbols of the same size; the place stays
/// @param symbol      carved instead of the request's, of the same size; null: the request's
/// @param makeSearch  see CarveJob::Known; empty: the request's search
Result<CarvedCode> carveByEngine(const StudyPlacement& spot, const EngraveRequest& request,
                                 const Symbol* symbol = nullptr, MakeSearch makeSearch = nullptr);

}  // namespace qrelief::study
