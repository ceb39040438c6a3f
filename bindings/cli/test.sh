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
for command in analyze render info export import compare devices bench; do
    expect 0 "$weft" $command --help
    says 'exit codes: 0 fine, 1 the work failed, 2 wrong usage, 3 cancelled'
    expect 2 "$weft" $command --no-such-option
    expect 2 "$weft" $command --threads 0
    expect 2 "$weft" $command --threads
done
for command in analyze render info export import compare bench; do expect 2 "$weft" $command; done

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

# Comparison
expect 0 "$weft" compare one.png one.png
says '^model_error'
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
expect 0 "$weft" bench photo.weft --size 48x40 --repetitions 1 --device scalar
says '^scalar'

for file in *.??????; do
    case $file in *.texton) ;; *) [ ! -e "$file" ] || bad "$file was left behind" ;; esac
done
[ -n "$can_check_json" ] || echo "no Python with its json module: the JSON was not parsed"
echo "$checks checks, $failures failed"
[ $failures -eq 0 ]
