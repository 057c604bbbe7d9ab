#!/usr/bin/env bash
# Runs the tests of the solver and of the studies as on other processors, where sums are rounded in other ways:
#   generic  kernels of any processor of this kind: two numbers at a time, nothing fused on x86-64
#   old      a processor of 2008: no AVX and no fused multiply-add in kernels, libm, NumPy and BLAS
#   wide     one of 2013, as most are: four numbers at a time, fused
#   unfused  this one without fused multiply-add in kernels
# Usage: tests/processors.sh [generic|old|wide|unfused]...; without a word, all of them.
# Each compiles kernels of its own. All tests run with today's random numbers, then those that draw some with the
# numbers of two other days; SOFTROD_DAYS="20000 20001" names other days.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

unset SOFTROD_NIGHT
today=$(($(date +%s) / 86400))
read -ra days <<<"${SOFTROD_DAYS:-$today $((today + 1)) $((today + 2))}"
mapfile -t random < <(grep -lE 'tests\.amount|hypothesis' tests/sim/test_*.py tests/studies/test_*.py)

uv() { if type -P uv >/dev/null; then command uv "$@"; else python3 -m uv "$@"; fi; }
python() { uv run python "$@"; }

# What a processor is made of: variables for the tests to run with.
settings_of() {
    case $1 in
    generic) echo NUMBA_CPU_NAME=generic ;;
    old)
        echo NUMBA_CPU_NAME=nehalem
        echo NUMBA_CPU_FEATURES=
        echo GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F
        echo OPENBLAS_CORETYPE=Nehalem
        python -c 'import numpy as np
print("NPY_DISABLE_CPU_FEATURES=" + " ".join(np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])))'
        ;;
    wide)
        echo NUMBA_CPU_NAME=haswell
        echo NUMBA_CPU_FEATURES=
        ;;
    unfused)
        python -c 'import llvmlite.binding as llvm
features = llvm.get_host_cpu_features()
features["fma"] = features["fma4"] = False
print("NUMBA_CPU_FEATURES=" + features.flatten())'
        ;;
    *)
        echo "there is no processor $1: generic, old, wide, unfused" >&2
        return 1
        ;;
    esac
}

# Says whether numba fuses; a setting that did nothing would make all that follows worthless.
FUSES='
import re, numba
fused = numba.njit("f8(f8, f8, f8)", fastmath={"contract"})(lambda a, b, c: a * b + c)
print("fused" if re.search("fn?m(add|sub|la|ls)", "".join(fused.inspect_asm().values())) else "unfused")'

kernels=$(mktemp -d)
trap 'rm -rf "$kernels"' EXIT

failed=()
[ $# -gt 0 ] || set -- generic old wide unfused
for processor in "$@"; do
    settings=$(settings_of "$processor")
    if [ "$processor" != generic ] && [ "$(uname -m)" != x86_64 ]; then
        echo "== $processor: left out, since it is an x86-64 processor, or one that fuses because all do"
        continue
    fi
    mapfile -t settings <<<"$settings"
    as() { uv run env "${settings[@]}" XDG_CACHE_HOME="$kernels/$processor" OPENBLAS_NUM_THREADS=1 "$@"; }
    found=$(as python -c "$FUSES")
    echo "== $processor ($found), after $SECONDS s"
    if [ "$(uname -m)" = x86_64 ] && [ "$found" != "$([ "$processor" = wide ] && echo fused || echo unfused)" ]; then
        echo "numba does not compile for it" >&2
        exit 1
    fi
    as python -m sim.compiling.precompile all >/dev/null
    chosen=(tests/sim tests/studies)
    for day in "${days[@]}"; do
        echo "== $processor, day $day, after $SECONDS s"
        as env SOFTROD_DAY="$day" pytest --numprocesses=2 --dist=loadfile "${chosen[@]}" ||
            failed+=("$processor, day $day")
        chosen=("${random[@]}")
    done
done
if [ ${#failed[@]} -gt 0 ]; then
    printf '== failed: %s\n' "${failed[@]}" >&2
    exit 1
fi
