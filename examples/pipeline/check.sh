#!/bin/sh
# What every pipeline runs, and what you can run at your desk. It writes nothing but the results.
set -eu
cd "$(dirname "$0")"
# The emitted files are those of the parameters; if not, the lines that differ are shown.
axgen generate axes.toml --out generated --diff
# Every engine gives the bits of the reference.
axgen verify axes.toml --samples 10000 --junit verify.xml
# The outputs are those that were approved.
axgen golden verify golden/x --junit golden.xml
