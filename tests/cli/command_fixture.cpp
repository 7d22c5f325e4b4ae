// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_fixture.h"

#include <cstdlib>
#include <sys/wait.h>

namespace qrelief {

Outcome CommandTest::run(const std::vector<std::string>& arguments, const std::string& redirections) const {
  std::string line = "'" QRELIEF_COMMAND "'";
  for (const std::string& argument : arguments) line += " '" + argument + "'";
  line += " >'" + path("stdout") + "' 2>'" + path("stderr") + "' " + redirections;
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(path("stdout")), contentOf(path("stderr"))};
}

}  // namespace qrelief
