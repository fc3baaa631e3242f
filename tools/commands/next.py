"""Says which exercise to do next: where it stands, how long it takes, what its first red test asks.

Checks the chapter first when something has changed since the last check.
"""

from course_lib.terminal import count, say
from exercises import loop, student, verdicts

HELP = "the next exercise to do"


def add_arguments(parser):
    pass


def run(args):
    for catalog in loop.catalogs():
        results = loop.up_to_date_results(catalog)
        red = loop.first_red(catalog, loop.outcome_in(results))
        if red:
            show(catalog, results, *red)
            return 0
    say("Every exercise is done.")
    return 0


def show(catalog, results, exercise, test):
    state = results.tests.get(test.name, {})
    hints = len(exercise.hints) - student.read_state().get("hints", {}).get(exercise.id, 0)
    say(f"{exercise.id}  {exercise.title} (about {count(exercise.minutes, 'minute')})")
    say(f"  where      {loop.place_of(exercise.id)}")
    if results.error:
        say(f"  first      make it compile: {results.error}")
    say(f"  red test   {test.name} ({count(test.points, 'point')}): {state.get('state', 'not run')}")
    if state.get("state") == "failed":
        say(f"  it says    {state['reason']}")
    if state.get("state") in verdicts.TRIED:  # before that, it would take the thinking away
        say(f"  look at    {test.look_at}")
    say(f"  lesson     chapters/{catalog.chapter}/README.md")
    if hints > 0:
        say(f"  stuck?     ./course hint {exercise.id} ({count(hints, 'hint')} left)")
