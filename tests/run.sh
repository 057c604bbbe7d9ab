#!/usr/bin/env bash
# What has to be green, on a machine with nothing but Python >= 3.11: finds or installs uv, a Chromium, a C
# compiler, nginx and Caddy, then runs ruff, pyright and pytest, browser tests included. Fails when one of them
# cannot be had.
# With --night it runs all of the long random tests instead of a part, the solver's once more as on a processor
# without anything special, and finds or installs a Firefox. Whatever else it is given goes to pytest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

night=
if [ "${1:-}" = --night ]; then
    night=yes
    export SOFTROD_NIGHT=1
    shift
fi

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

# Packages of the system, where they may be installed; whoever needs them looks for them afterwards.
install() {
    if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null 2>&1; then
        return
    fi
    echo "installing $* with apt-get"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$@" >/dev/null; } ||
        echo "apt-get could not install $*" >&2
}

uv sync --quiet

# Exported programs in C are compiled and run.
find_compiler >/dev/null || install gcc libc6-dev
find_compiler >/dev/null || {
    echo "no C compiler was found or could be installed: install gcc" >&2
    exit 1
}

# Servers behind a proxy are tested with these, as they are installed from packages.
for proxy in nginx caddy; do
    find_proxy() { PATH="$PATH:/usr/sbin:/usr/local/sbin" type -P "$proxy"; }
    find_proxy >/dev/null || install "$proxy"
    find_proxy >/dev/null || {
        echo "no $proxy was found or could be installed: install $proxy" >&2
        exit 1
    }
done

# Exported files are tried in Firefox, too; by day only where there is one, for it is large.
find_firefox() { command -v "${SOFTROD_FIREFOX:-firefox-esr}" || command -v firefox; }
if [ -n "$night" ] && ! find_firefox >/dev/null; then
    install firefox-esr
    find_firefox >/dev/null || {
        echo "no Firefox was found or could be installed: install it, or name it in SOFTROD_FIREFOX" >&2
        exit 1
    }
fi

find_browser >/dev/null || install chromium
if ! find_browser >/dev/null; then
    echo "installing Chromium with Playwright"
    if uv run playwright install chromium; then
        SOFTROD_BROWSER=$(uv run python -c '
from playwright.sync_api import sync_playwright
with sync_playwright() as playwright:
    print(playwright.chromium.executable_path)')
    else
        echo "Playwright could not install Chromium" >&2
    fi
fi
SOFTROD_BROWSER=$(find_browser) || {
    echo "no Chromium or Chrome was found or could be installed, and the browser tests need one: install one, and" \
        "set SOFTROD_BROWSER to its path if it has another name" >&2
    exit 1
}
export SOFTROD_BROWSER
echo "browser: $SOFTROD_BROWSER"

part() { echo "== $1, after $SECONDS s"; }

# The methods' machine code is made once, while the linters run, and not again by each process of the tests.
part "linters, compiling the solver"
python=$(uv run python -c 'import sys; print(sys.executable)')
"$python" -m sim.compiling.precompile all >/dev/null &
compiling=$!
trap 'kill "$compiling" 2>/dev/null || true' EXIT
uv run ruff check .
uv run ruff format --check .
uv run pyright
uv run python -m tests.page.check
part "compiling the rest"
wait "$compiling"

# In the order of their names: browser tests, which mostly wait, stand between those of `app` and `sim`, and
# the small files of `sim` and of the studies come last.
part "tests"
uv run pytest --numprocesses=2 --dist=loadfile --no-loadscope-reorder "$@" tests

if [ -n "$night" ]; then
    part "the solver on a generic processor"
    generic=$(mktemp -d)
    trap 'rm -rf "$generic"' EXIT
    NUMBA_CPU_NAME=generic XDG_CACHE_HOME="$generic" uv run pytest --numprocesses=2 --dist=loadfile \
        tests/sim/test_parity.py tests/sim/test_physics.py tests/sim/test_simulation.py \
        tests/sim/test_stability.py tests/sim/test_limits.py
fi
part "done"
