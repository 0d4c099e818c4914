"""What all tests share: property tests without a stopwatch, the same examples on every run."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "roadlang",
    deadline=None,
    max_examples=50,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("roadlang")

pytest_plugins = ["roadlang.testing", "tests.scene_texts"]
