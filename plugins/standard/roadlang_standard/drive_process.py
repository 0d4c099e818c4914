"""`drive with process`: a program in any language drives, by lines of JSON."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from roadlang.api import Controller, Duration, Flag, ListOf, String, option

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, DiagnosticError, ObservationBatch

    from .process.program import ControllerProcess

A = TypeVar("A")
R = TypeVar("R")
_WHERE = "programs start in the current folder, not in that of the scene file"
_AT_ONCE = (
    "it has to read and answer line by line: let it flush its standard output after each line; some"
    " programs also wait for more input, unless told not to (`mawk -W interactive`, `python3 -u`)"
)
BRAKING = 4.0
"""m/s^2, of an agent whose program failed, with `brake_on_failure`."""
START = 20.0
"""seconds that a program may take to answer its first line"""


@dataclass(frozen=True)
class Process(Controller):
    """Run a program in any language: it reads what the agent sees as one line of JSON on
    standard input, and answers with one line. The drive waits for it at every step.
    """

    name: ClassVar[str] = "process"
    also_called: ClassVar[tuple[str, ...]] = ("external", "program", "script", "python")
    command: ListOf[String] = option(at_least=1, help="the program and its arguments")
    timeout: Duration = option(
        1.0, minimum=0.001, maximum=600, help="time limit for each answer", example="500ms"
    )
    brake_on_failure: Flag = option(
        False,
        help="if the program dies, is late or gives an invalid answer during the drive, the agent"
        " brakes to a stop and the drive is judged; by default the run ends with an error",
    )

    def start(self, count: int) -> NDArray[np.object_]:
        """Of each agent: its program, None before the first step, False after it failed."""
        import numpy as np

        return np.full(count, None, dtype=object)

    def controls(self, observations: ObservationBatch, state: NDArray[Any]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        from .process.messages import observations as lines_of

        steering = np.zeros(len(state))
        acceleration = np.full(len(state), -BRAKING)
        timeout = np.broadcast_to(np.asarray(self.timeout, dtype=np.float64), len(state))
        failures: dict[int, str] = {}
        try:
            self._begin(observations, state)
            for row, line in enumerate(lines_of(observations)):
                self._attempt(state, row, failures, _send, line)
                self._refuse(failures, observations)
            for row, seconds in enumerate(timeout.tolist()):
                answer = self._attempt(state, row, failures, _answered, seconds)
                self._refuse(failures, observations)
                if answer is not None:
                    steering[row], acceleration[row] = answer
        except BaseException:  # Ctrl-C too: no program outlives the drive
            for program in filter(None, state):
                program.close()
            raise
        return ControlBatch(steering, acceleration, failures=failures)

    def _begin(self, seen: ObservationBatch, state: NDArray[Any]) -> None:
        """Start the programs of those that have none, all at once, then greet them. One that cannot
        be started, or does not answer the greeting, is an error, also with `brake_on_failure`."""
        from .process.messages import greeting
        from .process.program import ControllerProcess, ProgramFailed, ProgramLate

        new = [row for row in range(len(state)) if state[row] is None]
        for row in new:
            try:
                state[row] = ControllerProcess(self.command)
                state[row].send(greeting(seen, row))
            except ProgramFailed as error:
                raise self._failed(str(error), _WHERE, _driven(seen, row)) from error
        for row in new:
            try:
                _greeted(state[row], START)
            except ProgramFailed as error:
                what = _AT_ONCE if isinstance(error, ProgramLate) else _WHERE
                raise self._failed(str(error), what, _driven(seen, row)) from error

    def _attempt(
        self,
        state: NDArray[Any],
        row: int,
        failures: dict[int, str],
        step: Callable[[ControllerProcess, A], R],
        argument: A,
    ) -> R | None:
        """What a step with the program of a row gives; None where that has failed. Why it fails now
        is put into `failures`."""
        from .process.program import ProgramFailed

        program = state[row]
        if not program:
            return None
        try:
            return step(program, argument)
        except ProgramFailed as error:
            program.close()
            state[row], failures[row] = False, str(error)
            return None

    def _refuse(self, failures: Mapping[int, str], seen: ObservationBatch) -> None:
        """Raises DiagnosticError RL740 for the first of them, unless the agents may brake."""
        if failures and not self.brake_on_failure:
            row, reason = next(iter(failures.items()))
            raise self._failed(reason, _driven(seen, row))

    def _failed(self, reason: str, *help: str) -> DiagnosticError:
        from roadlang.api import Code, DiagnosticError, diagnose

        command = " ".join(self.command)
        fault = diagnose(Code.PROGRAM_FAILED, command=command, reason=reason, help=help)
        return DiagnosticError(fault)


def _driven(seen: ObservationBatch, row: int) -> str:
    """Which program it is, of several of one command."""
    return f"it drives `{seen.agent[row]}` and failed {seen.time[row]:.2f} s into the drive"


def _send(program: ControllerProcess, line: str) -> None:
    from .process.messages import refuse_unasked

    # Every later answer would be to what the agent saw a step before.
    refuse_unasked(program.unasked())
    program.send(line)


def _greeted(program: ControllerProcess, seconds: float) -> None:
    from .process.messages import check_greeting

    check_greeting(program.receive(seconds))


def _answered(program: ControllerProcess, seconds: float) -> tuple[float, float]:
    from .process.messages import control

    return control(program.receive(seconds))
