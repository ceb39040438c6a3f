#!/bin/sh
# Tiles of libweft beside those of other tools: peers.sh WEFT PHOTO.png... writes a table. SIZE (256) is the side of the
# tiles; a photo's middle of twice that is what all get. Peers: toroidal synthesis without stationarity (the paper's
# baseline), GEGL's tile-seamless on a crop of the tile's size, and GIMP's resynthesizer; what is not installed is
# skipped, and said so. Seconds are of the whole program, best of three; the measures are those of `weft compare`.
weft=$1
side=${SIZE:-256}
shift
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT

have() { command -v "$1" >/dev/null 2>&1; }
seconds_now() { date +%s.%N; }

# crop PHOTO SIDE OUT: the middle.
crop() {
    "$weft" analyze "$1" -o "$here/picture" --method picture --quiet || exit 1
    width=$("$weft" info "$here/picture" | awk '$1 == "size" { print $2 }')
    height=$("$weft" info "$here/picture" | awk '$1 == "size" { print $4 }')
    wide=$(($2 < width ? $2 : width)) high=$(($2 < height ? $2 : height))
    "$weft" render "$here/picture" -o "$3" --size "${wide}x$high" --at "$(((width - wide) / 2)),$(((height - high) / 2))" || exit 1
}

number() { sed -n "s/^  \"$1\": \([^,]*\),*$/\1/p" "$here/compare.json"; }

# row NAME command...: runs it three times, measures $here/tile.png against $here/photo.png.
row() {
    name=$1 best=
    shift
    for _ in 1 2 3; do
        rm -f "$here/tile.png"
        begin=$(seconds_now)
        "$@" >"$here/said" 2>&1
        end=$(seconds_now)
        [ -s "$here/tile.png" ] || { printf '%-18s %-22s failed: %s\n' "$photo_name" "$name" "$(tail -n 1 "$here/said")"; return; }
        best=$(echo "$begin $end $best" | awk '{ t = $2 - $1; print (NF > 2 && $3 < t) ? $3 : t }')
    done
    "$weft" compare "$here/photo.png" "$here/tile.png" --json --quiet >"$here/compare.json"
    printf '%-18s %-22s %8.2f %8.2f %8.2f %8.2f %8.3f\n' "$photo_name" "$name" "$best" "$(number stationarity_cost)" \
        "$(number texture_cost)" "$(number seam_score)" "$(number patch_distance)"
}

gegl_tile() { gegl "$here/crop.png" -o "$here/tile.png" -- gegl:tile-seamless; }

# The procedure's arguments: both axes wrap, no context, the photo as corpus, no maps, the usual 30 neighbours and 500 tries.
resynthesizer_tile() {
    gimp -i -d -f -b "(let* ((corpus (car (gimp-file-load 1 \"$here/photo.png\" \"\")))
            (source (car (gimp-image-get-active-drawable corpus))) (image (car (gimp-image-new $side $side 0)))
            (layer (car (gimp-layer-new image $side $side 0 \"tile\" 100 0))))
        (gimp-image-insert-layer image layer 0 0)
        (plug-in-resynthesizer 1 image layer 1 1 0 source -1 -1 0.0 0.117 30 500)
        (gimp-file-save 1 image layer \"$here/tile.png\" \"\"))" -b '(gimp-quit 1)'
}

has_resynthesizer() {
    have gimp && for folder in /usr/lib/*/gimp/2.0/plug-ins /usr/lib/gimp/2.0/plug-ins "$HOME"/.config/GIMP/2.10/plug-ins; do
        [ -e "$folder/resynthesizer" ] || [ -e "$folder/resynthesizer/resynthesizer" ] && return 0
    done
    return 1
}

[ $# -gt 0 ] || { echo "usage: peers.sh WEFT PHOTO.png..." >&2; exit 2; }
have gegl || echo "gegl is not installed: its tile-seamless is skipped"
has_resynthesizer || echo "GIMP's resynthesizer is not installed: it is skipped"
printf '%-18s %-22s %8s %8s %8s %8s %8s\n' photo tool seconds c_stat c_text seam patches
for photo in "$@"; do
    photo_name=$(basename "$photo" .png)
    crop "$photo" $((2 * side)) "$here/photo.png"
    crop "$photo" "$side" "$here/crop.png"
    row "weft tile" "$weft" tile "$here/photo.png" -o "$here/tile.png" --size "${side}x$side" --quiet
    row "weft tile, none" "$weft" tile "$here/photo.png" -o "$here/tile.png" --size "${side}x$side" --measure none --quiet
    row "crop as it is" cp "$here/crop.png" "$here/tile.png"
    have gegl && row "gegl tile-seamless" gegl_tile
    has_resynthesizer && row "gimp resynthesizer" resynthesizer_tile
done
exit 0
