// SPDX-License-Identifier: GPL-3.0-or-later
// The `qrelief` command. The README is the contract for its options.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/version.h"
#include "cli/commands.h"
#include "message_codes/command.h"
#include "message_codes/model.h"
#include "messages/sentences.h"

namespace qrelief {

int exitStatusOf(ErrorKind code) {
  switch (code) {
    case ErrorKind::BadUsage:
      return kBadUsage;
    case ErrorKind::BadInput:
      return kBadInput;
    case ErrorKind::NoSolution:
      return kNoSolution;
    case ErrorKind::Internal:
      break;
  }
  return kInternalError;
}

namespace {

struct FileUnit {
  const char* name;
  double mm;
};
constexpr FileUnit kUnits[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}, {"ft", 304.8}, {"um", 0.001}};

void print(const char* severity, std::string_view file, const Message& message) {
  fmt::print(stderr, "qrelief: {}: {}{}{}\n", severity, file, file.empty() ? "" : ": ", sentence(message));
  if (const std::string helps = hint(message); !helps.empty()) fmt::print(stderr, "  hint: {}\n", helps);
}

}  // namespace

int printError(const Error& error, std::string_view file) {
  print("error", error.kind == ErrorKind::BadUsage ? std::string_view() : file, error.message);
  return exitStatusOf(error.kind);
}

void printWarning(const Message& message, std::string_view file) { print("warning", file, message); }

void printNote(const Message& message) { print("note", {}, message); }

Wording commandWording() {
  return {[](const Message& message) { return sentence(message); },
          [](const Message& message) { return hint(message); }};
}

namespace {

/// Returns a remedy's changes as flags, in brackets; empty if it changes no setting.
std::string changesInFlags(const Remedy& remedy) {
  std::string flags;
  for (const auto& [setting, value] : remedy.changes) {
    if (!flags.empty()) flags += ' ';
    flags += value.empty() ? "without " + flagOf(setting) : fmt::format("{} {}", flagOf(setting), value);
  }
  return flags.empty() ? flags : fmt::format(" ({})", flags);
}

}  // namespace

int printFailed(const Verdict& verdict) {
  for (const Message& failure : verdict.failed()) {
    fmt::print(stderr, "qrelief: check failed: {}\n", sentence(failure));
    if (const std::string helps = hint(failure); !helps.empty()) fmt::print(stderr, "  hint: {}\n", helps);
  }
  for (const Aspect* aspect : {&verdict.solid, &verdict.reads, &verdict.prints})
    for (const Remedy& remedy : aspect->passed() ? std::vector<Remedy>() : aspect->remedies)
      fmt::print(stderr, "  may help: {}{}\n", sentence(remedy.message), changesInFlags(remedy));
  return verdict.passed() ? kEngraved : kCheckFailed;
}

std::vector<std::string> unitNames() {
  std::vector<std::string> names;
  for (const auto& [name, mm] : kUnits) names.emplace_back(name);
  return names;
}

Result<std::optional<double>> scaleFrom(std::optional<double> scale, const std::string& units) {
  for (const auto& [name, mm] : kUnits)
    if (units == name) return mm;
  if (scale && !(*scale > 0 && *scale < 1e12))
    return fail(ErrorKind::BadUsage, message<"scale-not-positive">(with::number<"scale">(*scale)));
  return scale;
}

namespace {

/// Keeps some freed memory for the next stage. Otherwise the C library returns every large buffer to the system, which
/// must clear the pages of the next one.
void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kMost = 32 << 20;  // bytes, the most that glibc takes as a threshold for large buffers
  mallopt(M_MMAP_THRESHOLD, kMost);
  mallopt(M_TRIM_THRESHOLD, kMost);
#endif
}

/// Opens the standard streams that the caller has closed. Otherwise the next file opened would get their number, and
/// messages would be written into it.
void openStandardStreams() {
  for (int stream = 0; stream < 3; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDWR);  // takes the lowest number that is free
}

/// Returns the exit status, with a message if the results could not be printed.
int finished(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  const int printed =
      printError({ErrorKind::BadInput, message<"file-not-written">(with::term<"path">("The output"),
                                                                   with::term<"why">(std::strerror(errno)))});
  return status == kEngraved ? printed : status;
}

int run(int argc, char** argv) {
  CLI::App app("Engraves a QR code into a 3D model, just deep enough for a phone to read it by its shadow.", "qrelief");
  app.set_version_flag("--version", std::string("qrelief ") + kVersion);
  app.require_subcommand(1);
  const auto engraveModel = addEngraveCommand(app);
  const auto engraveList = addBatchCommand(app);
  const auto describeModel = addInfoCommand(app);
  const auto findSpots = addPlaceCommand(app);
  const auto verifyModel = addVerifyCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-') {
      fmt::print(stderr, "There is no command {}\nRun with --help for more information.\n", argv[1]);
      return kBadUsage;
    }
    return app.exit(error) == 0 ? kEngraved : kBadUsage;
  }
  if (app.got_subcommand("engrave")) return engraveModel();
  if (app.got_subcommand("batch")) return engraveList();
  if (app.got_subcommand("verify")) return verifyModel();
  return app.got_subcommand("place") ? findSpots() : describeModel();
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  try {
    qrelief::keepFreedMemory();
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the user's limit (ulimit -f) then fails like one on a full disk
#endif
    qrelief::openStandardStreams();
    return qrelief::finished(qrelief::run(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fputs("qrelief: error: there is not enough memory for this model\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "qrelief: error: internal: %s\n", error.what());
  }
  return qrelief::kInternalError;
}
