#!/usr/bin/env bash
# Long and large, for a nightly run: tests/long.sh PROGRAM [SECONDS [SANITIZED]]
# Clips of 100,000 frames, 10,000 ropes, a million masses, 3840 x 2160 pixels, a path of 4,000 characters and 10 million
# frames, simulated and by positions, by PROGRAM; then all commands mixed for SECONDS (an hour unless given), by
# SANITIZED where it is given: a ropesim that was built with the address sanitizer, which fails at a leak. Prints what
# it measured; stops with status 1 where something is wrong.
set -euo pipefail
program=$(realpath "$1")
seconds=${2:-3600}
sanitized=$(realpath "${3:-$1}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "long: $*" >&2; exit 1; }

# Runs it, with the largest resident set in kilobytes in $memory.
measured() {
    /usr/bin/time -f %M -o memory "$@" > out 2> err || { cat err >&2; fail "$*"; }
    memory=$(tail -n 1 memory)
}

# A scene of the parameters: frames, ropes, nodes.
scene() {
    echo "[clip]"
    printf 'frames = %d\nsteps_per_frame = 4\nsize = [64, 48]\nview = { height = 640.0 }\nwords = false\n' "$1"
    for ((rope = 0; rope < $2; ++rope)); do
        printf '[[rope]]\nname = "r%d"\nmethod = "direct_projection"\nstart = [0.0, %d.0]\nend = [-300.0, %d.0]\n' \
            $rope $((rope % 200)) $((rope % 200))
        printf 'nodes = %d\npinned = [0]\ndamping = 0.01\n' "$3"
    done
}

echo "== 100,000 frames"
scene 1000 1 16 > short.toml
scene 100001 1 16 > long.toml
measured "$program" render short.toml -o short --jobs 1 --no-error
short_memory=$memory
measured "$program" render long.toml -o long --jobs 1 --no-error
echo "memory: $short_memory KB for 1,000 frames, $memory KB for 100,001"
[ "$memory" -lt $((short_memory + 8192)) ] || fail "memory grows with the clip"
[ "$(find long -name 'frame_*.png' | wc -l)" = 100001 ] || fail "not all frames are there"
[ -e long/frame_000000.png ] && [ -e long/frame_100000.png ] || fail "names"
# In order of names they are in order of their making.
find long -name 'frame_*.png' -printf '%f %T@\n' | LC_ALL=C sort > made
LC_ALL=C sort -c -k2,2n made || fail "names do not sort as numbers"
awk 'NR == 1001 { a = $2 } NR == 11001 { b = $2 } NR == 90001 { c = $2 } NR == 100001 { d = $2 }
     END { printf "frames per second: %.0f in the first tenth, %.0f in the last\n", 10000 / (b - a), 10000 / (d - c) }' made
measured "$program" verify long
cat out
echo "verify: $memory KB"
rm -rf long short

echo "== 10 million frames, of which three"
scene 100 1 16 > hundred.toml
scene 10000000 1 16 > endless.toml
measured "$program" render hundred.toml -o hundred --frames 97:99 --no-error
short_memory=$memory
measured "$program" render endless.toml -o endless --frames 9999997: --no-error
echo "memory: $short_memory KB for 100 frames, $memory KB for 10,000,000"
[ "$memory" -lt $((short_memory + 8192)) ] || fail "memory grows with the clip"
ls endless
measured "$program" verify endless

echo "== 10 million frames of positions, of which three"
npy() {  # frames of a rope of 16 masses, all at 0: most of the file is a hole
    printf '\x93NUMPY\x01\x00\x76\x00%-117s\n' "{'descr': '<f8', 'fortran_order': False, 'shape': ($1, 16, 2), }" > "$2"
    truncate -s $((128 + $1 * 256)) "$2"
}
npy 100 hundred.npy
npy 10000000 endless.npy
measured "$program" render hundred.toml --positions hundred.npy -o hundred --frames 97:99 --overwrite
short_memory=$memory
measured "$program" render endless.toml --positions endless.npy -o endless --frames 9999997: --overwrite
echo "memory: $short_memory KB for 100 frames, $memory KB for 10,000,000"
[ "$memory" -lt $((short_memory + 8192)) ] || fail "memory grows with the file"

echo "== 3840 x 2160"
for way in --quiet --compact; do
    measured "$program" render seed --size 3840x2160 --frames 3:5 -o large --overwrite --no-error $way
    echo "memory: $memory KB $way"
    [ "$memory" -lt 153600 ] || fail "more than 150 MiB"
done

echo "== 10,000 ropes"
scene 3 10000 4 > ropes.toml
measured "$program" render ropes.toml -o ropes --no-error
cat out
echo "memory: $memory KB"
measured "$program" verify ropes

echo "== a rope of a million masses"
scene 3 1 1000000 | sed 's/direct_projection/symplectic_euler/; s/^damping.*/stiffness = 0.001/' > masses.toml
measured "$program" render masses.toml -o masses --no-error
cat out
echo "memory: $memory KB"
measured "$program" verify masses

echo "== a path of about 4,000 characters"
deep=$folder
while [ ${#deep} -lt 3850 ]; do deep=$deep/$(printf 'd%.0s' $(seq 100)); done
mkdir -p "$deep"
measured "$program" render short.toml --frames 0:2 -o "$deep/frames" --no-error
measured "$program" verify "$deep/frames"
echo "${#deep} characters and the frame's name"
while [ ${#deep} -lt 4300 ]; do deep=$deep/$(printf 'd%.0s' $(seq 100)); done
if "$program" render short.toml --frames 0:2 -o "$deep/frames" 2> err; then fail "a path beyond the limit"; fi
[ "$(wc -l < err)" = 1 ] || fail "more than a line for a path that is too long"
cut -c 1-40 err

echo "== all commands for $seconds s"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1}
scene 6 2 8 > mixed.toml
sed 's/direct_projection/stormer_verlet/' mixed.toml > springs.toml
rounds=0
end=$((SECONDS + seconds))
while [ $SECONDS -lt $end ]; do
    rm -rf a b c
    measured "$sanitized" render mixed.toml -o a --jobs 1
    measured "$sanitized" render mixed.toml -o a --jobs 3 --resume
    measured "$sanitized" render mixed.toml -o b --jobs 2 --overwrite
    measured "$sanitized" diff a b --report r.html --json r.json --junit r.xml
    rm a/frame_0002.png
    measured "$sanitized" verify a --repair --jobs 2
    diff -r a b || fail "repaired frames differ"
    measured "$sanitized" simulate mixed.toml -o a.csv --diagnostics d.csv
    measured "$sanitized" simulate mixed.toml -o a.npy
    measured "$sanitized" render mixed.toml -o c --positions a.npy --overwrite
    measured "$sanitized" compare mixed.toml -o c --overwrite
    measured "$sanitized" plan mixed.toml --tolerance 1 --write planned.toml
    measured "$sanitized" sweep mixed.toml --vary steps_per_frame=4,8 --clips --jobs 2 -o d --overwrite
    measured "$sanitized" study stability springs.toml --methods stormer_verlet -o e
    measured "$sanitized" study work-precision springs.toml --methods stormer_verlet -o e
    measured "$sanitized" submit mixed.toml -o f --shards 2 --dry-run
    for command in methods scenes "scenes bridge" doctor --version --help; do measured "$sanitized" $command; done
    rounds=$((rounds + 1))
done
echo "$rounds rounds of 20 commands, none failed"

# Programs that ropesim runs have no more open than those that this script runs.
if command -v gnuplot > /dev/null; then
    mkdir -p bin
    printf '#!/bin/sh\nls /proc/self/fd > "%s/open"\nexec %s "$@"\n' "$folder" "$(command -v gnuplot)" > bin/gnuplot
    chmod +x bin/gnuplot
    sh -c 'ls /proc/self/fd > open_here'
    PATH=$folder/bin:$PATH "$sanitized" compare mixed.toml -o c --overwrite --quiet
    cmp -s open open_here || fail "a descriptor is left to gnuplot: $(tr '\n' ' ' < open)"
    echo "no descriptor is left to other programs"
fi
