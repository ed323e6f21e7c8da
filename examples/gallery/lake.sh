#!/usr/bin/env bash
# A polygon with holes, a lake with its islands, becomes quads on the command line; Gmsh and others open the file.
# Needs the package alone.
set -euo pipefail
shapes=$(dirname "$0")/../shapes

quadloom quadrangulate "$shapes/lake.geojson" -o lake.msh --picture lake.svg
quadloom check lake.msh --source "$shapes/lake.geojson"
