"""How many lines of common/ the chapters' executables run, and which they don't: what ./course test --coverage judges."""

from course_lib.benchmarks import end_with, option_parser, save_quantities
from course_lib.coverage import LEAST, by_topic, measure, share, verdict
from course_lib.terminal import say

CASES = ("each topic of common/", "common/")
NEEDS = ("gcovr",)


def main():
    chosen = option_parser("coverage", __doc__).parse_args()
    lines = measure()
    rows = [*by_topic(lines), ("common/", lines)]
    save_quantities(chosen.csv, [("drafts and commands of all chapters", case, f"{share(of_case):.2f}", "% of lines",
                                  f"at least {LEAST:.0f}, error paths aside") for case, of_case in rows])
    say(f"  the chapters run {verdict(lines)} of common/")
    return 0


if __name__ == "__main__":
    end_with(main, "coverage")
