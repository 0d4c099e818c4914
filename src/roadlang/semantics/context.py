"""Where an expression stands: what its words may mean, and how its draws are keyed."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..plugins.option_types import (
    CallType,
    EntityType,
    IntervalType,
    KindNameType,
    ListType,
    MapType,
    OptionType,
    TextType,
    UnionType,
)


@dataclass(frozen=True, slots=True)
class Context:
    """`user` is the declaration that the expression belongs to, `place` keys its draws, `per` says
    how often they are made. Names and calls are looked up among `words` and the kinds of `verbs`
    before declared names. `fresh`: named draws are drawn anew too. `drive_time`: what is named
    here is looked at while driving, so that it does not have to come before `user`."""

    user: str
    place: str
    per: str = "scene"
    words: tuple[str, ...] = ()
    verbs: tuple[str, ...] = ()
    fresh: bool = False
    drive_time: bool = False
    of_controller: bool = False
    """Whether it is an option of a controller, which looks at whom it names while driving"""
    watches: bool = False
    """Whether it names whom a controller watches: anyone but the agent that it drives"""
    strings: bool = False
    """A bare name that means nothing else is a string, as in `--set weather=rain`."""
    takes_text: bool = False
    """Whether it is an option that holds a string"""
    roles: tuple[str, ...] = ()
    """What a name must be declared as, such as `agent`; empty for anything"""
    example: str = ""
    """A value of the option, as its help shows it."""

    def for_option(
        self, name: str, option: OptionType, words: tuple[str, ...], example: str = ""
    ) -> Context:
        """The context of an option's value."""
        watches = self.of_controller and bool(roles_in(option)) and not self.drive_time
        return replace(
            self,
            place=f"{self.place}/{name}",
            drive_time=self.drive_time or watches,
            watches=watches,
            words=words,
            verbs=verbs_in(option),
            strings=False,
            takes_text=isinstance(option, TextType),
            roles=roles_in(option),
            example=example,
        )


def verbs_in(option: OptionType) -> tuple[str, ...]:
    """The verbs whose kinds an option's value may name."""
    if isinstance(option, CallType | KindNameType):
        return (option.verb,)
    if isinstance(option, ListType | IntervalType | MapType):
        return verbs_in(option.item)
    if isinstance(option, UnionType):
        return tuple(verb for part in option.alternatives for verb in verbs_in(part))
    return ()


def roles_in(option: OptionType) -> tuple[str, ...]:
    """The roles of the declarations that an option's value may name."""
    if isinstance(option, EntityType):
        return option.roles
    if isinstance(option, ListType):
        return roles_in(option.item)
    return ()
