#!/usr/bin/env bash
# Generates the blocks of axes.toml and runs them together with the glue in the strict engine, cycle by cycle, with test doubles of
# the motion library (folder stubs). Says what differs from the reference and from the schedule, and which planted mistakes are found.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec cargo test --locked -p axgen-tests --test glue -- --nocapture
