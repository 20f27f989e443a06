"""The report in a real browser: looked at, clicked, turned, folded, printed, read aloud."""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import reduce
from operator import add, mul, truediv
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from click.testing import CliRunner
from firefox import FIREFOX, Firefox
from msgspec import structs
from sampling import every
from warm_cache import warm_cache

from symcheck.checker.__main__ import main

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page, Playwright

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SELECTION = ("mirer2009", "ignatov2005:2.1V", "ignatov2005:2.1E")
VIEWS = (
    "#errata",
    "#ledger",
    "#pictures",
    "#checks",
    "#review",
    "#mirer2009:2.12",
    "#mirer2009:2.17",
    "#ignatov2005:2.1V.2d",
)
WIDE, NARROW = {"width": 1280, "height": 900}, {"width": 360, "height": 740}
PATIENCE = 60_000  # milliseconds; a busy machine takes its time
CANVAS = "document.querySelector('#canvas').toDataURL()"
GO = "async (place) => { history.replaceState(null, '', place); await go(); }"  # as a link of the page does

pytestmark = pytest.mark.skipif(not CHROMIUM, reason="no Chromium is found; `make browser` installs it")


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A page of one paper and two lists of another."""
    from symcheck.cli import cli

    folder = tmp_path_factory.mktemp("report")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SYMCHECK_CACHE", warm_cache(folder / "cache"))
        patch.chdir(folder)
        done = CliRunner().invoke(cli, ["report", "--jobs", "0", *SELECTION], prog_name="symcheck")
    assert done.exit_code == 0, done.output
    return (folder / "symcheck-report.html").as_uri()


@pytest.fixture(scope="module")
def playwright() -> Iterator[Playwright]:
    from playwright.sync_api import sync_playwright

    with sync_playwright() as found:
        yield found


@pytest.fixture(scope="module")
def browser(playwright: Playwright) -> Iterator[Browser]:
    arguments = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    found = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
    yield found
    found.close()


class Windows:
    """Opens the page at a place of it, and keeps what the console or the network says."""

    def __init__(self, browser: Browser, address: str) -> None:
        self.browser, self.address = browser, address
        self.said: list[str] = []
        self.shared: dict[str, Page] = {}

    def new(self, place: str = "", before: str = "", **options: Any) -> Page:
        context = self.browser.new_context(**{"viewport": WIDE, **options})
        context.add_init_script(before)
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        page.on("console", lambda message: self.said.append(f"{message.type}: {message.text}"))
        page.on("pageerror", lambda error: self.said.append(str(error)))
        page.on("request", lambda request: self.outside(request.url))
        page.goto(self.address + place)
        if options.get("java_script_enabled", True):
            page.wait_for_selector("html[data-ready]", state="attached")
        return page

    def same(self, place: str, **options: Any) -> Page:
        if (page := self.shared.get(repr(options))) is None:
            page = self.shared[repr(options)] = self.new(place, **options)
        page.evaluate(GO, place)
        return page

    def outside(self, url: str) -> None:
        if not url.startswith(("file:", "data:", "blob:")):
            self.said.append(f"asked for {url}")


@pytest.fixture(scope="module")
def windows(browser: Browser, address: str) -> Windows:
    return Windows(browser, address)


@pytest.fixture
def seen(windows: Windows) -> Iterator[Callable[..., Page]]:
    """Show a place on the page that tests share which leave nothing behind; what the console says fails the test."""
    windows.said.clear()
    yield windows.same
    assert windows.said == []


@pytest.fixture
def opened(windows: Windows) -> Iterator[Callable[..., Page]]:
    """Open a place on a page of its own."""
    windows.said.clear()
    before = list(windows.browser.contexts)
    yield windows.new
    for context in windows.browser.contexts:
        if context not in before:
            context.close()
    assert windows.said == []


@pytest.fixture(scope="module")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    if not FIREFOX:
        pytest.skip("no Firefox is found; `make browser` installs it")
    with Firefox(tmp_path_factory.mktemp("firefox")) as found:
        yield found


def title(page: Page, start: str) -> None:
    """Wait until the claim is shown whose title begins so."""
    page.locator("#claim-title").filter(has_text=re.compile(f"^{re.escape(start)}")).wait_for()


def shown(page: Page) -> list[str]:
    page.locator("#ledger-title").wait_for()
    page.locator("#rows:not([aria-busy])").wait_for(state="attached")
    return page.locator("#rows li:visible > a").all_text_contents()  # of rows that are not drawn yet, too


@pytest.mark.parametrize("place", VIEWS)
@pytest.mark.parametrize("size", [pytest.param(WIDE, marks=pytest.mark.slow), NARROW], ids=["wide", "narrow"])
def test_nothing_reaches_beyond_the_window(seen: Callable[..., Page], place: str, size: dict[str, int]) -> None:
    page = seen(place, viewport=size)
    assert page.evaluate("document.documentElement.scrollWidth") == size["width"]


@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.slow)])
@pytest.mark.parametrize("place", every(3, VIEWS))
def test_there_is_no_obstacle_for_anybody(seen: Callable[..., Page], place: str, scheme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    page = seen(place, color_scheme=scheme, bypass_csp=True)
    found = Axe().run(page).response["violations"]
    assert [(each["id"], each["nodes"][0]["html"]) for each in found] == []


@pytest.mark.parametrize("place", ["#mirer2009:2.12", pytest.param("#mirer2009:2.13.1c", marks=pytest.mark.slow)])
def test_nor_is_there_in_what_is_folded_out(opened: Callable[..., Page], place: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    page = opened(place, bypass_csp=True)
    page.evaluate(DROP, ["000_52559675eaf93e59.txt", "a line\n" * 400])
    page.locator(".context .lines").wait_for()
    for fold in page.locator("#view-claim > div > section > details, .meanings").all():
        fold.locator("> summary").click()
    page.locator(".steps").first.wait_for()
    found = Axe().run(page).response["violations"]
    assert [(each["id"], each["nodes"][0]["html"]) for each in found] == []


def test_nor_is_there_in_what_comes_and_goes(opened: Callable[..., Page]) -> None:
    """The keys, what is found first, an unknown place, a damaged formula, what a point of the graph says, notes."""
    from axe_playwright_python.sync_playwright import Axe

    def faults() -> list[tuple[str, str]]:
        found = Axe().run(page).response["violations"]
        return [(each["id"], each["nodes"][0]["html"]) for each in found]

    page = opened("#ledger", bypass_csp=True)
    page.get_by_label("Search").fill("(2.12)")
    page.locator("#best li").first.wait_for()
    assert faults() == []
    page.locator("#ledger-title").click()
    page.keyboard.press("?")
    page.get_by_role("dialog").wait_for()
    assert faults() == []
    page.get_by_role("button", name="Close").click()
    page.evaluate(GO, "#mirer2009:2.71")
    page.get_by_role("status").filter(has_text="There is no").wait_for()
    assert faults() == []
    page.evaluate(GO, "#pictures")
    page.locator("details.graph:not([open])").filter(has_text="mirer2009").locator("summary").click()
    page.locator('.arcs a[href="#mirer2009:2.12"]').focus()
    page.get_by_role("tooltip").locator("math").wait_for()
    assert faults() == []
    page.evaluate(GO, "#mirer2009:1.2.4")
    noted(page, "A note")
    page.evaluate(GO, "#review")
    page.locator("#notes").get_by_role("link", name="mirer2009:1.2.4").wait_for()
    assert faults() == []


AXE = """const [source, done] = arguments;
new Function(source)();
axe.run().then((found) => done(found.violations.map((each) => [each.id, each.nodes[0].html])));"""
UNFOLDED = "[...document.querySelectorAll('details.proof')].every((each) => each.querySelector('.steps,pre'))"
READY = "document.documentElement.dataset.ready"


@pytest.mark.parametrize("place", every(3, VIEWS))
def test_firefox_shows_every_view_without_an_error_or_an_obstacle(firefox: Firefox, address: str, place: str) -> None:
    from axe_playwright_python.base import AXE_SCRIPT

    firefox.open(address + place)
    firefox.when(READY)
    headings = "return [...document.querySelectorAll('h1')].filter((each) => each.checkVisibility()).length"
    assert firefox.run(headings) == 1
    assert firefox.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth") == 0
    assert firefox.answer(AXE, AXE_SCRIPT) == []
    firefox.run("document.querySelectorAll('details.proof').forEach((each) => { each.open = true; })")
    firefox.when(UNFOLDED)
    assert firefox.errors() == []


def test_firefox_searches_keeps_notes_and_saves_what_the_checker_accepts(firefox: Firefox, address: str) -> None:
    firefox.open(f"{address}#ledger")
    firefox.when(READY)
    firefox.type("[name=text]", "(2.12)")
    firefox.when("document.querySelectorAll('#best li').length === 1")
    firefox.click("#best li > a")
    firefox.when("document.querySelector('#claim-title')?.textContent.startsWith('mirer2009:2.12')")
    firefox.type(".own textarea", "Is A proper?")
    firefox.click("button.download")
    file = firefox.saved()
    assert main([str(file)]) == 0
    firefox.open(f"{address}#review")
    firefox.when(READY)
    assert "Is A proper?" in firefox.run("return document.querySelector('#notes').textContent")
    assert firefox.errors() == []


def test_firefox_tells_what_goes_wrong_in_a_page(firefox: Firefox, tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text("<script>Promise.reject(new Error('late')); nowhere();</script>", encoding="utf-8")
    firefox.open(file.as_uri())
    assert sorted("nowhere" in each or "late" in each for each in firefox.errors()) == [True, True]


def test_the_counts_are_those_of_the_ledger(seen: Callable[..., Page]) -> None:
    page = seen("#errata")
    told = [(link.inner_text().split()[0], link.get_attribute("href")) for link in page.locator(".counts td a").all()]
    assert told
    for count, target in told:
        seen(target)
        assert len(shown(page)) == int(count.replace(",", ""))
        assert page.locator("#count").inner_text().split(" of ")[0] == count


def test_the_search_finds_numbers_words_and_latex(seen: Callable[..., Page]) -> None:
    page = seen("#ledger")
    everything = shown(page)
    search = page.get_by_label("Search")
    for text, expected in (("2009:2.12", "2.12"), ("six cases", "2.17"), ("a_{11} a_{31} + I_2", "2.12")):
        search.fill(text)
        found = shown(page)
        assert expected in found
        assert len(found) < len(everything) / 4
    search.fill("there is no such thing")
    assert shown(page) == []
    page.get_by_role("button", name="Clear").click()
    page.get_by_text(f"{len(everything)} of {len(everything)} items").wait_for()
    assert shown(page) == everything


def test_the_search_puts_first_what_is_asked_for(seen: Callable[..., Page]) -> None:
    page = seen("#ledger")
    order = shown(page)
    for text, first in (
        ("(2.12)", ["2.12"]),
        ("eq. 2.12", ["2.12"]),
        ("Eqs. (2.1)", ["2.1a", "2.1b"]),
        ("mirer2009:2.17", ["2.17"]),
        ("2.1", ["2.1a", "2.1b"]),
    ):
        page.get_by_label("Search").fill(text)
        assert shown(page)[: len(first)] == first, text
        told = page.locator("#best li > a").first.evaluate("(link) => getComputedStyle(link, '::after').content")
        assert told == '"mirer2009"', text
    page.get_by_label("Search").fill("refuted")
    refuted = page.locator("#rows li:visible .badge.refuted").count()
    assert page.locator("#best li:visible .badge").all_inner_texts() in ([], ["refuted"] * refuted)
    page.get_by_label("Search").fill("sign error")
    assert "2.1.1" not in shown(page)
    assert all("sign" in kind for kind in page.locator("#best li:visible .end div").all_inner_texts())
    page.get_by_label("Search").fill("J_1 J_3")
    assert "2.12" in shown(page)
    page.get_by_label("Search").fill("")
    assert shown(page) == order


def test_an_unknown_place_is_said_with_the_nearest(seen: Callable[..., Page]) -> None:
    for place, nearest in (
        ("#mirer2009:2.71", "mirer2009:2.7"),
        ("#mirer209:2.12", "mirer2009:2.12"),
        ("#2.12", "mirer2009:2.12"),
        ("#(2.12)", "mirer2009:2.12"),
        ("#%", "errata"),
    ):
        page = seen(place)
        notice = page.get_by_role("status").filter(has_text="There is no")
        assert place.removeprefix("#") in notice.inner_text()
        near = notice.get_by_role("link").all_inner_texts()
        assert any(each.startswith(nearest) for each in near) or nearest == "errata", near
        notice.get_by_role("link").first.click()
        notice.wait_for(state="hidden")


def test_single_keys_search_walk_and_can_be_switched_off(opened: Callable[..., Page]) -> None:
    page = opened("#errata")
    page.keyboard.press("/")
    page.locator("[name=text]:focus").wait_for()
    page.keyboard.type("2.12/?")
    assert page.locator("[name=text]").input_value() == "2.12/?"
    page.keyboard.press("Control+A")
    page.keyboard.type("2.12")
    page.locator("#ledger-title").click()
    page.keyboard.press("j")
    page.keyboard.press("j")
    page.keyboard.press("k")
    page.keyboard.press("Enter")
    title(page, "mirer2009:2.12")
    page.keyboard.press("n")
    title(page, "mirer2009:2.13.1c")
    page.keyboard.press("p")
    title(page, "mirer2009:2.9.1")
    before = page.get_by_role("link", name="← previous").get_attribute("href")
    page.keyboard.press("k")
    title(page, str(before).removeprefix("#"))
    page.keyboard.press("?")
    page.get_by_role("dialog").get_by_label("use single keys").uncheck()
    page.get_by_role("button", name="Close").click()
    before = page.locator("#claim-title").inner_text()
    page.keyboard.press("j")
    assert page.locator("#claim-title").inner_text() == before


def test_a_claim_says_of_which_paper_it_is(seen: Callable[..., Page]) -> None:
    place = seen("#mirer2009:2.12").locator(".crumbs").inner_text()
    assert place.startswith("S. A. Mirer, On some extremal relations between inertia tensor elements")
    assert "(Keldysh Institute of Applied Mathematics, preprint 55, Moscow 2009, 14 pages) · section 2 " in place


def test_the_general_form_is_set_as_a_formula(seen: Callable[..., Page]) -> None:
    page = seen("#ignatov2005:2.1V.1b")
    assert page.locator(".general").inner_text() == "with hmax restored:"
    assert page.locator(".general ~ p math").count() > 0
    assert "h" in str(page.locator(".general ~ p math").first.text_content())
    page = seen("#ignatov2005:2.1V.2d")
    assert page.locator(".general").inner_text().endswith("it is a long formula: symcheck show ignatov2005:2.1V.2d")
    page = seen("#mirer2009:1.2.3a")
    assert page.locator(".general").count() == 0


def test_a_claim_says_what_its_letters_mean(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    said = page.locator(".letters li").all_inner_texts()
    assert len(said) == 3
    assert any("principal central moments of inertia, kg m" in each for each in said)


@pytest.mark.slow
def test_every_view_has_one_heading_of_the_first_level(seen: Callable[..., Page]) -> None:
    for place in VIEWS:
        page = seen(place)
        levels = page.locator("h1:visible,h2:visible,h3:visible").evaluate_all("all => all.map((each) => each.tagName)")
        assert levels.count("H1") == 1, place
        assert levels[0] == "H1", place


def test_filters_narrow_together_and_stay_when_one_comes_back(seen: Callable[..., Page]) -> None:
    page = seen("#ledger")
    page.get_by_label("Verdict or role").select_option("refuted")
    page.locator("[name=paper]").select_option("ignatov2005")
    found = shown(page)
    assert "2.1V.2d" in found
    assert page.locator("#rows li:visible .badge.refuted").count() == len(found)
    page.locator("#rows li:visible > a").first.click()
    page.get_by_role("link", name="next →").click()
    title(page, f"ignatov2005:{found[1]}")
    page.locator(".pager").get_by_role("link", name="Ledger").click()
    assert shown(page) == found
    assert page.locator("[name=paper]").input_value() == "ignatov2005"


def test_a_deep_link_shows_its_claim_typeset_with_its_difference_marked(opened: Callable[..., Page]) -> None:
    page = opened("#mirer2009:2.13.1c")
    assert page.title().startswith("mirer2009:2.13.1c")
    assert page.locator("#view-claim math").count() > 3
    assert page.locator("#view-claim .del").all_text_contents() == ["J", "J", "J"]
    assert page.locator("#view-claim .ins").all_text_contents() == ["I", "I", "I"]
    assert page.evaluate("document.fonts.check('16px \"STIX Two Math\"')")


def test_a_prime_that_was_lost_is_marked_where_it_can_be_seen(seen: Callable[..., Page]) -> None:
    box = seen("#ignatov2005:2.1E.9a").locator("#view-claim .tml-prime.ins").bounding_box()
    assert box
    assert min(box["width"], box["height"]) > 10


def test_a_claim_says_whether_coq_confirms_it_and_the_ledger_finds_those_alike(seen: Callable[..., Page]) -> None:
    from symcheck.audit.decide import decide
    from symcheck.coq.confirmed import sentence, summary

    for id in ("mirer2009:2.12", "mirer2009:2.13.1c"):
        record = next(record for record in decide(id.rstrip("abc")) if record.id == id)
        said = summary(record)
        assert said
        page = seen(f"#{id}")
        assert page.locator("#view-claim .facts").inner_text().endswith(sentence(record))
        page = seen("#ledger")
        everything = len(shown(page))
        page.get_by_label("Confirmed by Coq").select_option(said)
        assert page.locator(f'#rows li:visible > a[href="#{id}"]').count() == 1
        assert len(shown(page)) < everything


def test_links_lead_to_what_a_claim_uses_and_back(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    page.locator(".depends").get_by_role("link", name="2.11", exact=True).click()
    title(page, "mirer2009:2.11")
    page.locator(".depends").get_by_role("link", name="2.12", exact=True).click()
    page.go_back()
    title(page, "mirer2009:2.11")


def test_a_certificate_unfolds_and_the_checker_accepts_what_is_downloaded(
    seen: Callable[..., Page], tmp_path: Path
) -> None:
    for place in ("mirer2009:2.12", "mirer2009:2.1a", "mirer2009:2.17"):
        page = seen(f"#{place}")
        page.locator("details.proof summary").first.click()
        page.get_by_text("Certificate as JSON").first.click()
        assert json.loads(page.locator("details.proof pre").first.inner_text())["id"].startswith("mirer2009:")
        with page.expect_download() as waiting:
            page.get_by_role("button", name="Download as JSON").click()
        file = tmp_path / waiting.value.suggested_filename
        waiting.value.save_as(file)
        assert main([str(file)]) == 0


def test_a_proof_is_set_as_formulas_with_each_hypothesis_beside_its_multiplier(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    page.locator("details.proof summary").first.click()
    rows = page.locator(".multipliers tbody tr:has(td)")
    rows.nth(7).wait_for()
    assert rows.count() == 8
    assert [row.locator("td > .formula math").count() for row in rows.all()] == [2] * 8
    assert page.locator(".multipliers tbody th").all_inner_texts() == [
        "A is orthogonal: its rows, and its columns, are orthonormal"
    ]
    assert "orthogonal [" not in page.locator(".steps").inner_text()


def test_every_proof_can_be_set_and_no_multiplier_is_left_as_text(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    found = page.evaluate("""async () => {
        const told = {proofs: 0, formulas: 0, left: []};
        for (const paper of new Set(entries.map((entry) => entry.paper))) {
            const {proofs, words} = await proofsOf(paper);
            for (const {certificate} of proofs) {
                const steps = proofSteps(certificate, words), text = steps.textContent;
                told.proofs++;
                told.formulas += steps.querySelectorAll("math").length;
                if (/undefined|NaN|\\[object/.test(text) || steps.querySelector("code,.rule:empty"))
                    told.left.push([certificate.id, text.slice(0, 300)]);
            }
        }
        return told;
    }""")
    assert found["left"] == []
    assert found["proofs"] > 300
    assert found["formulas"] > 3 * found["proofs"]


def test_multipliers_are_read_as_they_are_written(seen: Callable[..., Page]) -> None:
    texts = sorted({each for certificate in certificates() for each in multipliers(certificate.get("proof"))})
    texts = [*texts[:: max(1, len(texts) // 300)], "-(a - b)^2/4 - -a", "2*(a + b)*c^2 - 1/2"]
    trees = seen("#errata").evaluate("(texts) => texts.map(polynomial)", texts)
    for text, tree in zip(texts, trees, strict=True):
        values = {name: Fraction(n + 2, 7) for n, name in enumerate(sorted(set(re.findall(r"[A-Za-z_]\w*", text))))}
        if text.endswith("- -a"):
            assert tree is None  # never written so, and left as it is
            continue
        # the numbers are made fractions, so that Python divides exactly
        plain = re.sub(r"(?<![\w^])(\d+)", r"Fraction(\1)", text).replace("^", "**")
        assert value(tree, values) == eval(plain, {"Fraction": Fraction}, values), text
    assert seen("#errata").evaluate("polynomial('a ? b')") is None


def certificates() -> list[dict[str, Any]]:
    from symcheck import kernels

    file = Path(str(kernels.folder())) / "certificates" / "mirer2009.json"
    found: list[dict[str, Any]] = json.loads(file.read_text(encoding="utf-8"))["certificates"]
    return found


def multipliers(proof: Any) -> Iterator[str]:
    for part in proof.values() if isinstance(proof, dict) else proof if isinstance(proof, list) else ():
        yield from multipliers(part)
    if isinstance(proof, dict):
        yield from (each for _, *factors in proof.get("cofactors", ()) for each in factors if isinstance(each, str))


def value(tree: Any, values: dict[str, Fraction]) -> Fraction:
    """A term without functions at a point."""
    if isinstance(tree, int):
        return Fraction(tree)
    if isinstance(tree, str):
        return values[tree]
    head, *parts = tree
    numbers = [value(part, values) for part in parts]
    if head == "^":
        return Fraction(numbers[0] ** numbers[1])
    if head == "-":
        return -numbers[0]
    return reduce({"+": add, "*": mul, "/": truediv}[head], numbers)


TERMS = (
    (["*", ["+", "a", "b"], "c"], "(a+b)c"),
    (["+", "a", ["*", -2, "b"], ["-", ["+", "c", 1]]], "a−2b−(c+1)"),
    (["-", ["+", "a", ["-", "b"]]], "−(a−b)"),
    (["^", ["-", "x"], 2], "(−x)2"),
    (["^", ["/", 1, 2], 2], "(12)2"),
    (["*", "x", ["-", "y"]], "x(−y)"),
    (["*", -1, "x", 2], "−x·2"),
    (["/", -1, 3], "−13"),
    (["sin", ["+", "omega_3", ["pi"]]], "sin(ω3+π)"),
    (["sqrt", ["^", "x", 2]], "x2"),
    (["^", ["cos", "a"], 2], "cos2(a)"),
    (["^", ["cos", "a"], -1], "(cos(a))−1"),
    (["*", ["sin", "a"], "b"], "sin(a)b"),
    (["^", ["sqrt", "x"], 3], "x3"),
    (["and", ["<=", ["/", 1087411, 1000000], "r"], ["<=", "r", ["/", -12, 10000000]]], "1.087411≤r≤−0.0000012"),
    (["^", ["/", 1087411, 1000000], 2], "1.0874112"),
    (["and", ["<=", "x", "y"], ["<=", "z", "w"]], "x≤y,z≤w"),
    (["=>", ["or", ["=", "x", 1], ["<", "x", 0]], ["and", ["!=", "y", 0], [">=", "z", "y"]]], "x=1orx<0⟹y≠0,z≥y"),
    (["and", ["or", ["=", "x", 1], ["=", "y", 1]], ["=", "z", 1]], "(x=1ory=1),z=1"),
    (["exists", ["x"], ["and", ["=", "x", 1]]], "∃x:(x=1)"),
    (["diff", ["*", "x", "y"], "x", 1, "x"], "ddx(xy)"),
    (["mean", ["+", "x", 1], "x"], "⟨x+1⟩x"),
)


@pytest.mark.parametrize(("term", "text"), TERMS)
def test_a_term_is_set_with_the_brackets_that_it_needs(seen: Callable[..., Page], term: Any, text: str) -> None:
    page = seen("#errata")
    found = page.evaluate("(term) => formula(term).textContent", term)
    assert re.sub(r"[\s\u2061\u2062]", "", found) == text


def test_a_claim_explains_the_words_beside_its_verdict(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    page.get_by_text("What these words mean").click()
    assert page.locator(".meanings dt").all_inner_texts() == [
        "proved",
        "as printed",
        "identity",
        "claim",
        "Coq",
    ]
    assert "the paper asserts it" in page.locator(".meanings").inner_text()


def test_the_point_of_a_refutation_is_set_as_formulas(seen: Callable[..., Page]) -> None:
    place = seen("#mirer2009:2.9.1").locator(".counterexample")
    assert place.locator(".values .formula math").count() > 3
    assert not {"*", "sqrt", "_"} & set(re.findall(r"sqrt|[*_]", place.inner_text()))


def test_what_nobody_wrote_or_folded_out_is_not_printed(opened: Callable[..., Page]) -> None:
    page = opened("#mirer2009:2.12")
    page.emulate_media(media="print")
    assert page.locator(".own").is_hidden()
    assert page.locator(".context").is_hidden()
    page.emulate_media(media="screen")
    noted(page, "A note")
    page.emulate_media(media="print")
    assert page.locator(".own").is_visible()


def test_relations_that_words_name_are_links(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.17")
    page.locator(".prose").get_by_role("link", name="2.14", exact=True).click()
    title(page, "mirer2009:2.14")


def lines_of(page: Page) -> str:
    page.locator(".context .lines").wait_for()
    return page.locator(".context .here").inner_text()


def test_the_text_of_a_paper_shows_each_claim_in_its_context(opened: Callable[..., Page], sources: Path) -> None:
    file = sources / "000_52559675eaf93e59.txt"
    page = opened("#mirer2009:2.12")
    page.locator("#file").set_input_files(file)
    assert lines_of(page) == file.read_text(encoding="utf-8").splitlines()[316 - 1]
    assert "the very text that was audited" in page.locator(".context").inner_text()
    page.get_by_role("link", name="next →").click()
    title(page, "mirer2009:2.12.1")
    page.locator(".context .lines").wait_for()


DROP = """([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
}"""


def test_another_text_is_told_from_the_one_that_was_audited(opened: Callable[..., Page]) -> None:
    page = opened("#mirer2009:2.12")
    page.evaluate(DROP, ["000_52559675eaf93e59.txt", "a line\n" * 315 + "the line of <b>2.12</b>\n"])
    assert lines_of(page) == "the line of <b>2.12</b>"
    assert "not the text that was audited" in page.locator(".context").inner_text()
    page = opened("#errata")
    page.evaluate(DROP, ["recipes.txt", "flour"])
    page.get_by_text("recipes.txt is the text of none of these papers").wait_for()


def noted(page: Page, text: str) -> None:
    page.locator(".own select").select_option("disagree")
    page.locator(".own textarea").fill(text)


def notes(page: Page) -> str:
    """What is listed under Review, which is drawn only some time after the link is clicked."""
    page.locator("#notes > *").wait_for()
    return page.locator("#notes").inner_text()


def saved(page: Page, button: str, folder: Path) -> str:
    with page.expect_download() as waiting:
        page.get_by_role("button", name=button).click()
    waiting.value.save_as(folder / waiting.value.suggested_filename)
    return (folder / waiting.value.suggested_filename).read_text(encoding="utf-8")


def test_notes_are_kept_and_saved_and_come_back(opened: Callable[..., Page], tmp_path: Path) -> None:
    page = opened("#mirer2009:2.12")
    noted(page, "Is <i>A</i> proper?")
    page.reload()
    page.wait_for_selector("html[data-ready]", state="attached")
    assert page.locator(".own textarea").input_value() == "Is <i>A</i> proper?"
    assert page.locator(".own select").input_value() == "disagree"
    page.locator(".top").get_by_role("link", name="Review").click()
    assert "Is <i>A</i> proper?" in notes(page)
    kept = saved(page, "Save as JSON", tmp_path)
    assert json.loads(kept)["review"]["mirer2009:2.12"].items() >= {"opinion": "disagree", "audit": "proved"}.items()
    letter = saved(page, "Save as a letter", tmp_path)
    for part in ("## mirer2009:2.12", "As printed: $J_1 J_3 = ", "The audit says: proved. I do not agree.", "proper?"):
        assert part in letter
    other = opened("#review")
    assert "None yet" in notes(other)
    other.evaluate(DROP, ["symcheck-review.json", kept])
    other.locator("#notes").get_by_role("link", name="mirer2009:2.12").click()
    title(other, "mirer2009:2.12")
    assert other.locator(".own select").input_value() == "disagree"
    other.locator(".own select").select_option("")
    other.locator(".own textarea").fill(" ")
    other.locator(".top").get_by_role("link", name="Review").click()
    assert "None yet" in notes(other)


@pytest.mark.parametrize(
    "spoil", ["get() { throw new DOMException('denied'); }", "value: null", "value: {getItem: () => '{'}"]
)
def test_a_browser_that_keeps_nothing_says_so_in_one_line(opened: Callable[..., Page], spoil: str) -> None:
    page = opened("#errata", before=f"Object.defineProperty(window, 'localStorage', {{{spoil}}})")
    page.goto(page.url.partition("#")[0] + "#mirer2009:2.12")
    title(page, "mirer2009:2.12")
    noted(page, "A note")
    assert "save your notes, under Review, before you close it" in page.locator(".own .kept").inner_text()
    page.locator(".top").get_by_role("link", name="Review").click()
    assert "A note" in notes(page)


def test_what_changed_since_an_older_ledger_is_listed(opened: Callable[..., Page]) -> None:
    page = opened("#errata")
    rows = page.evaluate(
        "entries.filter((each) => each.paper === 'mirer2009').map((each) => [each.id, each.role ? null : each.state])"
    )
    older = {id: [verdict, "as printed"] for id, verdict in rows if id != "mirer2009:2.12"}
    older |= {"mirer2009:2.17": ["undecided", "as printed"], "mirer2009:9.9": ["proved", "as printed"]}
    page.evaluate(DROP, ["old.json", json.dumps({"schema": 1, "paper": "mirer2009", "items": older})])
    page.locator("#changes li").first.wait_for()
    assert page.locator("#changes li").all_inner_texts() == [
        "mirer2009:2.12: new",
        "mirer2009:2.17: undecided, now refuted",
        "mirer2009:9.9: gone",
    ]
    assert "ignatov2005" not in page.locator("#changes").inner_text()
    item = {"id": "mirer2009:2.12", "verdict": "proved", "role": "claim", "kind": "", "printed": "J_1 = 1", "read": ""}
    page.evaluate(DROP, ["new.json", json.dumps({"items": [item]})])
    page.get_by_text("Against new.json").wait_for()
    assert "mirer2009:2.12: printed otherwise; before: J_1 = 1" in page.locator("#changes li").all_inner_texts()


def test_only_what_is_seen_is_unfolded(opened: Callable[..., Page]) -> None:
    page = opened("#errata")
    assert set(page.evaluate("Object.keys(unfolded)")) <= {"index", "errata", "envelopes"}
    assert page.locator("#rows li").count() == 0
    page = opened("#mirer2009:2.12")
    assert "claims-ignatov2005" not in page.evaluate("Object.keys(unfolded)")


def test_a_kernel_unfolds_where_its_claim_stands(seen: Callable[..., Page]) -> None:
    page = seen("#mirer2009:2.12")
    page.locator("details.excerpt summary").click()
    assert "def product_of_two_axial_moments" in page.locator("details.excerpt pre").inner_text()


def test_the_envelope_turns_with_mouse_keyboard_and_buttons(opened: Callable[..., Page]) -> None:
    page = opened("#pictures")
    canvas = page.locator("#canvas")
    seen = {page.evaluate(CANVAS)}

    def changed() -> bool:
        before = len(seen)
        seen.add(page.evaluate(CANVAS))
        return len(seen) > before

    canvas.focus()
    for key in ("ArrowLeft", "ArrowUp", "+"):
        page.keyboard.press(key)
        assert changed(), key
    page.keyboard.press("Home")
    assert not changed()
    box = canvas.bounding_box()
    assert box
    page.mouse.move(box["x"] + 100, box["y"] + 100)
    page.mouse.down()
    page.mouse.move(box["x"] + 190, box["y"] + 130, steps=5)
    page.mouse.up()
    assert changed()
    page.get_by_role("button", name="turn back").click()
    assert not changed()
    page.get_by_label("slips too").check()
    assert changed()
    page.locator("#envelope").select_option("Six wheels")
    assert changed()
    assert "32 vertices, 60 edges, 30 faces" in page.locator("#envelope-says").inner_text()


def test_errors_on_the_envelope_lead_to_their_errata(seen: Callable[..., Page]) -> None:
    page = seen("#pictures")
    marks = page.locator("#marks li")
    assert "vertex V₂: letter, 2.1V.2d" in marks.all_inner_texts()
    page.locator("#marks").get_by_role("link", name="2.1V.2d").click()
    title(page, "ignatov2005:2.1V.2d")


def test_arcs_of_a_claim_stand_out_when_it_has_the_focus(seen: Callable[..., Page]) -> None:
    page = seen("#pictures")
    page.locator("details.graph:not([open])").filter(has_text="mirer2009").locator("summary").click()
    page.locator('.arcs a[href="#mirer2009:2.12"]').focus()
    assert page.locator(".arcs path.on").count() >= 3
    assert page.locator(".arcs path.used").count() == 2
    hint = page.get_by_role("tooltip")
    hint.locator("math").wait_for()
    assert hint.inner_text().startswith("mirer2009:2.12 proved")
    page.locator("#pictures-title").click()
    hint.wait_for(state="hidden")


def test_colours_follow_the_button(opened: Callable[..., Page]) -> None:
    page = opened("#errata")
    colours = []
    for _ in range(3):
        page.locator("#theme").click()
        colours.append(page.evaluate("getComputedStyle(document.body).backgroundColor"))
    assert colours[0] != colours[1]
    assert colours[2] == colours[0]


def test_everything_is_reached_with_the_keyboard_alone(opened: Callable[..., Page]) -> None:
    page = opened("#errata")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to the content"
    for _ in range(3):
        page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    page.locator("#ledger-title").wait_for()
    page.locator("#rows li > a").first.focus()
    page.keyboard.press("Enter")
    page.locator("#claim-title:focus").wait_for()


def test_errata_are_legible_without_a_program(opened: Callable[..., Page]) -> None:
    page = opened("#errata", java_script_enabled=False)
    assert page.locator(".fault").first.is_visible()
    assert any(r"\omega_s" in text for text in page.locator(".fault .diff").all_text_contents())
    assert page.locator("#view-pictures").is_visible()
    assert page.locator("#filters").is_hidden()


def test_printing_leaves_out_what_paper_cannot_do(opened: Callable[..., Page]) -> None:
    page = opened("#mirer2009:2.17")
    page.emulate_media(media="print")
    assert page.locator("header.top").is_hidden()
    assert page.get_by_role("button", name="Download as JSON").is_hidden()
    headings = page.locator("#view-claim h2:visible")
    assert {"As read", "Hypotheses"} <= {*headings.all_inner_texts()}
    assert not {"Proof and certificate", "Notebook cells that show it"} & {*headings.all_inner_texts()}
    page.evaluate("document.querySelector('details.proof').open = true")
    assert "Proof and certificate" in headings.all_inner_texts()
    assert len(page.pdf()) > 10_000


@pytest.mark.slow
def test_twenty_thousand_claims_are_unfolded_paper_by_paper(browser: Browser, tmp_path: Path) -> None:
    from test_report import record, wrong

    from symcheck.views.page.page import page
    from symcheck.views.page.sources import Publication

    papers = [Publication(f"toy{2000 + n}", f"Toy {n}", f"{n}.txt", {"1": "The only section"}) for n in range(10)]
    rows = []
    for n in range(20_000):
        make = (lambda id, printed, **fields: wrong(id, printed, "x = y", **fields)) if n % 12 == 0 else record
        row = make(
            f"1.{n}", printed=rf"x_{{{n}}} = \frac{{a^{n % 7}}}{{b_{{{n % 11}}}}} + {n}", words=f"The claim number {n}."
        )
        key = papers[n // 2000].key
        rows.append(structs.replace(row, id=f"{key}:1.{n}", paper=key))
    file = tmp_path / "page.html"
    file.write_text(page(rows, papers), encoding="utf-8")
    shown = browser.new_context(viewport=WIDE).new_page()
    shown.goto(file.as_uri())
    shown.wait_for_selector("html[data-ready]", state="attached")
    took = {"first view": shown.evaluate("performance.now()")}
    assert {name for name in shown.evaluate("Object.keys(unfolded)") if name.startswith("claims")} == set()
    assert shown.locator("#rows li").count() == 0
    measure = """async (hash) => {
        const start = performance.now();
        location.hash = hash;
        await new Promise((done) => addEventListener("view", done, {once: true}));
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        return performance.now() - start;
    }"""
    took["one claim"] = shown.evaluate(measure, "#toy2007:1.15000")
    assert {name for name in shown.evaluate("Object.keys(unfolded)") if name.startswith("claims")} == {"claims-toy2007"}
    took["ledger"] = shown.evaluate(measure, "#ledger")
    shown.get_by_label("Search").fill("number 15000.")
    shown.locator("#rows:not([aria-busy])").wait_for(state="attached")
    shown.locator("#count").filter(has_text="1 of").wait_for()
    assert shown.locator("#rows li:visible > a").all_inner_texts() == ["1.15000"]
    assert shown.locator("#count").inner_text() == "1 of 20,000 items"
    print(f"{file.stat().st_size / 1e6:.1f} MB,", ", ".join(f"{name} {ms:.0f} ms" for name, ms in took.items()))


@pytest.mark.slow
def test_the_whole_audit_is_one_file_below_a_megabyte(browser: Browser, tmp_path: Path) -> None:
    from symcheck.cli import cli

    file = tmp_path / "page.html"
    done = CliRunner().invoke(cli, ["report", "--output", str(file)], prog_name="symcheck")
    assert done.exit_code == 0, done.output
    assert file.stat().st_size < 1_000_000
    page = browser.new_context(viewport=WIDE).new_page()
    page.goto(file.as_uri() + "#ledger")
    page.wait_for_selector("html[data-ready]", state="attached")
    items = int(done.output.rpartition(": ")[2].split()[0].replace(",", ""))
    assert page.locator("#rows li").count() == items > 2300
    assert page.locator("#count").inner_text() == f"{items:,} of {items:,} items"
