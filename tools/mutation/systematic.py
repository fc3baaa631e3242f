"""./course mutants --systematic: which mistakes by rule do a chapter's graded tests let through?"""

from course_lib.chapters import choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, cores
from course_lib.terminal import count
from exercises.catalog import catalog_path, read_catalog
from exercises.trees import work_folder
from mutation.campaign import Campaign, Deadline
from mutation.report import show, show_sum, write_csv, write_json
from mutation.store import Store


def run_systematic(args):
    """@param args  of ./course mutants"""
    if args.all and (args.sample or args.minutes):
        raise CourseError("--all tries all, so it goes with neither --sample nor --minutes")
    if args.seed is None and (args.sample or args.minutes):
        args.seed = 1
    catalogs = [read_catalog(chapter) for chapter in chosen_chapters(args.chapters)]
    ensure_packages("build")
    deadline = Deadline(args.minutes)
    results = []
    with work_folder("mutants", keep=True) as folder:
        store = Store(BUILD / "mutants" / "outcomes.jsonl")
        for catalog in catalogs:
            if not deadline.passed:
                results.append(try_chapter(catalog, folder, store, args, deadline))
                show(results[-1])
    if len(results) > 1:
        show_sum(results)
    if args.json:
        write_json(results, args.json)
    if args.csv:
        write_csv(results, args.csv)
    complain(results, args.at_least)
    return 0


def chosen_chapters(words):
    chapters = choose_chapters(words)
    return chapters if words else [chapter for chapter in chapters if catalog_path(chapter).exists()]


def try_chapter(catalog, folder, store, args, deadline):
    campaign = Campaign(catalog, folder, store, args.jobs or cores())
    if args.only and args.only not in catalog.exercises:
        raise CourseError(f"{catalog.chapter} has no exercise {args.only}; its exercises are {', '.join(catalog.exercises)}")
    campaign.build_reference()
    return campaign.run(campaign.sample(args.sample, args.seed, args.only), deadline)


def complain(results, least):
    """@throws CourseError when too few are caught, or a list of equivalents is wrong"""
    wrong = [complaint for result in results for complaint in result.complaints]
    if wrong:
        raise CourseError(f"{count(len(wrong), 'complaint')}, the first: {wrong[0]}")
    for result in results:
        share = result.share_caught
        if share is None:
            raise CourseError(f"{result.catalog.chapter}: no mutant was tried; give it more --minutes")
        if share < least:
            raise CourseError(f"{result.catalog.chapter}: the graded tests catch {share:.1f} % of the mistakes by rule, and "
                              f"{least:g} % are asked for; the escapes are listed above")
