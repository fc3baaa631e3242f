"""Gives the next hint for an exercise, one more each time."""

from course_lib.terminal import say
from exercises import loop, student

HELP = "one more hint for an exercise"


def add_arguments(parser):
    parser.add_argument("exercise", metavar="EX", help="such as ex-01.3 (or 1.3)")


def run(args):
    catalog, id = loop.find_exercise(args.exercise)
    exercise = catalog.exercises[id]
    state = student.read_state()
    given = state.setdefault("hints", {}).get(id, 0)
    total = len(exercise.hints)
    if given >= total:
        say(f"{id}  {exercise.title}: there is no further hint. Once more:")
        for number, hint in enumerate(exercise.hints, start=1):
            say(f"  {number} of {total}: {hint}")
        return 0
    say(f"{id}  {exercise.title}")
    say(f"  hint {given + 1} of {total}: {exercise.hints[given]}")
    state["hints"][id] = given + 1
    student.write_state(state)
    return 0
