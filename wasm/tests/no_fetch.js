// SPDX-License-Identifier: GPL-3.0-or-later
// Emscripten 3.1.6 takes Node's fetch for a browser's and asks it for a file name ("Failed to parse URL"). Without
// fetch it reads the module from the disk.
delete globalThis.fetch;
