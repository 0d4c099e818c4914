"""`roadlang extract --edit` in a real browser: roads are selected, dismissed, drawn and saved."""

from __future__ import annotations

import json
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from threading import Thread
from typing import Any

import cv2
import numpy as np
import pytest

from roadlang import correcting, load
from roadlang.correcting.picture_roads import PictureRoads
from roadlang.correcting.server import CorrectionServer
from tests.report.browser import Page, browser

PAGE = Path(correcting.__file__).parent / "page"
SCENE = """# two roads and a stripe that is none
image photo from "plan.png" { scale: 0.5m/px }
network town from photo {
  extract with contour
}
"""


@pytest.fixture(scope="module")
def shared_page() -> Iterator[Page]:
    with browser() as page:
        page.resize(1100, 700)
        yield page


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    picture = np.full((240, 400, 3), 255, np.uint8)
    cv2.line(picture, (0, 60), (399, 60), (0, 0, 0), 9)
    cv2.line(picture, (0, 180), (399, 180), (0, 0, 0), 9)
    cv2.imwrite(str(tmp_path / "plan.png"), picture)
    (tmp_path / "a.rl").write_text(SCENE)
    return tmp_path / "a.rl"


@pytest.fixture
def server(scene: Path) -> Iterator[CorrectionServer]:
    with CorrectionServer(PictureRoads.of(scene, scene.parent / "plan.png"), "s") as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


@pytest.fixture
def page(shared_page: Page, server: CorrectionServer) -> Page:
    shared_page.faults.clear()
    shared_page.requests.clear()
    shared_page.open("about:blank")
    shared_page.questions.clear()
    shared_page.open(server.address)
    settled(shared_page, "document.querySelectorAll('#roads > g').length === 2")
    return shared_page


def settled(page: Page, condition: str) -> None:
    """Wait until this holds on the page."""
    page.run(
        "new Promise(done => { const look = () => "
        f"({condition}) ? done(true) : setTimeout(look, 20); look(); }})"
    )


def click(page: Page, x: float, y: float, meanwhile: str = "0") -> None:
    """A real click at a pixel of the picture. `meanwhile`: runs between press and release."""
    seen = f"new DOMPoint({x}, {y}).matrixTransform(at('view').getScreenCTM())"
    at = page.run(f"(p => [p.x, p.y])({seen})")
    for kind, script in (("mousePressed", meanwhile), ("mouseReleased", "0")):
        page.send(
            "Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left", clickCount=1
        )
        page.run(script)
    page.run("new Promise(done => setTimeout(done))")


def press(page: Page, key: str) -> None:
    page.send("Input.dispatchKeyEvent", type="keyDown", key=key)
    page.send("Input.dispatchKeyEvent", type="keyUp", key=key)


def saved(page: Page, scene: Path) -> str:
    page.run("at('save').click()")
    settled(page, "at('message').textContent.startsWith('Saved')")
    return scene.read_text()


def test_it_opens_without_a_fault_and_asks_nobody_else(
    page: Page, server: CorrectionServer
) -> None:
    assert page.faults == []
    assert all(request.startswith((server.address, "data:", "about:")) for request in page.requests)


def test_a_road_is_dismissed_by_a_click_and_a_key(page: Page, scene: Path) -> None:
    click(page, 200, 180)
    assert "Road" in page.run("at('road').textContent")
    press(page, "x")
    settled(page, "document.querySelectorAll('#roads > g').length === 1")
    assert page.run("document.querySelectorAll('#lost path').length") == 1
    text = saved(page, scene)
    assert text.startswith(SCENE[: SCENE.index("}\nnetwork")])
    (sampled,) = load(scene).sample(1)
    (road,) = sampled.roads.values()
    assert float(np.ptp(road.y)) < 1.0
    assert float(np.mean(road.y)) == pytest.approx(0.5 * (239.5 - 60), abs=0.6)


def test_a_click_counts_while_roads_are_drawn_anew(page: Page) -> None:
    """As they are when an answer arrives."""
    click(page, 200, 60, meanwhile="draw()")
    assert page.run("page.chosen !== null")
    click(page, 200, 120)
    assert page.run("page.chosen === null")


def test_a_road_is_drawn_point_by_point(page: Page, scene: Path) -> None:
    press(page, "d")
    for x, y in ((100, 62), (110, 120), (100, 178)):
        click(page, x, y)
    press(page, "Enter")
    settled(page, "document.querySelectorAll('#roads > g').length === 5")
    assert "drawn: [[(100px, 62px), (110px, 120px), (100px, 178px)]]" in saved(page, scene)
    (sampled,) = load(scene).sample(1)
    assert len(sampled.roads) == 5


def test_a_part_is_cut_out_with_two_clicks(page: Page, scene: Path) -> None:
    click(page, 300, 60)
    press(page, "p")
    click(page, 100, 60)
    click(page, 200, 60)
    settled(page, "document.querySelectorAll('#roads > g').length === 3")
    (sampled,) = load(saved(page, scene) and scene).sample(1)
    lengths = sorted(round(road.length) for road in sampled.roads.values())
    assert lengths == [50, 100, 200]


def test_what_was_done_is_undone_redone_and_taken_back(page: Page, scene: Path) -> None:
    before = page.run("JSON.stringify(page.roads)")
    click(page, 200, 60)
    press(page, "c")
    settled(page, "page.roads.some(road => road.confidence === 1)")
    click(page, 200, 60)
    press(page, "x")
    settled(page, "page.roads.length === 1")
    page.run("undo()")
    settled(page, "page.roads.length === 2")
    page.run("redo()")
    settled(page, "page.roads.length === 1")
    page.run("document.querySelectorAll('#corrections button').forEach(button => button.click())")
    settled(page, "page.corrections.dismissed.length === 0")
    page.run("document.querySelectorAll('#corrections button').forEach(button => button.click())")
    settled(page, "page.corrections.confirmed.length === 0")
    settled(page, f"JSON.stringify(page.roads) === {json.dumps(before)}")
    assert saved_or_same(page, scene) == SCENE


def saved_or_same(page: Page, scene: Path) -> str:
    assert page.run("at('save').disabled")
    return scene.read_text()


def test_corrections_that_are_taken_back_leave_the_file_as_it_was(page: Page, scene: Path) -> None:
    click(page, 200, 60)
    press(page, "x")
    settled(page, "page.roads.length === 1")
    assert saved(page, scene) != SCENE
    page.run("undo()")
    settled(page, "page.roads.length === 2")
    page.run("at('message').textContent = ''")
    assert saved(page, scene) == SCENE


def test_whoever_leaves_with_corrections_that_are_not_saved_is_asked(page: Page) -> None:
    click(page, 200, 60)
    press(page, "x")
    settled(page, "page.roads.length === 1")
    page.open("about:blank")
    assert page.questions == ["beforeunload"]


def test_the_wheel_zooms_where_it_points_and_a_drag_moves(page: Page) -> None:
    box = page.run("page.box")
    at = page.run(
        "(() => { const r = at('view').getBoundingClientRect(); return [r.x + 200, r.y + 300]; })()"
    )
    page.send(
        "Input.dispatchMouseEvent", type="mouseWheel", x=at[0], y=at[1], deltaX=0, deltaY=-400
    )
    settled(page, f"page.box[2] < {box[2]} * .7")
    left = page.run("page.box[0]")
    for kind, x in (("mousePressed", 300), ("mouseMoved", 350), ("mouseReleased", 350)):
        page.send(
            "Input.dispatchMouseEvent",
            type=kind,
            x=x,
            y=300,
            button="left",
            buttons=1,
            clickCount=1,
        )
    settled(page, f"page.box[0] < {left}")
    assert page.run("page.chosen") is None


def request(address: str, content: bytes | None = None, **headers: str) -> tuple[int, Any]:
    asked = urllib.request.Request(address, data=content, headers=headers)
    try:
        with urllib.request.urlopen(asked, timeout=60) as answer:
            return answer.status, answer.read()
    except urllib.error.HTTPError as error:
        return error.code, None


def test_pages_may_not_ask_anybody_else_and_are_not_stored(server: CorrectionServer) -> None:
    with urllib.request.urlopen(server.address + "start") as answer:
        headers = dict(answer.headers)
        content = answer.read()
    assert headers["Content-Type"] == "application/json"
    assert headers["Content-Length"] == str(len(content))
    assert headers["Cache-Control"] == "no-store"
    assert "default-src 'self'" in headers["Content-Security-Policy"]


def test_the_page_is_sent_the_picture_and_what_was_found(
    server: CorrectionServer, scene: Path
) -> None:
    sent = request(server.address + "picture")[1]
    shown = cv2.imdecode(np.frombuffer(sent, np.uint8), cv2.IMREAD_COLOR)
    np.testing.assert_array_equal(shown, cv2.imread(str(scene.parent / "plan.png")))
    start = json.loads(request(server.address + "start")[1])
    assert (start["width"], start["height"], start["network"]) == (400, 240, "town")
    middles = sorted(np.mean(road["points"], axis=0)[1] for road in start["found"])
    assert middles == pytest.approx([60.5, 180.5], abs=1.0)
    drawn = {"drawn": [[[200, 60], [200, 180]]], "dismissed": [], "confirmed": []}
    assert json.loads(request(server.address + "save", json.dumps(drawn).encode())[1]) == {
        "saved": True
    }
    assert "drawn: [[(200px, 60px), (200px, 180px)]]" in scene.read_text()
    large = {"Content-Length": "4000001"}
    assert request(server.address + "save", json.dumps(drawn).encode(), **large)[0] == 400


def test_nobody_without_the_secret_is_answered(server: CorrectionServer) -> None:
    root = f"http://127.0.0.1:{server.server_port}/"
    assert request(root)[0] == 403
    assert request(root + "wrong/start")[0] == 403
    assert request(server.address + "start", Host="elsewhere.example")[0] == 403
    nothing = b'{"drawn": [], "dismissed": [], "confirmed": []}'
    assert request(server.address + "done", nothing, Host="elsewhere.example")[0] == 403
    assert not server.done.is_set()
    assert request(server.address + "start")[0] == 200
    assert request(server.address + "../server.py")[0] == 404
    assert request(server.address + "%2e%2e/server.py")[0] == 404


@pytest.mark.parametrize(
    ("name", "kind"),
    [("", "text/html"), ("page.css", "text/css"), ("page.js", "text/javascript")],
)
def test_the_files_of_the_page_are_sent_with_their_types(
    server: CorrectionServer, name: str, kind: str
) -> None:
    with urllib.request.urlopen(server.address + name, timeout=60) as answer:
        assert answer.headers["Content-Type"] == f"{kind}; charset=utf-8"
        assert answer.read() == (PAGE / (name or "page.html")).read_bytes()


def test_what_is_sent_is_answered_by_what_is_asked_for(
    server: CorrectionServer, scene: Path
) -> None:
    """Only the path of the stripe below is left after the one above was dismissed."""
    sent = json.dumps({"drawn": [], "dismissed": [[[200, 60]]], "confirmed": []}).encode()
    status, content = request(server.address + "roads", sent)
    assert (status, list(json.loads(content))) == (200, ["roads", "missed"])
    (road,) = json.loads(content)["roads"]
    assert np.mean(road["points"], axis=0)[1] == pytest.approx(180.5, abs=1.0)
    assert json.loads(content)["missed"] == []
    assert scene.read_text() == SCENE
    assert request(server.address + "elsewhere", sent)[0] == 404
    assert request(server.address + "elsewhere")[0] == 404
    scene.write_text(SCENE.replace("town", "village"))
    status, content = request(server.address + "save", sent)
    assert (status, list(json.loads(content))) == (200, ["error"])
    assert not server.done.is_set()
    assert request(server.address + "done", sent) == (200, b"{}")
    assert server.done.wait(60)  # set after the answer


def test_a_drawn_road_that_is_none_is_refused_in_words(server: CorrectionServer) -> None:
    sent = {"drawn": [[[9, 9], [9, 9]]], "dismissed": [], "confirmed": [[200, 5]]}
    answer = json.loads(request(server.address + "roads", json.dumps(sent).encode())[1])
    assert list(answer) == ["error"]
    assert answer["error"].startswith("This road cannot be drawn: ")


@pytest.mark.parametrize(
    "sent",
    [
        b"", b"{", b"[]", b"{}", b'{"drawn": 3, "dismissed": [], "confirmed": []}',
        b'{"drawn": [[[1, 2]]], "dismissed": [], "confirmed": []}',
        b'{"drawn": [], "dismissed": [[]], "confirmed": []}',
        b'{"drawn": [], "dismissed": [], "confirmed": [[1, NaN]]}',
        b'{"drawn": [], "dismissed": [], "confirmed": [[1, 1e300]]}',
    ],
)  # fmt: skip
def test_what_cannot_be_read_changes_nothing(
    server: CorrectionServer, scene: Path, sent: bytes
) -> None:
    assert request(server.address + "save", sent)[0] == 400
    assert scene.read_text() == SCENE
