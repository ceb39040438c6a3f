#!/bin/sh
# The program as its users run it: test.sh WEFT EXEMPLARS [sanitized]. Every command, exit code and pipe; what overlaps,
# repeats or is moved by a device or a thread is compared to the byte.
weft=$1 exemplars=$2 sanitized=${3:-}
photo=$exemplars/ground.png grey=$exemplars/gravel.png
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1
unset WEFT_BACKEND_PATH
failures=0 checks=0

bad() { failures=$((failures + 1)); echo "FAILED: $*"; }

# expect CODE command...: the exit code, and for failures one line on stderr that begins with "weft".
expect() {
    wanted=$1
    shift
    "$@" >out 2>err
    got=$?
    checks=$((checks + 1))
    [ $got -eq "$wanted" ] || bad "exit code $got, not $wanted: $* ($(cat err))"
    if [ "$wanted" -eq 1 ] || { [ "$wanted" -eq 2 ] && [ $# -gt 1 ]; }; then
        [ "$(wc -l <err)" -eq 1 ] && grep -q '^weft' err || bad "not one line: $* ($(cat err))"
    fi
}

# same FILE FILE what: equal bytes.
same() {
    checks=$((checks + 1))
    cmp -s "$1" "$2" || bad "$1 and $2 differ: $3"
}

absent() {
    checks=$((checks + 1))
    for file in "$@"; do [ ! -e "$file" ] || bad "$file was left behind"; done
}

# says WORDS: the last output has them.
says() {
    checks=$((checks + 1))
    grep -q -e "$1" out || bad "the output lacks '$1'"
}

can_check_json=
python3 -c 'import json.tool' 2>/dev/null && can_check_json=yes
valid_json() {
    [ -z "$can_check_json" ] && return
    checks=$((checks + 1))
    python3 -m json.tool "$1" >/dev/null || bad "$1 is no JSON"
}

# Usage
expect 2 "$weft"
expect 2 "$weft" nonsense
expect 0 "$weft" --help
expect 0 "$weft" --version
says '^weft [0-9]*\.[0-9]*\.[0-9]*, libweft '
for command in analyze describe render info export import mix preview sheet tile apply compare devices bench; do
    expect 0 "$weft" $command --help
    says 'exit codes: 0 fine, 1 the work failed, 2 wrong usage, 3 cancelled'
    expect 2 "$weft" $command --no-such-option
    expect 2 "$weft" $command --threads 0
    expect 2 "$weft" $command --threads
done
for command in analyze describe render info export import mix preview sheet tile apply compare bench; do expect 2 "$weft" $command; done

# Devices
expect 0 "$weft" devices
says '^scalar  *exact'
expect 0 "$weft" devices --json
valid_json out

# A picture there and back: the model of a rendered picture is the model of the picture.
expect 0 "$weft" analyze "$photo" -o photo.weft --method picture --quiet
[ ! -s out ] || bad "--quiet is not quiet"
width=$("$weft" info photo.weft | awk '$1 == "size" { print $2 }')
height=$("$weft" info photo.weft | awk '$1 == "size" { print $4 }')
expect 0 "$weft" render photo.weft -o photo.png --size "${width}x$height"
expect 0 "$weft" analyze photo.png -o again.weft --method picture --json
valid_json out
same photo.weft again.weft "a picture rendered at its size"
expect 0 "$weft" render photo.weft -o photo16.png --size "${width}x$height" --depth 16 --json
valid_json out
expect 0 "$weft" render photo.weft -o moved.png --size "${width}x$height" --at "-$width,$((height * 3))"
same photo.png moved.png "a picture repeats after itself"
expect 1 "$weft" render photo.weft -o bad.png --size 8x8 --period 7x7
absent bad.png

# Pipes
"$weft" analyze - -o - --method picture <"$photo" | "$weft" render - -o - --size "${width}x$height" >piped.png
same photo.png piped.png "photo and model through pipes"
expect 2 "$weft" render photo.weft -o - --size 8x8 --json

# Texton noise
expect 0 "$weft" analyze "$photo" -o noise.weft --method texton --support 32 --iterations 10 --seed 7
says 'relative model error 0\.'
expect 0 "$weft" analyze "$photo" -o noise2.weft --support=32 --iterations=10 --seed=7 --threads 1
expect 0 "$weft" info noise.weft
says '^interpolation *1'
expect 0 "$weft" info noise.weft --json
valid_json out
expect 0 "$weft" analyze "$grey" -o cubic.weft --support 16 --iterations 3 --interpolation 3 --projection plain
expect 0 "$weft" info cubic.weft
says '^interpolation *3'
says '^channels *1'

# One texture, whatever the window, the device, the number of threads
expect 0 "$weft" render noise.weft -o scalar.png --size 200x150 --at -90,-61 --seed 5 --device scalar --threads 1
expect 0 "$weft" render noise.weft -o all.png --size 200x150 --at -90,-61 --seed 5 --device scalar
same scalar.png all.png "number of threads"
for device in $("$weft" devices | awk '$2 == "exact" { print $1 }'); do
    expect 0 "$weft" render noise.weft -o device.png --size 200x150 --at -90,-61 --seed 5 --device "$device"
    same scalar.png device.png "device $device"
done
expect 0 "$weft" render noise.weft -o other.png --size 200x150 --at -90,-61 --seed 6
checks=$((checks + 1))
cmp -s scalar.png other.png && bad "another seed gives the same texture"
expect 0 "$weft" render noise.weft -o a.png --size 64x80 --period 64x80 --impacts 12.5
expect 0 "$weft" render noise.weft -o b.png --size 64x80 --period 64x80 --impacts 12.5 --at 70368744177664,-80
same a.png b.png "exact period"
expect 0 "$weft" render noise.weft -o level.png --size 16x16 --level 3 --at -4,9
expect 0 "$weft" render noise.weft -o far.png --size 16x16 --at 1099511627776,-1099511627776
for bad_option in "--size 0x8" "--size 8" "--size 70000x8" "--at 1" "--at 2000000000000000000,0" "--level 31" "--seed -1" \
    "--impacts 0.5" "--impacts 1001" "--impacts nan" "--depth 12" "--period 8x99999999" "--maps 2,2" "--maps 5" "extra"; do
    # shellcheck disable=SC2086
    expect 2 "$weft" render noise.weft -o bad.png --size 8x8 $bad_option
done
absent bad.png

# Export and import
expect 0 "$weft" export noise.weft parts --json
valid_json out
valid_json parts/model.json
for file in texton.png texton.texton model.json; do [ -s "parts/$file" ] || bad "export wrote no $file"; done
expect 0 "$weft" import parts/texton.texton -o imported.weft
expect 0 "$weft" export imported.weft parts2
same parts/texton.texton parts2/texton.texton "a .texton there and back"
same parts/texton.png parts2/texton.png "the texton there and back"
expect 0 "$weft" export photo.weft picture_parts
[ -s picture_parts/picture.png ] || bad "export wrote no picture.png"
absent picture_parts/texton.texton
expect 1 "$weft" import "$photo" -o bad.weft
absent bad.weft

# Wavelet noise, its parameters as JSON there and back, and written without a photo
expect 0 "$weft" analyze "$photo" -o wavelet.weft --method wavelet
says '^wavelet.weft: wavelet, channels 3'
expect 0 "$weft" analyze "$photo" -o plain.weft --method wavelet --bands 4 --gaussian --json
valid_json out
expect 0 "$weft" analyze "$photo" -o knots.weft --method wavelet --bands 4 --knots 6
expect 2 "$weft" analyze "$photo" -o bad.weft --method wavelet --bands 17
expect 2 "$weft" analyze "$photo" -o bad.weft --method wavelet --knots 1
expect 0 "$weft" info knots.weft
says '^bands *4$'
says '^tone knots *6$'
expect 0 "$weft" info plain.weft
says '^tone knots *none$'
expect 0 "$weft" info wavelet.weft --json
says '"weights": \['
valid_json out
for model in wavelet plain knots; do
    expect 0 "$weft" export $model.weft ${model}_parts
    valid_json ${model}_parts/wavelet.json
    valid_json ${model}_parts/model.json
    expect 0 "$weft" import ${model}_parts/wavelet.json -o back.weft
    same $model.weft back.weft "wavelet noise as JSON there and back"
done
"$weft" import - -o back.weft --quiet <knots_parts/wavelet.json
same knots.weft back.weft "JSON through a pipe"
expect 0 "$weft" render wavelet.weft -o wavelet.png --size 90x70 --at -33,12 --device scalar --threads 1
for device in $("$weft" devices | awk '$2 == "exact" { print $1 }'); do
    expect 0 "$weft" render wavelet.weft -o device.png --size 90x70 --at -33,12 --device "$device"
    same wavelet.png device.png "wavelet noise on device $device"
done

# Bi-layer textures: of a small picture, as every way of putting structure together
expect 0 "$weft" render photo.weft -o small.png --size 96x80
for structure in auto wang exchange both none; do
    expect 0 "$weft" analyze small.png -o layers-$structure.weft --method bilayer --structure $structure --noises 2 --support 16 --seed 3
    says "^layers-$structure.weft: bilayer"
    expect 0 "$weft" export layers-$structure.weft parts_$structure
    valid_json parts_$structure/model.json
    for file in mask-0 texton-0 spectrum-0 noise; do
        [ -s parts_$structure/$file.png ] || bad "export of $structure wrote no $file.png"
    done
    expect 0 "$weft" sheet layers-$structure.weft -o sheet.png --photo small.png
done
[ -s parts_wang/structure.png ] || bad "export wrote no structure.png"
[ ! -e parts_none/structure.png ] || bad "export wrote a structure where there is none"
expect 0 "$weft" analyze "$grey" -o patches.weft --method bilayer --structure exchange --noises 1 --support 16
expect 0 "$weft" export patches.weft parts_exchange
[ -s parts_exchange/patches.png ] || bad "export wrote no patches.png"
grep -q '^patch,x,y,degrees,scale$' parts_exchange/contents.csv || bad "export wrote no contents.csv"
[ "$(awk -F, 'NF != 5' parts_exchange/contents.csv | wc -l)" -eq 0 ] || bad "contents.csv is no table"
expect 0 "$weft" analyze small.png -o layers.weft --method bilayer --window 2 --mask-window 4 --masks barycentric \
    --structure exchange --border 2 --equalize --depth 2 --support 16 --noises 3 --json
valid_json out
expect 0 "$weft" info layers.weft
says '^method *bilayer$'
expect 0 "$weft" info layers.weft --json
valid_json out
expect 0 "$weft" render layers.weft -o layers.png --size 90x70 --at -33,12 --device scalar --threads 1 --rotation all \
    --scale-min 0.5 --turbulence 5 --noise tile
for device in $("$weft" devices | awk '$2 == "exact" { print $1 }'); do
    expect 0 "$weft" render layers.weft -o device.png --size 90x70 --at -33,12 --device "$device" --rotation all \
        --scale-min 0.5 --turbulence 5 --noise tile
    same layers.png device.png "a bi-layer texture on device $device"
done
expect 0 "$weft" render layers.weft -o layers2.png --size 90x70 --at -33,12 --rotation none --turbulence -1
checks=$((checks + 1))
cmp -s layers.png layers2.png && bad "deformations do nothing"
for bad_option in "--rotation some" "--scale-min 0.4" "--turbulence 65" "--noise white"; do
    # shellcheck disable=SC2086
    expect 2 "$weft" render layers.weft -o bad.png --size 8x8 $bad_option
done
expect 1 "$weft" render photo.weft -o bad.png --size 8x8 --rotation all
for bad_option in "--noises 7" "--window 17" "--mask-window 1" "--masks soft" "--structure some" "--border 65" "--depth 5"; do
    # shellcheck disable=SC2086
    expect 2 "$weft" analyze small.png -o bad.weft --method bilayer $bad_option
done
expect 1 "$weft" analyze small.png -o bad.weft --method bilayer --window 3
expect 1 "$weft" analyze small.png -o bad.weft --method bilayer --support 100
expect 0 "$weft" preview small.png -o preview.png --noises 2 --json
valid_json out
expect 0 "$weft" preview small.png -o preview2.png --noises 2 --threads 1 --quiet
same preview.png preview2.png "a preview"
expect 2 "$weft" preview small.png
expect 2 "$weft" preview small.png -o bad.png --noises 9
expect 1 "$weft" preview no_such_file -o bad.png
absent bad.png bad.weft

# What a photo is like
expect 0 "$weft" describe "$photo"
says '^structure '
expect 0 "$weft" describe "$photo" --json
valid_json out
method=$(sed -n 's/^  "method": "\(.*\)",$/\1/p' out)
expect 0 "$weft" analyze "$photo" -o auto.weft --method auto --support 16 --iterations 2
says "^auto.weft: $method"
expect 1 "$weft" describe knots.weft

# import_json CODE WORDS JSON: what a file of that JSON gives, and what is said about it.
import_json() {
    printf '%s' "$3" >given.json
    expect "$1" "$weft" import given.json -o given.weft
    [ "$1" -eq 0 ] || cat err >out
    says "$2"
}
import_json 0 'given.weft: wavelet, channels 1' '{"method": "wavelet", "mean": [0.5], "axes": [[1]],
    "weights": [[0.1, 0.05e0, 2.5E-2]], "tone": []}'
rm given.weft
import_json 1 'given.json: line 1: ' ''
import_json 1 'line 1: ' '[]'
import_json 1 'line 1: "nothing" is unknown' '{"nothing": 1}'
import_json 1 'line 2: "mean" is here twice' '{"mean": [0],
    "mean": [0]}'
import_json 1 'line 2: "method" is missing' '{"mean": [0], "axes": [[1]], "weights": [[1]], "tone": []
}'
import_json 1 'line 3: 2 channels here, 1 before' '{"method": "wavelet", "mean": [0],

    "axes": [[1, 0]], "weights": [[1]], "tone": []}'
import_json 1 'line 1: the method is "texton"' '{"method": "texton"}'
import_json 1 'line 1: a number is expected' '{"mean": [[[[[[[['
import_json 1 'line 1: more than 16 channels' '{"mean": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1]}'
import_json 1 'line 2: something follows' '{"method": "wavelet", "mean": [0.5], "axes": [[1]], "weights": [[1]], "tone": []}
x'
import_json 1 'line 1: the number is too large' '{"mean": [1e40]}'
import_json 1 'weft_model_from_wavelet' '{"method": "wavelet", "mean": [0], "axes": [[2]], "weights": [[1]], "tone": []}'
size=$(wc -c <knots_parts/wavelet.json)
for cut in 1 30 100 $((size / 2)) $((size - 3)); do
    head -c $cut knots_parts/wavelet.json >given.json
    expect 1 "$weft" import given.json -o given.weft
done
absent given.weft

# Mixing
expect 0 "$weft" mix wavelet.weft wavelet.weft -o mixed.weft --t 0.5
expect 0 "$weft" mix wavelet.weft knots.weft -o mixed.weft --t 0 --json
valid_json out
expect 0 "$weft" render mixed.weft -o mixed.png --size 90x70 --at -33,12
same wavelet.png mixed.png "the first of two models"
expect 0 "$weft" mix knots.weft wavelet.weft -o mixed.weft --t 1
expect 0 "$weft" render mixed.weft -o mixed.png --size 90x70 --at -33,12
same wavelet.png mixed.png "the second of two models"
expect 0 "$weft" analyze "$photo" -o first.weft --support 16 --iterations 2
expect 0 "$weft" analyze "$exemplars/clay.png" -o second.weft --support 16 --iterations 2
expect 0 "$weft" mix first.weft second.weft -o mixed.weft --steps 3
says '3 steps'
expect 0 "$weft" export mixed.weft mixed_parts
for step in 0 1 2; do [ -s mixed_parts/texton-$step.png ] || bad "export wrote no texton-$step.png"; done
valid_json mixed_parts/model.json
"$weft" analyze "$grey" -o map.weft --method picture --quiet
"$weft" render map.weft -o map.png --size 32x32
expect 0 "$weft" render mixed.weft -o first.png --size 64x64
expect 0 "$weft" render mixed.weft -o by_map.png --size 64x64 --mix map.png --mix-scale 4 --threads 1 --device scalar
checks=$((checks + 1))
cmp -s first.png by_map.png && bad "the map does nothing"
expect 0 "$weft" render mixed.weft -o by_map2.png --size 64x64 --mix map.png --mix-scale 4
same by_map.png by_map2.png "the same map"
expect 1 "$weft" render mixed.weft -o bad.png --size 8x8 --mix "$photo"
expect 1 "$weft" render first.weft -o bad.png --size 8x8 --mix map.png
expect 2 "$weft" render mixed.weft -o bad.png --size 8x8 --mix-scale 4
expect 2 "$weft" render mixed.weft -o bad.png --size 8x8 --mix map.png --mix-scale 0.5
expect 2 "$weft" mix first.weft second.weft -o bad.weft
expect 2 "$weft" mix first.weft second.weft -o bad.weft --t 0.5
expect 2 "$weft" mix wavelet.weft knots.weft -o bad.weft --steps 3
expect 2 "$weft" mix wavelet.weft knots.weft -o bad.weft --t 1.5
expect 1 "$weft" mix first.weft knots.weft -o bad.weft --steps 3
absent bad.weft bad.png

# Tiles: one seed, one tile; it repeats; its model gives it back, and that of another map
expect 0 "$weft" tile "$photo" -o tile.png --model tile.weft --size 72x64 --seed 3
says '^tile.png: 72 x 64, sigma 0.100, stationarity cost '
expect 0 "$weft" tile "$photo" -o tile2.png --model tile2.weft --size 72x64 --seed 3 --threads 1 --json
valid_json out
says '"sigma": 0.1'
same tile.png tile2.png "one seed, any number of threads"
same tile.weft tile2.weft "one seed, any number of threads"
expect 0 "$weft" render tile.weft -o tiled.png --size 72x64 --at -720,128
same tile.png tiled.png "a tile repeats after itself"
expect 0 "$weft" apply tile.weft "$photo" -o applied.png
same tile.png applied.png "the photo applied to its own model"
expect 0 "$weft" apply tile.weft photo16.png -o applied16.png --json
valid_json out
says '"depth": 16'
expect 0 "$weft" info tile.weft
says '^method *stationary'
expect 0 "$weft" export tile.weft tile_parts
for file in tile.png correspondence.png model.json; do [ -s "tile_parts/$file" ] || bad "export wrote no $file"; done
valid_json tile_parts/model.json
expect 0 "$weft" analyze "$photo" -o stationary.weft --method stationary
says '^stationary.weft: stationary of 256 x 256, channels 3'
expect 0 "$weft" tile "$photo" -o tile2.png --size 72x64 --measure none --json
says '"sigma": null'
expect 0 "$weft" tile "$photo" -o tile2.png --size 64x64 --measure moments --moments 4 --scale coarse --patch 7
expect 0 "$weft" tile "$photo" -o tile2.png --size 64x64 --measure steerable --sigma 0.2 --quiet
[ ! -s out ] || bad "--quiet is not quiet"
expect 0 "$weft" tile "$photo" -o tile2.png --size 64x64 --sigma-map map.png
expect 0 "$weft" tile "$photo" -o tile2.png --size 64x64 --stationarity 0.5
expect 0 "$weft" tile "$photo" "$photo" photo16.png -o tile-%d.png --size 72x64 --seed 3
same tile-1.png tile-2.png "two maps that are one"
expect 0 "$weft" tile "$photo" -o sheet.png --size 64x64 --palette 2
says '^column  2: --stationarity 1.000'
expect 0 "$weft" tile "$photo" -o sheet.png --size 64x64 --palette 3 --json
valid_json out
expect 1 "$weft" apply tile.weft tile.png -o bad.png
expect 1 "$weft" apply photo.weft "$photo" -o bad.png
expect 1 "$weft" tile "$photo" -o bad.png --size 64x64 --sigma-map "$photo"
for bad_option in "--size 63x64" "--size 64x2049" "--sigma 0.01" "--sigma 2" "--stationarity 1.5" "--measure median" "--palette 1" \
    "--scale 4" "--patch 8" "--moments 5" "--sigma 0.1 --stationarity 0.5" "--palette 3 --sigma 0.1" \
    "--measure none --sigma 0.1" "--json -o -"; do
    # shellcheck disable=SC2086
    expect 2 "$weft" tile "$photo" -o bad.png $bad_option
done
expect 2 "$weft" apply tile.weft "$photo"
absent bad.png

# Several maps of one surface
expect 0 "$weft" render photo.weft -o one.png --size 64x64
expect 0 "$weft" analyze "$grey" -o grey.weft --method picture
expect 0 "$weft" render grey.weft -o two.png --size 64x64 --depth 16
expect 0 "$weft" analyze one.png two.png one.png -o maps.weft --method picture
expect 0 "$weft" info maps.weft
says '^channels *7'
expect 2 "$weft" render maps.weft -o bad.png --size 64x64
expect 2 "$weft" render maps.weft -o bad.png --size 64x64 --maps 3,1,3
expect 2 "$weft" render maps.weft -o bad-%d.png --size 64x64 --maps 3,1,2
absent bad.png bad-1.png bad-2.png bad-3.png
expect 0 "$weft" render maps.weft -o map-%d.png --size 64x64 --maps 3,1,3 --depth 16
same map-1.png map-3.png "the same map twice"
same map-2.png two.png "a map of 16 bits"
expect 1 "$weft" analyze one.png "$photo" -o bad.weft
absent bad.weft

# Sheets: of every kind of model, with and without the photo; the same whatever the number of threads
for model in noise wavelet plain mixed photo; do
    expect 0 "$weft" sheet $model.weft -o sheet.png --photo "$photo" --quiet
    expect 0 "$weft" sheet $model.weft -o sheet2.png --photo "$photo" --threads 1
    same sheet.png sheet2.png "a sheet of $model"
    expect 0 "$weft" sheet $model.weft -o sheet3.png
    checks=$((checks + 1))
    cmp -s sheet.png sheet3.png && bad "the photo is not on the sheet of $model"
done
expect 0 "$weft" sheet cubic.weft -o sheet.png --photo "$grey"
expect 0 "$weft" sheet maps.weft -o sheet.png --json
valid_json out
"$weft" sheet - -o - <cubic.weft >piped.png
"$weft" sheet cubic.weft -o sheet.png
expect 0 "$weft" analyze piped.png -o bad.weft --method picture
rm bad.weft
expect 2 "$weft" sheet noise.weft
expect 2 "$weft" sheet noise.weft -o bad.png extra
expect 2 "$weft" sheet noise.weft -o - --json
expect 1 "$weft" sheet noise.weft -o bad.png --photo no_such_file
expect 1 "$weft" sheet noise.weft -o bad.png --photo "$grey"
expect 1 "$weft" sheet empty_or_missing.weft -o bad.png
expect 1 "$weft" sheet noise.weft -o no_such_folder/bad.png
absent bad.png

# Comparison
expect 0 "$weft" compare one.png one.png
says '^model_error'
says '^texture_cost'
expect 0 "$weft" compare one.png one.png --json --seed 3
valid_json out
expect 1 "$weft" compare one.png two.png

# What cannot be read or written
: >empty
size=$(wc -c <noise.weft)
for cut in 0 1 7 8 40 100 $((size / 2)) $((size - 1)); do
    head -c $cut noise.weft >cut.weft
    expect 1 "$weft" info cut.weft
    head -c $cut photo.png >cut.png
    expect 1 "$weft" analyze cut.png -o bad.weft
done
expect 1 "$weft" analyze empty -o bad.weft
expect 1 "$weft" analyze noise.weft -o bad.weft
expect 1 "$weft" analyze no_such_file -o bad.weft
expect 1 "$weft" analyze . -o bad.weft
expect 1 "$weft" info photo.png
expect 1 "$weft" info .
expect 1 "$weft" render noise.weft -o no_such_folder/bad.png --size 8x8
expect 1 "$weft" render noise.weft -o . --size 8x8
expect 1 "$weft" render noise.weft -o bad.png --size 8x8 --device no_such_device
expect 1 "$weft" export noise.weft empty
[ ! -e /dev/full ] || expect 1 "$weft" render noise.weft -o /dev/full --size 64x64
absent bad.weft bad.png
echo kept >kept.png
expect 1 "$weft" render cut.weft -o kept.png --size 8x8
grep -q kept kept.png || bad "a failed render touched the old file"

# Cancelling
"$weft" render noise.weft -o cancelled.png --size 20000x20000 --quiet 2>err &
child=$!
tries=0
until ls cancelled.png.* >/dev/null 2>&1 || [ $tries -eq 300 ]; do
    sleep 0.1
    tries=$((tries + 1))
done
kill -TERM $child
wait $child
got=$?
checks=$((checks + 1))
[ $got -eq 3 ] || bad "exit code $got, not 3, when cancelled"
grep -q '^weft render: cancelled$' err || bad "the cancelled render said $(cat err)"
absent cancelled.png cancelled.png.*

# Memory: 201 MB of pixels within 96 MiB of data.
if [ -z "$sanitized" ]; then
    # shellcheck disable=SC3045
    (ulimit -d 98304 && exec "$weft" render photo.weft -o - --size 8192x8192 --threads 2 >big.png 2>err) || bad "a large render: $(cat err)"
    checks=$((checks + 1))
fi

# Speed: the figures are not judged here.
expect 0 "$weft" bench noise.weft --size 48x40 --repetitions 2 --device scalar --json
valid_json out
says '"to_yardstick"'
expect 0 "$weft" bench wavelet.weft --size 48x40 --repetitions 1 --device scalar --json
valid_json out
says '"to_yardstick": [0-9]'
says '"space_to_yardstick": [0-9]'
says '"of_multiply_add_peak": [0-9]'
expect 0 "$weft" bench photo.weft --size 48x40 --repetitions 1 --device scalar
says '^scalar'

for file in *.??????; do
    case $file in *.texton) ;; *) [ ! -e "$file" ] || bad "$file was left behind" ;; esac
done
[ -n "$can_check_json" ] || echo "no Python with its json module: the JSON was not parsed"
echo "$checks checks, $failures failed"
[ $failures -eq 0 ]
