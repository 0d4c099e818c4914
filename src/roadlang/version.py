"""The versions of roadlang, which git tags and the changelog follow, and of what plugins import."""

__version__ = "0.2.0"
API_VERSION = "0.2"
"""Of the names in `roadlang.api`: the first two numbers of the version of roadlang that last
changed them in a way that plugins notice. See "What is stable" in the plugin guide."""
