#!/usr/bin/env bash
# Draws the images of docs/gallery.md and docs/explanation/papers.md: docs/make_gallery.sh BIN [NAME] (./dev gallery calls it).
# NAME: only images whose file name contains it. Scans and meshes are read from ISOLUX_DATA, else ../shared/data;
# images whose data are missing stay unchanged.
set -euo pipefail
bin=$(realpath "$1")
only=${2:-}
cd "$(dirname "${BASH_SOURCE[0]}")"
found=$(realpath -m "${ISOLUX_DATA:-../../shared/data}")
pictures=$PWD/gallery
mkdir -p "$pictures"

# Images are drawn beside a link to the data, so that their sessions name no folder of this machine.
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
ln -s "$found" "$work/data"

isolux() {
  local argument out="${*: -1}"
  [[ $out == *"$only"* ]] || return 0
  for argument in "$@"; do
    argument=${argument#source.csg_path=}
    if [[ $argument == data/* && ! -e $argument ]]; then
      echo "make_gallery.sh: $out is unchanged: ${argument#data/} is missing in $found" >&2
      return 0
    fi
  done
  echo "$out"
  "$bin" "$@" 2> >(grep -v '^isolux: note: ' >&2)
  mv "$out" "$pictures/"
}

cd "$work"

# ---- Pictures of docs/gallery.md

data=data
paper="--size 400x400 --set look.background_top=1,1,1 --set look.background_bottom=1,1,1 --set look.legend=false"
engine="$data/volumes/engine.nii.gz --isovalue 80 $paper
  --set camera.eye=-330,-370,215 --set camera.target=0,0,-9 --set camera.fov=26.5"
skull="$data/volumes/ct_head_skin_bone.nii.gz --isovalue 0.51 $paper
  --set camera.eye=370,-480,110 --set camera.target=4,4,-5 --set camera.fov=20.5"
head="$data/volumes/mri_colin27.nii.gz --isovalue 40 $paper
  --set camera.eye=240,-450,70 --set camera.target=0,17,20 --set camera.fov=23"
teapot="$data/volumes/teapot.mhd --isovalue 60 $paper
  --set camera.eye=180,-70,-390 --set camera.target=128,124,89 --set camera.up=0,-1,0 --set camera.fov=27"
above="--set camera.eye=70,-150,190 --set camera.target=0,0,0 --set camera.fov=23.5"
torus="phantom:torus $paper $above"
gyroid="phantom:gyroid $paper
  --set camera.eye=190,-250,170 --set camera.target=4,-6,2 --set camera.fov=18"
subjects="engine skull head teapot torus gyroid"

# Large
dark="--set look.background_top=0.045,0.05,0.06 --set look.background_bottom=0.004,0.004,0.006
  --set picture.supersampling=3 --set gi.samples=200 --set look.legend=false --set picture.caveats=false --zoom 0.95"

isolux render $data/volumes/ct_head_skin_bone.nii.gz $dark --size 1200x1440 --look gi --isovalue 0.2 --set isosurface.albedo=0.70,0.40,0.29 \
  --set isosurface2.shown=true --set isosurface2.value=0.51 --set isosurface2.opacity=1 --set isosurface2.albedo=0.86,0.78,0.62 \
  --set isosurface2.clipped=false --set clip.cap=none --set "clip.planes=3,0,0 1,0,0" --set pieces.smallest=1000 \
  --set light.environment.azimuth=110 --azimuth 8 --elevation -9 --out large_half_face.png

isolux render $data/volumes/bonsai.nii.gz $dark --size 1200x1200 --look gi --isovalue 38 --set pieces.keep=1 \
  --set color.volume=$data/volumes/bonsai.nii.gz --set color.below=5 --set color.map=spectral --set color.low=-20 --set color.high=170 \
  --set light.environment.azimuth=60 --azimuth 30 --elevation -3 --out large_bonsai.png

isolux render $data/volumes/heptane.nii.gz $dark --size 1200x1500 --look gi --isovalue 60 --environment sunset \
  --set isosurface.albedo=0.9,0.62,0.36 --set look.background_top=0.03,0.04,0.06 \
  --camera "0,-640,20 0,0,0 1,0,0 30" --azimuth 25 --elevation 10 --fit surface --out large_plume.png

isolux render $data/volumes/tooth.mhd $dark --size 1200x1440 --look shape_index --set look.shading=gi \
  --set light.environment.azimuth=40 --out large_tooth.png

isolux render $data/volumes/mri_colin27.nii.gz $dark --size 1200x1200 --look gi --set pieces.keep=1 --set "clip.planes=2,0,0 1,0,0" \
  --set isosurface.albedo=0.72,0.45,0.33 --set light.environment.azimuth=-20 --azimuth 32 --elevation -5 --out large_cut_head.png

# Without any option
for f in $data/volumes/*.nii.gz $data/volumes/*.mhd $data/mesh/*.obj $data/dicom/*; do
  n=$(basename ${f%%.[nmo]*}); isolux render $f --size 512x384 --out first_$n.png; done
for p in ball torus head gyroid sheets wires; do isolux render phantom:$p --size 512x384 --out first_$p.png; done

# Blinn-Phong
for s in $subjects; do isolux render ${!s} --look blinn_phong --out blinn_phong_$s.png; done

# Lambert with ambient light from above
sky="--set look.ambient=0.4 --set look.ambient_variation=0.8"

for s in $subjects; do isolux render ${!s} --look lambert $sky --out lambert_$s.png; done

# Tone
for s in $subjects; do isolux render ${!s} --look tone --out tone_$s.png; done

# Curvature
legend="${teapot/400x400/600x400} --set look.legend=true
  --set camera.eye=230,-70,-390 --set camera.target=178,124,89"
plain="engine skull head torus gyroid"

# κ₁, the larger principal curvature
for s in $plain; do isolux render ${!s} --look kappa1 --out kappa1_$s.png; done
isolux render $legend --look kappa1 --out kappa1_teapot.png

# κ₂, the smaller one
for s in $plain; do isolux render ${!s} --look kappa2 --out kappa2_$s.png; done
isolux render $legend --look kappa2 --out kappa2_teapot.png

# Mean curvature
for s in $plain; do isolux render ${!s} --look mean_curvature --out mean_curvature_$s.png; done
isolux render $legend --look mean_curvature --out mean_curvature_teapot.png

# Gaussian curvature
for s in $plain; do isolux render ${!s} --look gaussian_curvature --out gaussian_curvature_$s.png; done
isolux render $legend --look gaussian_curvature --out gaussian_curvature_teapot.png

# Shape index
for s in $plain; do isolux render ${!s} --look shape_index --out shape_index_$s.png; done
isolux render $legend --look shape_index --out shape_index_teapot.png

# Curvedness
for s in $plain; do isolux render ${!s} --look curvedness --out curvedness_$s.png; done
isolux render $legend --look curvedness --out curvedness_teapot.png

# Curvature in two dimensions
for s in $plain; do isolux render ${!s} --look curvature_2d --out curvature_2d_$s.png; done
isolux render $legend --look curvature_2d --out curvature_2d_teapot.png

# Accessibility
for s in $subjects; do isolux render ${!s} --look accessibility --out accessibility_$s.png; done

# Along the larger curvature
for s in $subjects; do isolux render ${!s} --look flow --set flow.direction=maximum --out flow_maximum_$s.png; done

# Along the smaller curvature
for s in $subjects; do isolux render ${!s} --look flow --set flow.direction=minimum --out flow_minimum_$s.png; done

# Raw quantities
isolux render $engine --look normal --out normal_engine.png
isolux render $torus --look normal --out normal_torus.png
isolux render $skull --look depth --out depth_skull.png

# Ridges and valleys
isolux render $engine --look lambert --set look.ambient=0.35 --set look.ridges=1 --out ridges_engine.png
isolux render $skull --look lambert --set look.ambient=0.35 --set look.ridges=1 --out ridges_skull.png
isolux render $teapot --look lambert --set look.ambient=0.35 --set look.ridges=1 --out ridges_teapot.png

# Contours
isolux render $engine --look tone --set look.contours=1 --out contours_engine.png
isolux render $torus --look tone --set look.contours=1 --out contours_torus.png
isolux render $gyroid --look tone --set look.contours=1 --out contours_gyroid.png

# Line drawing
drawing="--set isosurface.albedo=1,1,1 --set look.ambient=1 --set look.contours=1 --set look.suggestive_contours=1"

isolux render $engine --look lambert $drawing --out drawing_engine.png
isolux render $skull --look lambert $drawing --out drawing_skull.png
isolux render $teapot --look lambert $drawing --out drawing_teapot.png

# Hard shadow
isolux render $engine --set look.shadow=0.8 --set look.ambient=0.2 --set light.direction=-0.9,0.6,0.6 \
  --out shadow_engine.png
isolux render $skull --set look.shadow=0.8 --set look.ambient=0.2 --set light.direction=-0.9,0.6,0.6 \
  --out shadow_skull.png
isolux render $gyroid --set look.shadow=0.8 --set look.ambient=0.2 --set light.direction=-0.9,0.6,0.6 \
  --out shadow_gyroid.png

# Fog
isolux render $engine --set look.fog=1 --out fog_engine.png
isolux render $skull --set look.fog=1 --out fog_skull.png
isolux render $gyroid --set look.fog=1 --out fog_gyroid.png

# Solid textures
isolux render $head --set look.texture=marble --set isosurface.albedo=0.85,0.83,0.8 --out marble_head.png
isolux render $teapot --set look.texture=wood --set isosurface.albedo=0.6,0.33,0.14 --out wood_teapot.png
isolux render $torus --set look.texture=checker --out checker_torus.png

# Skin over bone
isolux render $data/volumes/ct_head_skin_bone.nii.gz --size 800x800 --isovalue 0.51 --set isosurface.name=Bone \
  --set isosurface.albedo=0.86,0.79,0.64 --set isosurface2.shown=true --set isosurface2.value=0.2 \
  --set isosurface2.name=Skin --set isosurface2.albedo=0.8,0.46,0.34 --set isosurface2.opacity=1 \
  --set isosurface2.facing_opacity=0.12 --set pieces.smallest=1000 --set look.ambient=0.2 --set look.accessibility=0.5 \
  --set camera.eye=370,-480,110 --set camera.target=4,4,-5 --set camera.fov=22 --out skin_over_bone.png

# Transparency
isolux render $skull --isovalue 0.2 --set isosurface.opacity=0.35 --set isosurface.albedo=0.85,0.5,0.38 \
  --set isosurface2.shown=true --set isosurface2.value=0.51 --set isosurface2.opacity=1 \
  --set isosurface2.albedo=0.9,0.86,0.75 --out skin_and_bone.png
isolux render $engine --set isosurface.opacity=0.3 --set isosurface2.shown=true --set isosurface2.value=180 \
  --set isosurface2.opacity=1 --set isosurface2.albedo=0.8,0.35,0.1 --out engine_inside.png
isolux render $teapot --set isosurface.opacity=0.35 --set isosurface.albedo=0.7,0.2,0.1 --out lobster.png

# Cuts
cut="$data/volumes/ct_head_skin_bone.nii.gz $paper --set camera.eye=370,-420,260 --set camera.target=4,4,2
  --set camera.fov=25 --set slice.level=0.45 --set slice.width=1.1"
skin="--isovalue 0.2 --set isosurface.albedo=0.85,0.5,0.38"
isolux render $cut --isovalue 0.51 --set "clip.planes=0,0,35 0,0,1" --out cut_skull.png
isolux render $cut $skin --set "clip.planes=4,0,0 1,0,0" --out cut_head.png
isolux render $cut $skin --set isosurface2.shown=true --set isosurface2.value=0.51 --set isosurface2.opacity=1 \
  --set isosurface2.albedo=0.9,0.86,0.75 --set isosurface2.clipped=false --set clip.cap=none \
  --set "clip.planes=4,0,0 1,0.15,0" --out cut_skin.png

# Meshes and solids
rocker="$data/mesh/rocker-arm.obj $paper
  --set camera.eye=1.5,-1.2,0.5 --set camera.target=0,0,0.02 --set camera.up=0,0,1 --set camera.fov=30"
spot="$data/mesh/spot.obj $paper
  --set camera.eye=1.9,0.9,-3 --set camera.target=0,0.05,0.25 --set camera.up=0,1,0 --set camera.fov=28"
fandisk="$data/mesh/fandisk.obj $paper
  --set camera.eye=12,8,4 --set camera.target=2.4,15.2,-1.6 --set camera.up=0,0,1 --set camera.fov=26"
bunny="$data/mesh/stanford-bunny.obj $paper
  --set camera.eye=0.1,0.2,0.4 --set camera.target=-0.017,0.108,-0.0015 --set camera.up=0,1,0 --set camera.fov=24"

isolux render $rocker --look tone --set look.contours=1 --out mesh_rocker_arm.png
isolux render $spot --look curvature_2d --out mesh_spot.png
isolux render $fandisk --look lambert --set look.ridges=1 --set look.ambient=0.3 --out mesh_fandisk.png
isolux render phantom:gyroid $paper $above --set source.csg=intersection --set source.csg_path=phantom:ball \
  --out csg_ball.png
isolux render $bunny --set source.csg=intersection --set source.csg_path=phantom:gyroid --out csg_bunny.png
isolux render $engine --set source.csg=difference --set source.csg_path=phantom:ball --out csg_engine.png

# Global illumination
grace="--environment $data/hdr/grace_cathedral_1k.hdr"
heptane="$data/volumes/heptane.nii.gz --isovalue 60 $paper"
for s in engine skull heptane; do
  isolux render ${!s} --look gi --out gi_studio_$s.png
  isolux render ${!s} --look gi --set light.environment.constant=1,1,1 --set picture.metering=lights --out gi_sky_$s.png
  isolux render ${!s} --look gi $grace --out gi_grace_$s.png
done
for light in window overcast sunset; do
  isolux render $skull --look gi --environment $light --set light.environment.visible=true --out gi_$light.png
done
for s in engine skull heptane; do
  isolux render ${!s} --look gi --set light.environment.constant=0.12,0.14,0.2 \
    --set lamps.lamp.kind=sphere --set lamps.lamp.color=1,0.85,0.6 --set picture.exposure=0 --out gi_lamp_$s.png
  isolux render ${!s} --look curvature_2d --set look.shading=gi --out gi_curvature_$s.png
done

# Beside the reference
for s in engine skull heptane; do
  moving="--set light.environment.moves=true" fixed="--set picture.metering=lights"
  isolux render ${!s} --look gi $grace $fixed --out compare_irradiance_$s.png
  isolux render ${!s} --look gi $grace $fixed $moving --out compare_transfer_$s.png
  isolux reference ${!s} --look gi $grace --spp 1024 --out compare_reference_$s.png
done

# Together
isolux render $skull --look accessibility --set look.ridges=0.7 --set look.shadow=0.6 --out together_skull.png
isolux render $torus --look shape_index --set flow.strength=0.8 --set look.contours=1 --out together_torus.png
isolux render $gyroid --look mean_curvature --set look.shading=tone --set look.fog=0.8 --out together_gyroid.png

# ---- Derivative scale, before and after

data=data
plain="--set look.background_top=1,1,1 --set look.background_bottom=1,1,1 --size 360x360"
before="--set derivatives.scale=0 --set derivatives.normal_scale=0"
lines="--look lambert --set look.ridges=1 --set look.ridge_color=0.85,0.1,0.05 --set look.valley_color=0.02,0.05,0.6"
colin="$data/volumes/mri_colin27.nii.gz --isovalue 40 $plain
  --set camera.eye=240,-450,70 --set camera.target=0,17,20 --set camera.fov=23"
pitch="$data/volumes/ct_head_pitch.nii.gz --isovalue 100 $plain --set camera.fov=17"
avm="$data/volumes/ct_avm.nii.gz --isovalue 177 $plain --set camera.fov=20"
tooth="$data/volumes/tooth.mhd --isovalue 620 $plain --set camera.fov=21"
cast="$data/volumes/engine.nii.gz --isovalue 80 $plain
  --set camera.eye=-330,-370,215 --set camera.target=0,0,-9 --set camera.fov=26.5"
scans="colin pitch avm tooth cast"

# Shape index
for s in $scans; do
  isolux render ${!s} --look shape_index $before --out before_shape_$s.png
  isolux render ${!s} --look shape_index --out after_shape_$s.png
done

# Ridges and valleys
for s in $scans; do
  isolux render ${!s} $lines $before --out before_lines_$s.png
  isolux render ${!s} $lines --out after_lines_$s.png
done

# Both curvatures at once
for s in $scans; do
  isolux render ${!s} --look curvature_2d $before --out before_both_$s.png
  isolux render ${!s} --look curvature_2d --out after_both_$s.png
done

# ---- Figures of the two papers

data=data
paper="--size 300x300 --set look.background_top=1,1,1 --set look.background_bottom=1,1,1 --set look.legend=false"
skull="$data/volumes/ct_head_skin_bone.nii.gz --isovalue 0.51 $paper
  --set camera.eye=370,-480,110 --set camera.target=4,4,-5 --set camera.fov=20.5"
engine="$data/volumes/engine.nii.gz --isovalue 80 $paper
  --set camera.eye=-330,-370,215 --set camera.target=0,0,-9 --set camera.fov=26.5"
grace="--look gi --set light.environment.file=$data/hdr/grace_cathedral_1k.hdr"

bunny="$data/mesh/stanford-bunny.obj $paper --set source.mesh_voxels=256 --view anterior --fit surface"
arm="$data/mesh/rocker-arm.obj $paper --set source.mesh_voxels=256 --azimuth 30 --elevation 30 --fit surface"
torus="phantom:torus:64 $paper --set camera.eye=70,-150,190 --set camera.target=0,0,0 --set camera.fov=23.5"
coarse="--set hit.method=sampled --set hit.rate=0.5 --set camera.fov=8 --set hit.near_factor"
isolux render $bunny --look kappa1 --out paper_kappa1.png
isolux render $skull $coarse=1 --out paper_rate.png
isolux render $skull $coarse=8 --out paper_rate_adaptive.png
isolux render $torus --look mean_curvature --out paper_mean.png
isolux render $torus --look gaussian_curvature --out paper_gaussian.png
isolux render $arm --look tone --out paper_tone.png
isolux render $arm --look tone --set look.accessibility=1 --out paper_accessibility.png
isolux render $bunny --look flow --out paper_flow.png
isolux render $data/volumes/ct_cranium.mhd --isovalue 300 --view anterior --fit surface $paper --look tone \
  --set pieces.keep=1 --set picture.caveats=false --set look.contours=1 --set look.ridges=1 --out paper_lines.png
isolux render $skull --set look.overlay=blocks --out paper_blocks.png
isolux render $skull --set memory.layout=bricks --set look.overlay=bricks --executor gpu --out paper_bricks.png
isolux render $skull --set camera.fov=4 --look gi --set gi.lattice_scale=0.5 --set look.overlay=texels --out paper_texels.png

lit="$skull $grace"
heptane="$data/volumes/heptane.nii.gz --isovalue 60 $paper"
isolux render $skull --set look.shadow=1 --out paper_phong.png
isolux render $lit --out paper_light.png
isolux render $lit --set derivatives.field=trilinear --out paper_normals.png
for way in closest_isovalue nearest trilinear tricubic weighted; do
  isolux render $engine $grace --set gi.texels=own --set gi.interpolation=$way --out paper_read_$way.png
done
for paths in 16 100; do
  isolux render $engine $grace --set gi.samples=$paths --set gi.interpolation=trilinear --out paper_irradiance_$paths.png
  isolux render $engine $grace --set gi.samples=$paths --set gi.interpolation=trilinear --set light.environment.moves=true \
    --out paper_harmonics_$paths.png
done
isolux render $heptane $grace --out paper_heptane_light.png
isolux render $heptane --look gi --set gi.mode=vicinity --out paper_heptane_vicinity.png
isolux render $heptane --look lambert --set look.fog=0.7 --out paper_heptane_fog.png
isolux render $heptane --look lambert --out paper_heptane_lambert.png
for value in 0.51 0.60 0.69; do
  isolux render $skull --isovalue $value --look gi --set gi.texels=own --set light.environment.constant=0.1,0.12,0.2 \
    --set lamps.lamp.kind=sphere --set lamps.lamp.color=1,0.8,0.35 --set lamps.lamp.position=330,-80,150 \
    --set lamps.lamp.radius=12 --set picture.exposure=0 --out paper_fade_$value.png
done
for scale in 0.5 1 2; do
  isolux render $lit --set gi.lattice_scale=$scale --set gi.interpolation=trilinear --out paper_lattice_$scale.png
done
