#!/usr/bin/env bash
# What has to be green, on a machine with nothing but Python >= 3.11: finds or installs uv, a Chromium, a C
# compiler, nginx and Caddy, then runs ruff, pyright and all tests, in the page's language and in a browser, too.
# Fails when one of them cannot be had.
# What can be seen without the solver comes first, while that is compiled.
# With --night it runs all of the long random tests instead of a part, those of the solver on other processors,
# too, breaks the code to see what the tests find, and finds or installs a Firefox. Whatever else it is given goes
# to pytest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Where bytecode is not kept, each of some hundred processes compiles all packages anew.
unset PYTHONDONTWRITEBYTECODE

night=
if [ "${1:-}" = --night ]; then
    night=yes
    export SOFTROD_NIGHT=1
    shift
fi

part() { echo "== $1, after $SECONDS s"; }

find_compiler() { command -v cc || command -v gcc || command -v clang; }
find_proxy() { PATH="$PATH:/usr/sbin:/usr/local/sbin" type -P "$1"; }
find_firefox() { command -v "${SOFTROD_FIREFOX:-firefox-esr}" || command -v firefox; }
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
fail() {
    echo "$1" >&2
    exit 1
}

# Exported programs in C are compiled and run; servers behind a proxy are tested with these two, as they are
# installed from packages; exported files are tried in Firefox, too, by day only where there is one, for it is
# large. What is missing is installed, where it may be, while the rest begins.
packages=()
find_compiler >/dev/null || packages+=(gcc libc6-dev)
for proxy in nginx caddy; do
    find_proxy "$proxy" >/dev/null || packages+=("$proxy")
done
find_browser >/dev/null || packages+=(chromium)
[ -z "$night" ] || find_firefox >/dev/null || packages+=(firefox-esr)
if [ ${#packages[@]} -gt 0 ] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null 2>&1; then
    echo "installing ${packages[*]} with apt-get"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "${packages[@]}" >/dev/null 2>&1; } ||
        echo "apt-get could not install ${packages[*]}" >&2 &
    installing=$!
fi

if ! command -v uv >/dev/null 2>&1; then
    echo "installing uv with pip"
    python3 -m pip install --quiet --disable-pip-version-check uv
fi
uv() { if type -P uv >/dev/null; then command uv "$@"; else python3 -m uv "$@"; fi; }
uv sync --quiet

# The methods' machine code is made once, and not again by each process of the tests.
part "compiling the solver; linters, scripts, and tests that need no solver"
python=$(uv run python -c 'import sys; print(sys.executable)')
logs=$(mktemp -d)
"$python" -c 'from sim.compiling.compiler import Compiler
compiler = Compiler()
compiler.start()  # in two processes
compiler.wait()' &
compiling=$!
uv run pyright >"$logs/types" 2>&1 &
checking=$!
trap 'kill "$compiling" "$checking" 2>/dev/null || true; rm -rf "$logs"' EXIT
uv run ruff check .
uv run ruff format --check .
uv run python -m tests.page.check scripts
mapfile -t early <tests/early.txt
uv run pytest "$@" "${early[@]}"
wait "$checking" || { cat "$logs/types" && false; }
part "compiling the rest"
wait "$compiling"

[ -z "${installing:-}" ] || wait "$installing"
find_compiler >/dev/null || fail "no C compiler was found or could be installed: install gcc"
for proxy in nginx caddy; do
    find_proxy "$proxy" >/dev/null || fail "no $proxy was found or could be installed: install $proxy"
done
[ -z "$night" ] || find_firefox >/dev/null ||
    fail "no Firefox was found or could be installed: install it, or name it in SOFTROD_FIREFOX"
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
SOFTROD_BROWSER=$(find_browser) || fail "no Chromium or Chrome was found or could be installed, and the browser\
 tests need one: install one, and set SOFTROD_BROWSER to its path if it has another name"
export SOFTROD_BROWSER
echo "browser: $SOFTROD_BROWSER"

# Three processes for two processors, since a browser's test waits now and then. The small files of the solver come
# last, so that all end at about the same time; those of `app` come before those of the browser, whose driver has an
# event loop of its own running from then on.
part "tests"
uv run pytest --numprocesses=3 --dist=loadfile --no-loadscope-reorder "${early[@]/#/--ignore=}" "$@" \
    tests/app tests/browser tests/studies tests/sim
part "models"
uv run python -m tests.page.check models

if [ -n "$night" ]; then
    part "the solver on other processors"
    bash tests/processors.sh
    part "broken code"
    uv run python -m tests.mutants --night
fi
part "done"
