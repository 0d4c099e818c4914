"""The page in a real browser: it opens without a fault, and does what its controls say."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from roadlang.session.reports import write_report
from tests.report.browser import Page, address_of, browser
from tests.report.made_results import BEND, made


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_report(made("falsify", tmp_path_factory.mktemp("search")))


@pytest.fixture(scope="module")
def shared_page() -> Iterator[Page]:
    with browser() as page:
        yield page


@pytest.fixture
def page(shared_page: Page, results: Path) -> Page:
    shared_page.faults.clear()
    shared_page.requests.clear()
    shared_page.resize(1000, 900)
    shared_page.open("about:blank")
    shared_page.open(address_of(results))
    return shared_page


def test_it_opens_without_an_error_or_an_outside_request(page: Page, results: Path) -> None:
    page.run("new Promise(done => setTimeout(done, 300))")
    assert page.faults == []
    assert {request for request in page.requests if not request.startswith("data:")} <= {
        address_of(results),
        "about:blank",
    }


def test_a_run_opens_as_well(page: Page, tmp_path: Path) -> None:
    written = write_report(made("run", tmp_path, "-n", "3"))
    page.open(address_of(written))
    assert page.faults == []
    assert page.run("document.querySelectorAll('#drive-choice option').length") == 3


def test_the_slider_moves_the_cars_and_the_cursors(page: Page) -> None:
    script = """(time => {
        const slider = document.getElementById("time");
        slider.value = time;
        slider.dispatchEvent(new Event("input"));
        return [...document.querySelectorAll("#map g")].map(car => car.getAttribute("transform"))
            .concat([...document.querySelectorAll(".cursor")].map(line => line.getAttribute("d")));
    })"""
    early, late = page.run(f"{script}(1)"), page.run(f"{script}(3)")
    assert len(early) == len(late) >= 4
    assert all(before != after for before, after in zip(early, late, strict=True))
    assert page.run("document.getElementById('clock').textContent") == "3.0\N{NO-BREAK SPACE}s"


def test_play_goes_on_and_stops(page: Page) -> None:
    page.run("viewer.stopAt(0)")
    page.run("document.getElementById('play').click()")
    assert page.run("document.getElementById('play').textContent") == "Pause"
    page.run("""new Promise(done => {
        const look = () => viewer.time > 0.05 ? done() : setTimeout(look, 20);
        look();
    })""")
    page.run("document.getElementById('play').click()")
    assert page.run("document.getElementById('play').textContent") == "Play"
    stopped = page.run("viewer.time")
    page.run("new Promise(done => requestAnimationFrame(() => setTimeout(done, 50)))")
    assert page.run("viewer.time") == stopped < 5


def test_a_picture_opens_its_drive_at_the_moment_that_decides(page: Page) -> None:
    page.run("document.querySelector('.gallery a[data-drive=\"1\"]').click()")
    assert page.run("document.getElementById('drive-choice').value") == "1"
    assert page.run("viewer.time") == pytest.approx(page.run("viewer.momentTime()"))
    assert "violated" in page.run("document.getElementById('drive-verdict').textContent")
    assert page.run("location.hash") == "#drive-1"


def test_labels_beside_a_curve_are_not_cut_off(page: Page) -> None:
    least = page.run("""(() => {
        const given = { title: "a", across: [0, 1], times: [0, 1], values: [-0.000379, -0.000379] };
        const plot = new Plot({ ...given, acrossUnit: "s", unit: "", zero: true, onTime() {} });
        document.body.append(plot.node);
        plot.render();
        const found = [...plot.svg.querySelectorAll("text")].map(label => label.getBBox().x);
        plot.node.remove();
        return Math.min(...found);
    })()""")
    assert least >= 0


def test_a_click_on_a_plot_sets_the_time(page: Page) -> None:
    page.run("viewer.stopAt(0); viewer.plots[0].pick(viewer.plots[0].x(2))")
    assert page.run("viewer.time") == pytest.approx(2.0, abs=0.11)


def test_columns_sort_both_ways(page: Page) -> None:
    click = """(name => {
        const head = [...document.querySelectorAll("thead th")];
        const at = head.findIndex(cell => cell.textContent.startsWith(name));
        head[at].querySelector("button").click();
        const rows = [...document.querySelectorAll("tbody tr")];
        const shown = rows.map(row => row.children[at].textContent.replace("\\u2212", "-"));
        return [head[at].getAttribute("aria-sort"), shown.filter(Boolean).map(Number)];
    })"""
    way, values = page.run(f"{click}('slow')")
    assert (way, values) == ("ascending", sorted(values))
    way, values = page.run(f"{click}('slow')")
    assert (way, values) == ("descending", sorted(values, reverse=True))


@pytest.mark.parametrize(
    ("words", "holds"), [("slow < 0", "value < 0"), ("slow >= 2", "value >= 2")]
)
def test_the_filter_compares_a_column(page: Page, words: str, holds: str) -> None:
    found = page.run(f"""(() => {{
        const box = document.getElementById("filter");
        box.value = {words!r};
        box.dispatchEvent(new Event("input"));
        const at = DATA.table.columns.findIndex(column => column.name === "slow");
        const values = table.chosen().map(row => row[0][at]);
        return [values.length, values.every(value => {holds})];
    }})()""")
    assert 0 < found[0] < 40
    assert found[1]


def test_the_outcome_filters(page: Page) -> None:
    shown = page.run("""(() => {
        const box = document.getElementById("outcome");
        box.value = "1";
        box.dispatchEvent(new Event("input"));
        return [...document.querySelectorAll("tbody tr")].map(row => row.className);
    })()""")
    assert set(shown) == {"failed"}


@pytest.mark.parametrize("wide", [320, 360, 768])
def test_nothing_is_wider_than_a_phone(page: Page, wide: int) -> None:
    page.resize(wide, 800)
    page.run("new Promise(done => requestAnimationFrame(() => setTimeout(done, 50)))")
    assert page.run("document.documentElement.scrollWidth") <= wide


def test_it_has_landmarks_names_and_one_heading(page: Page) -> None:
    tags = ("header", "nav[aria-label]", "main", "footer", "h1")
    for tag in tags:
        assert page.run(f"document.querySelectorAll('{tag}').length") == 1, tag
    unnamed = page.run("""[...document.querySelectorAll("button, input, select, [role=img]")]
        .filter(node => !(node.getAttribute("aria-label") || node.labels?.length
            || node.textContent.trim()))
        .map(node => node.outerHTML)""")
    assert unnamed == []
    sections = page.run("""[...document.querySelectorAll("main > section")]
        .every(part => document.getElementById(part.getAttribute("aria-labelledby")))""")
    assert sections


def test_the_keyboard_reaches_every_control(page: Page) -> None:
    assert page.run("""[...document.querySelectorAll("button, input, select, a, .scroll")]
        .every(node => node.tabIndex >= 0)""")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_words_stand_out_from_the_paper(page: Page, scheme: str) -> None:
    """WCAG 2.1, level AA: a contrast of 4.5 for text."""
    page.send(
        "Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}]
    )
    contrasts = page.run("""(() => {
        const numbers = color => color.match(/[\\d.]+/g).slice(0, 3).map(Number);
        const light = color => numbers(color).map(v => v / 255)
            .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
            .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
        const paper = light(getComputedStyle(document.body).backgroundColor);
        const nodes = [...document.querySelectorAll("body, .note, .violated, .rho, .gallery a")];
        return nodes.map(node => light(getComputedStyle(node).color))
            .map(ink => (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05));
    })()""")
    assert len(contrasts) > 5
    assert min(contrasts) >= 4.5


def test_on_paper_there_is_no_control_and_no_color_scheme(page: Page) -> None:
    page.send("Emulation.setEmulatedMedia", media="print")
    shown = page.run("""[...document.querySelectorAll("nav, .transport, .options, .filter")]
        .filter(node => getComputedStyle(node).display !== "none").length""")
    assert shown == 0
    page.send("Emulation.setEmulatedMedia", media="")


def test_names_are_no_markup(page: Page, tmp_path: Path) -> None:
    title = (
        "</script><script>document.title='broken'</script><img src=x onerror=alert(1)> ${x} &amp;"
    )
    text = f'scenario evil "{title}"\n' + BEND.partition('A bend"\n')[2]
    page.open(address_of(write_report(made("run", tmp_path, "-n", "2", text=text))))
    assert page.run("document.querySelector('h1').textContent") == title
    assert page.run("document.title") == f"{title}: report"
    assert page.run("document.querySelectorAll('img').length") == 0
    assert page.faults == []
