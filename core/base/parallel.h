// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#ifndef __EMSCRIPTEN__
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>
#endif

namespace qrelief {

/// Calls work(0) … work(count - 1) once each on all cores. In the browser, which has one thread, calls them in turn.
///
/// The calls may run at the same time and in any order. Each must write only to a place of its own, so that the result
/// does not depend on the number of cores. Of several exceptions the one with the lowest index is thrown; calls with
/// higher indices may then be left out. Cost: starting a thread takes some 20 µs; a call should take longer.
template <class Index, class Work>
void parallelFor(Index count, const Work& work) {
#ifdef __EMSCRIPTEN__
  for (Index i = 0; i < count; ++i) work(i);
#else
  std::atomic<Index> next{0};
  std::vector<std::exception_ptr> thrown(count);
  const auto takeTurns = [&] {
    for (Index i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        thrown[i] = std::current_exception();
      }
  };
  const Index helpers = std::min<Index>(count, std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> threads;
  try {
    for (Index i = 1; i < helpers; ++i) threads.emplace_back(takeTurns);
  } catch (const std::system_error&) {
    // No more threads are available; those already running do the work.
  }
  takeTurns();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
#endif
}

/// Calls work(0) … work(count - 1) as parallelFor() does, `aPiece` at a time: for calls that take less than a thread's
/// start.
template <class Work>
void parallelForPieces(std::size_t count, std::size_t aPiece, const Work& work) {
  parallelFor((count + aPiece - 1) / aPiece, [&](std::size_t piece) {
    const std::size_t end = std::min(count, (piece + 1) * aPiece);
    for (std::size_t i = piece * aPiece; i < end; ++i) work(i);
  });
}

}  // namespace qrelief
