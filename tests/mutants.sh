#!/usr/bin/env bash
# Whether the tests notice mistakes: a seeded sample of the mutants that cargo-mutants makes of the generator's stages and of
# the runtime. Fails if fewer than nine in ten of those that compile are caught, and lists the survivors.
# usage: mutants.sh [COUNT] [SEED]; COUNT of each package (100). Takes hours; `MUTANTS_JOBS=4` takes more processors.
set -euo pipefail

cd "$(dirname "$0")/.."
count=${1:-100} seed=${2:-1}
work=${CARGO_TARGET_DIR:-$PWD/target}/mutants
mkdir -p "$work"

if ! cargo mutants --version >/dev/null 2>&1; then
    cargo install --quiet --locked --root "$work/tools" cargo-mutants
    PATH=$work/tools/bin:$PATH
fi

# Tries a sample of the mutants of some files of a package, with the tests of some packages. The sample is a shard: every
# so-manyth mutant, the seed says from which one on.
try() {
    local package=$1 tests=$2; shift 2
    local files=() packages=() total shards
    for file in "$@"; do files+=(--file "$file"); done
    for name in $tests; do packages+=(--test-package "$name"); done
    total=$(cargo mutants --list --package "$package" "${files[@]}" | wc -l)
    shards=$(((total + count - 1) / count))
    rm -rf "${work:?}/$package"
    mkdir -p "$work/$package"
    cargo mutants --package "$package" "${files[@]}" "${packages[@]}" --all-features --shard "$((seed % shards))/$shards" --sharding round-robin \
        --output "$work/$package" --jobs "${MUTANTS_JOBS:-1}" --timeout 300 --colors never || true
    judge "$package"
}

judge() {
    local out=$work/$1/mutants.out caught missed timeout
    caught=$(wc -l < "$out/caught.txt") missed=$(wc -l < "$out/missed.txt") timeout=$(wc -l < "$out/timeout.txt")
    echo "$1: $caught caught, $timeout without an end, $missed missed, $(wc -l < "$out/unviable.txt") do not compile"
    sed 's/^/  missed: /' "$out/missed.txt"
    [ $(((caught + timeout) * 10)) -ge $(((caught + timeout + missed) * 9)) ] || failed=1
}

failed=0
try mavgen "mavgen mavlink-conformance" 'mavgen/src/resolve/**' 'mavgen/src/lower/**' 'mavgen/src/emit/**'
try mavlink-wire "mavlink-wire mavlink-conformance" 'mavlink-wire/src/**'
exit "$failed"
