#!/usr/bin/env bash
# Remakes the pictures of docs/gallery.md, docs/scans.md and docs/papers.md: docs/make_gallery.sh BIN [NAME] (./dev gallery calls it). The
# commands are those of the pages themselves: this runs their sh blocks, in order. NAME: only pictures whose file name contains it.
# Scans and meshes come from ISOLUX_DATA, else ../shared/data; pictures whose data is missing are left as they are.
set -euo pipefail
bin=$(realpath "$1")
only=${2:-}
cd "$(dirname "${BASH_SOURCE[0]}")"
found=$(realpath -m "${ISOLUX_DATA:-../../shared/data}")
pictures=$PWD/gallery
mkdir -p "$pictures"

# Drawn beside a link to the data, so that the sessions in the pictures name no folder of this machine.
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
ln -s "$found" "$work/data"
export ISOLUX_DATA=data

isolux() {  # what the page's commands call
  local argument out="${*: -1}"
  [[ $out == *"$only"* ]] || return 0
  for argument in "$@"; do
    argument=${argument#source.csg_path=}
    if [[ $argument == data/* && ! -e $argument ]]; then
      echo "make_gallery.sh: $out is left as it is: ${argument#data/} is missing in $found" >&2
      return 0
    fi
  done
  echo "$out"
  "$bin" "$@" 2> >(grep -v '^isolux: note: ' >&2)
  mv "$out" "$pictures/"
}

blocks=$(awk '/^```sh$/ {inside = 1; next} /^```$/ {inside = 0} inside' gallery.md scans.md papers.md)
cd "$work"
eval "$blocks"
