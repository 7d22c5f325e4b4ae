// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/requested_symbol.h"

#include "label/label_layout.h"
#include "settings/engrave_request.h"

namespace qrelief {

Result<Symbol> requestedSymbol(const CodeRequest& code) {
  if (!code.isText()) return encodeSymbol(code.text, code.symbol);
  Symbol blank = blankSymbol();
  QRELIEF_TRY(layOutLabel(code.lettering(), blank.size));
  return blank;
}

}  // namespace qrelief
