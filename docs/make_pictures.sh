#!/usr/bin/env bash
# Remakes the pictures of the README and the pages: docs/make_pictures.sh BIN_FOLDER (./dev screenshots calls it).
# Pictures of scans need the test data (ISOLUX_DATA, else ../shared/data); without it those are left as they are.
set -euo pipefail
bin=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
data=${ISOLUX_DATA:-../shared/data}
out=docs/images
mkdir -p "$out"

screen() {
  if [ -n "${DISPLAY:-}" ]; then "$bin/isolux_screenshot" "$@"; else
    xvfb-run -a -s "-screen 0 1920x1200x24" "$bin/isolux_screenshot" "$@"; fi
}

[ -d "$data/volumes" ] || echo "make_pictures.sh: no test data: pictures of scans are left as they are" >&2

# One picture for each page of the guide and for the end of each tutorial.
mkdir -p "$out/guide" "$out/start"
guide() { # NAME [OPTIONS...] PATH
  local name=$1
  shift
  screen --out "$out/guide/$name.png" --size 1280x800 "$@"
}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
"$bin/isolux" phantom head --size 192 --out "$work/large.mha"
"$bin/isolux" index "$work/large.mha"
guide large-data --set source.level=2 --panel volume "$work/large.mha"
guide window phantom:head:96
guide export --preset ct_bone --entry "Save image" phantom:head:96
guide sessions --preferences phantom:head:64
if [ -d "$data/volumes" ]; then
  skull="$data/volumes/ct_cranium.mhd"
  guide open --panel volume --notes "$data/dicom/ct_head_64"
  bone=(--set isosurface.value=300 --set pieces.within=-200)
  guide surfaces --preset ct_skin_bone "$skull"
  guide looks --panel looks --set isosurface.value=-300 --set look.mode=mean_curvature "$skull"
  guide slices --slices --set isosurface.value=-300 "$skull"
  guide clip "${bone[@]}" --set "clip.planes=122,122,105 0,0,1" --set camera.eye=360,500,480 --set camera.target=122,122,75 \
    --find clip "$skull"
  guide light "${bone[@]}" --set look.mode=gi --set light.environment.builtin=sunset --light-at 42 --find environment "$skull"
  guide compare --set pieces.keep=1 --set "color.volume=$data/volumes/mri_colin27.nii.gz" --set color.below=6 --set isosurface.value=43 \
    --find color "$data/volumes/mri_colin27.nii.gz"
  # A segmentation with names beside it (torsoLabel.nii.gz of niivue's demos); left as it is where there is none.
  [ -z "${ISOLUX_LABELS:-}" ] || guide labels --panel labels --set look.mode=gi "$ISOLUX_LABELS"
  guide accuracy --panel accuracy --errors depth "${bone[@]}" "$skull"
  guide measure --panel marks "${bone[@]}" --set "marks.list=$(cat docs/images/guide/measure.json)" "$skull"
fi
isolux=$bin/isolux
"$isolux" render phantom:head --preset ct_skin_bone --set picture.letters=true --set picture.scale_bar=true --set picture.isovalue=true \
  --size 800x600 --out "$out/start/clinician.png"
"$isolux" render phantom:head:96 --isovalue 360 --set pieces.keep=1 --set "clip.planes=0,0,20 0,0,1" --set clip.cap=inside \
  --elevation 35 --azimuth 25 --size 800x600 --out "$out/start/engineer.png"
"$isolux" render phantom:gyroid:48 --look gaussian_curvature --azimuth 30 --size 800x600 --out "$out/start/simulation.png"
(cd "$work" && sed -n '/^```python$/,/^```$/p' "$OLDPWD/docs/start/python.md" | grep -v '^```' > python.py &&
  PYTHONPATH=$bin/../python MPLBACKEND=agg /usr/bin/python3 python.py && mv python.png "$OLDPWD/$out/start/python.png")

# The studies of docs/records; without gnuplot their plots are left as they are.
study() {
  local name=$1
  shift
  "$bin/isolux" study "$@" --out "$out/accuracy/$name"
  rm "$out/accuracy/$name/study.json"
}
mkdir -p "$out/accuracy"
surface=(--repeat 15 --knobs rate,near_factor,near_threshold,refinements,method,hit_field,derivatives_field,fetch,supersampling,shadow)
study head phantom:head "${surface[@]}"
study gyroid phantom:gyroid:128 "${surface[@]}"
if [ -d "$data/volumes" ]; then
  study ct "$data/volumes/ct_head_skin_bone.nii.gz" --isovalue 0.51 "${surface[@]}"
  light=(--repeat 4 --size 128x128 --set light.environment.file="$data/hdr/grace_cathedral_1k.hdr" --knobs
    samples,sequence,environment_share,bounces,lattice_scale,texels,precision,interpolation,sh_order,sh_window,components,component_bits)
  study light_head phantom:head "${light[@]}"
  study light_engine "$data/volumes/engine_crop.mhd" --isovalue 80 "${light[@]}"
  study light_ct "$data/volumes/ct_head_skin_bone.nii.gz" --isovalue 0.51 "${light[@]}"
fi
