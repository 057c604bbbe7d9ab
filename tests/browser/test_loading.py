"""The first seconds of a page: nothing of viser's own is to be seen."""

from __future__ import annotations

from playwright.sync_api import Browser, Route, expect

from app.session.notices import Notice
from tests.browser.conftest import OpenPage, Serve

NOTES = """
  new MutationObserver((changes, observer) => {
    const goes = ({ removedNodes: [node] }) => node?.className === "softrod-loading";
    if (!changes.some(goes)) return;
    observer.disconnect();
    const seen = (selector) => document.querySelector(selector) !== null;
    window.atTheEnd = ["[role=tab]", ".softrod-transport", "canvas"].map(seen);
  }).observe(document, { childList: true, subtree: true });
"""
"""Notes what there is when the loading page goes."""

TRANSFERRED = """() => ["navigation", "resource"]
  .flatMap((kind) => performance.getEntriesByType(kind))
  .reduce((sum, one) => sum + one.transferSize, 0)"""
"""Bytes of a page and of all that it loaded, as they came; what the browser still had counts nothing."""


def test_a_page_says_that_it_is_loading_until_body_and_panel_are_there(
    browser: Browser, serve: Serve
) -> None:
    context = browser.new_context()
    page = context.new_page()
    page.add_init_script(NOTES)
    held: list[Route] = []
    # Its script does not come yet.
    page.route("**/main.js", lambda route: held.append(route))

    page.goto(serve("ring").url, wait_until="commit")
    expect(page.get_by_role("status").get_by_text("Loading…")).to_be_visible()
    expect(page.get_by_role("status").get_by_role("heading", name="softrod")).to_be_visible()
    assert page.title() == "softrod"
    assert page.locator("#root *").count() == 0
    page.wait_for_timeout(300)
    held[0].continue_()
    expect(page.locator(".softrod-loading")).to_have_count(0, timeout=30_000)
    assert page.evaluate("window.atTheEnd") == [True, True, True]
    context.close()


def test_a_page_of_viser_s_that_it_does_not_know_says_so(browser: Browser, serve: Serve) -> None:
    context = browser.new_context()
    page = context.new_page()
    page.add_init_script("Object.defineProperty(window, '__viserMutable', { get: () => ({}), set() {} })")
    page.goto(serve("ring").url)
    page.get_by_role("alert").get_by_text("This page cannot draw").wait_for()
    context.close()


def test_a_page_that_does_not_arrive_whole_says_so_and_loads_again(browser: Browser, serve: Serve) -> None:
    context = browser.new_context()
    page = context.new_page()
    page.route("**/viser.txt", lambda route: route.abort(), times=1)
    page.goto(serve("ring").url)
    alert = page.get_by_role("alert")
    expect(alert).to_contain_text("The page did not arrive whole")
    alert.get_by_role("button", name="Reload").click()
    expect(page.locator(".softrod-loading")).to_have_count(0, timeout=30_000)
    context.close()


def test_another_language_is_loaded_without_what_all_languages_share(browser: Browser, serve: Serve) -> None:
    context = browser.new_context()
    page = context.new_page()
    served = serve("ring")
    sizes: list[tuple[str, int]] = []
    for tag in ("en", "de"):
        page.goto(f"{served.url}?lang={tag}")
        expect(page.locator(".softrod-loading")).to_have_count(0, timeout=30_000)
        sizes.append((page.locator("html").get_attribute("lang") or "", page.evaluate(TRANSFERRED)))
    (_, first), (now, then) = sizes
    assert now == "de"
    assert then < 60_000 < 600_000 < first, "bytes as they come, packed"
    context.close()


OF_VISER = """() => {
  const canvas = window.__softrod.canvas();
  const seen = (one) => one.checkVisibility() && one.getBoundingClientRect().width > 0;
  const isOurs = (one) => one.closest("[class^='softrod-']:not(main)") !== null;
  const isCanvas = (one) => one.contains(canvas) || one.matches("canvas[width='0']");
  return [...document.querySelectorAll("#root *, [class*='mantine-'], [data-portal] *")]
    .filter((one) => seen(one) && !isOurs(one) && !isCanvas(one)).map((one) => one.outerHTML.slice(0, 120));
}"""
"""What is to be seen of viser's page besides its canvas."""


def test_nothing_of_viser_s_page_is_seen_but_its_canvas(open_page: OpenPage) -> None:
    desk = open_page("ring")
    assert not desk.page.evaluate(OF_VISER)
    desk.tab.notify(Notice("warning", "Take care", "A notice."))
    desk.until(lambda: desk.notices(), "a notice is up")
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_role("option").filter(has_text="Help").first.click()
    desk.page.get_by_role("dialog").wait_for()
    desk.pause(0.2)
    assert not desk.page.evaluate(OF_VISER)
    # It can be seen that the test would find it.
    desk.page.evaluate("document.querySelector('#root').append(document.createElement('button'))")
    assert desk.page.evaluate(OF_VISER)
