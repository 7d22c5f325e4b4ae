# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by scripts of several parts. section NAME prints the name of the next part and how long the script has run.
section() { printf '\n==== %s (after %d s)\n' "$*" "$SECONDS"; }
