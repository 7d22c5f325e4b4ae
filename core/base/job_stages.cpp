// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/job_stages.h"

#include "message_codes/pipeline.h"

namespace qrelief {

tl::unexpected<Error> advancedAfterDone() { return fail(ErrorKind::Internal, message<"advance-after-done">()); }

}  // namespace qrelief
