"""`roadlang completion SHELL`: the script that completes commands, options and kinds."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

_INSTALL = {
    "bash": 'eval "$(roadlang completion bash)"     # in ~/.bashrc',
    "zsh": 'eval "$(roadlang completion zsh)"      # in ~/.zshrc',
    "fish": "roadlang completion fish | source     # in ~/.config/fish/config.fish",
}


@click.command("completion", epilog="\b\n" + "\n".join(_INSTALL.values()))
@click.argument("shell", type=click.Choice(sorted(_INSTALL)))
def command(shell: str) -> None:
    """Print the completion script for a shell."""
    kind = get_completion_class(shell)
    assert kind is not None
    root = click.get_current_context().find_root().command
    click.echo(kind(root, {}, "roadlang", "_ROADLANG_COMPLETE").source())
