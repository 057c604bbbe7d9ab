#!/usr/bin/env bash
# Everything that is tested, on a machine with nothing but Python >= 3.11: finds or installs uv, a Chromium and
# a C compiler, then runs ruff, pyright and pytest, browser tests included. Fails when one of them cannot be had.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v uv >/dev/null 2>&1; then
    echo "installing uv with pip"
    python3 -m pip install --quiet --disable-pip-version-check uv
fi
uv() { if type -P uv >/dev/null; then command uv "$@"; else python3 -m uv "$@"; fi; }

find_browser() {
    local name
    for name in "${SOFTROD_BROWSER:-}" chromium chromium-browser google-chrome google-chrome-stable chrome; do
        if [ -n "$name" ] && command -v "$name" >/dev/null 2>&1; then
            command -v "$name"
            return
        fi
    done
    return 1
}

find_compiler() { command -v cc || command -v gcc || command -v clang; }

uv sync --quiet

# Exported programs in C are compiled and run.
if ! find_compiler >/dev/null; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null 2>&1; then
        echo "installing gcc with apt-get"
        apt-get update -qq
        DEBIAN_FRONTEND=noninteractive apt-get install -y -qq gcc libc6-dev >/dev/null
    fi
    find_compiler >/dev/null || {
        echo "no C compiler was found or could be installed: install gcc" >&2
        exit 1
    }
fi

if ! find_browser >/dev/null; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null 2>&1; then
        echo "installing Chromium with apt-get"
        apt-get update -qq
        DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium >/dev/null
    else
        echo "installing Chromium with Playwright"
        uv run playwright install chromium
        SOFTROD_BROWSER=$(uv run python -c '
from playwright.sync_api import sync_playwright
with sync_playwright() as playwright:
    print(playwright.chromium.executable_path)')
    fi
fi
SOFTROD_BROWSER=$(find_browser) || {
    echo "no Chromium or Chrome was found, and none could be installed; the browser tests need one" >&2
    exit 1
}
export SOFTROD_BROWSER
echo "browser: $SOFTROD_BROWSER"

# The methods' machine code is made once, while the linters run, and not again by each process of the tests.
python=$(uv run python -c 'import sys; print(sys.executable)')
"$python" -m sim.compiling.precompile all >/dev/null &
compiling=$!
trap 'kill "$compiling" 2>/dev/null || true' EXIT
uv run ruff check .
uv run ruff format --check .
uv run pyright
uv run python -m tests.page.check
wait "$compiling"
uv run pytest --numprocesses=2 --dist=loadfile tests/sim tests/app "$@"

# Once more as on a processor without anything special, with a cache of its own. That is compiled while the
# browser tests, which mostly wait, are running.
generic=$(mktemp -d)
trap 'kill "$compiling" 2>/dev/null || true; rm -rf "$generic"' EXIT
as_generic() { NUMBA_CPU_NAME=generic XDG_CACHE_HOME="$generic" "$@"; }
as_generic nice -n 19 "$python" -m sim.compiling.precompile all >/dev/null &
compiling=$!
uv run pytest tests/browser "$@"
wait "$compiling"
as_generic "$python" -m pytest --numprocesses=2 --dist=loadfile tests/sim/test_parity.py \
    tests/sim/test_physics.py tests/sim/test_simulation.py tests/sim/test_stability.py tests/sim/test_limits.py
