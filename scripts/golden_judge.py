"""What golden hashes, and the pages of studies, have to say beside the record of the engine.

    scripts/golden_hashes               judges those of a program
    scripts/golden_hashes --self-test   breaks a sound record in every way and sees that it is found
"""

import copy
import re
import sys
from pathlib import Path

NEAR_THE_TOP = 10  # lines
SKIPPED = 77  # exit code: nothing on record for this machine


def entry_of(machine, record):
    return next((entry for entry in record["entries"] if entry["machine"] == machine), None)


def behaviours(record):
    """Of all machines: study pages made on any of them are up to date."""
    return {entry["behaviour"] for entry in record["entries"]}


def named_in(text):
    return set(re.findall(r"\bbehaviour\b\W+([0-9a-f]{12})\b", text))


def notice_of(behaviour):
    return f"This page was made by an earlier engine (behaviour {behaviour}); it is to be made anew."


def teller_of(name):
    """The page that says that this one waits: a file of figures has a page of the same name."""
    return name if name.endswith(".md") else f"{Path(name).parent}.md"


def says_so(text, behaviour):
    return notice_of(behaviour) in text.splitlines()[:NEAR_THE_TOP]


def wrongly_waiting(pages, record):
    """One sentence for each page that waits to be made anew and should not, or does not say so."""
    for name, behaviour in record.get("awaiting", {}).items():
        if name not in pages:
            yield f"{name} is said to wait to be made anew and is no page of a study"
        elif named_in(pages[name]) in ({each} for each in behaviours(record)) or behaviour in behaviours(record):
            yield f"{name} is of the engine on record and waits no more: --await takes it off the list"
        elif not {behaviour} <= named_in(pages[name]) <= {behaviour} | behaviours(record):  # some parts may be new
            yield f"{name} is said to be of the engine {behaviour} and names {sorted(named_in(pages[name]))}"
        elif not says_so(pages.get(teller_of(name), ""), behaviour):
            yield f"{name} waits to be made anew and {teller_of(name)} does not say so: {notice_of(behaviour)}"


def stale_pages(pages, record):
    """One sentence for each page that is not of the engine on record and does not wait. pages: text by name"""
    yield from wrongly_waiting(pages, record)
    for name, text in pages.items():
        named = named_in(text)
        if name in record.get("awaiting", {}):
            continue
        if not named:
            yield f"{name} does not say which engine made it"
        elif not named <= behaviours(record):
            yield (f"{name} is of an engine that did something else: its behaviour was {', '.join(sorted(named))} and is "
                   f"{' or '.join(sorted(behaviours(record)))}; make it anew")


def differences(found, entry):
    """One sentence for each scene that is not as it was."""
    before, now = entry["hashes"], found["hashes"]
    for name in [*before, *(name for name in now if name not in before)]:
        if name not in now:
            yield f"'{name}' is on record, and the program has no such scene"
        elif name not in before:
            yield f"'{name}' is not on record"
        elif before[name] != now[name]:
            what = " and ".join(kind for kind in before[name] if before[name][kind] != now[name].get(kind))
            yield f"'{name}' ends otherwise: its {what} moved"
    if before == now and entry["behaviour"] != found["behaviour"]:
        yield f"the behaviour on record, {entry['behaviour']}, is not that of its hashes, {found['behaviour']}"


def why_skipped(machine, record):
    """The least that sets this machine apart from one on record."""
    others = [[f"{key} {machine[key]} (on record {entry['machine'].get(key)})" for key in machine
               if machine[key] != entry["machine"].get(key)] for entry in record["entries"]]
    return "nothing on record for " + ", ".join(min(others, key=len) if others else ["any machine"])


def compare(found, record):
    """@returns the exit code and what to say"""
    entry = entry_of(found["machine"], record)
    if entry is None:
        return SKIPPED, [f"skipped: {why_skipped(found['machine'], record)}"]
    sentences = list(differences(found, entry))
    if sentences:
        return 1, sentences + [f"the engine's behaviour was {entry['behaviour']} and is {found['behaviour']}; if that is "
                               "meant, scripts/golden_hashes --update, and make the study pages anew"]
    return 0, [f"{len(entry['hashes'])} scenes end as on record: behaviour {found['behaviour']}"]


def updated(found, record):
    entry = entry_of(found["machine"], record)
    same_engine = entry is None or entry["behaviour"] == found["behaviour"]
    others = [each for each in record["entries"] if each is not entry] if same_engine else []
    return {**record, "entries": others + [found]}


def with_notice(text, behaviour):
    """Below the title, once."""
    if says_so(text, behaviour):
        return text
    title, _, rest = text.partition("\n")
    return f"{title}\n\n{notice_of(behaviour)}\n{rest}"


def awaited(names, pages, record):
    """@returns pages and record after --await, and what is wrong with the names"""
    pages, wrong = dict(pages), []
    awaiting = {name: behaviour for name, behaviour in record.get("awaiting", {}).items()
                if name in pages and not named_in(pages[name]) <= behaviours(record)}
    for name in names:
        named = named_in(pages.get(name, ""))
        if len(named) != 1:
            wrong.append(f"{name} is no page of a study, or does not name the one engine that made it")
        elif named <= behaviours(record):
            wrong.append(f"{name} is of the engine on record: there is nothing to wait for")
        else:
            awaiting[name] = named.pop()
            pages[teller_of(name)] = with_notice(pages[teller_of(name)], awaiting[name])
    others = {key: value for key, value in record.items() if key != "awaiting"}
    return pages, {**others, "awaiting": awaiting} if awaiting else others, wrong


def sound_record():
    machine = {"instruction_set": "x86-64-v3", "compiler": "g++ 1"}
    hashes = {"slide": {"state": "a1", "report": "b1"}, "rock": {"state": "a2", "report": "b2"}}
    found = {"machine": machine, "behaviour": "e1", "hashes": hashes}
    other = {"machine": {**machine, "instruction_set": "x86-64"}, "behaviour": "e2", "hashes": hashes}
    return copy.deepcopy(found), {"about": "", "entries": copy.deepcopy([found, other])}


# How what the program gives is changed, the exit code, and what must be said of it.
DAMAGES = (
    (lambda f: f["hashes"]["slide"].update(state="a9"), 1, "'slide' ends otherwise: its state moved"),
    (lambda f: f["hashes"]["rock"].update(report="b9"), 1, "'rock' ends otherwise: its report moved"),
    (lambda f: f["hashes"].pop("rock"), 1, "no such scene"),
    (lambda f: f["hashes"].update(fall={}), 1, "'fall' is not on record"),
    (lambda f: f.update(behaviour="e9"), 1, "is not that of its hashes"),
    (lambda f: f["machine"].update(compiler="g++ 2"), SKIPPED, "compiler g++ 2 (on record g++ 1)"),
    (lambda f: f["machine"].update(blas="other"), SKIPPED, "blas other"),
)


OLD, NEW = "e0f0e0f0e0f0", "e1f0e1f0e1f0"


def sound_pages():
    """One of the engine on record, one of an earlier one, and its figures. @returns text by name, record"""
    pages = {"new.md": f"# New\n\nText; behaviour {NEW}.", "study.md": f"# Study\n\nText; behaviour {OLD}.",
             "study/study.json": f'"behaviour": "{OLD}"'}
    return pages, {"about": "", "entries": [{"behaviour": NEW}]}


# How pages that wait soundly are damaged, and what must be said of it.
PAGE_DAMAGES = (
    (lambda p, r: p.update({"study.md": f"# Study\n\nText; behaviour {OLD}."}), "study.md does not say so"),
    (lambda p, r: p.update({"study.md": "\n" * 20 + p["study.md"]}), "study.md does not say so"),
    (lambda p, r: p.update({"study/study.json": ""}), "study.json is said to be of the engine"),
    (lambda p, r: p.update({"study.md": f"# Study\n\nText; behaviour {NEW}."}), "study.md is of the engine on record"),
    (lambda p, r: p.update({"study/study.json": f'"behaviour": "{NEW}"'}), "study.json is of the engine on record"),
    (lambda p, r: p.update({"study.md": p["study.md"] + f" behaviour {'e9' * 6}"}), "study.md is said to be of the engine"),
    (lambda p, r: r["awaiting"].update({"study.md": NEW}), "study.md is of the engine on record"),
    (lambda p, r: r["awaiting"].update({"other.md": OLD}), "other.md is said to wait"),
    (lambda p, r: r["awaiting"].pop("study/study.json"), "study.json is of an engine that did something else"),
    (lambda p, r: r.pop("awaiting"), "study.md is of an engine that did something else"),
)


def test_of_waiting():
    names = ["study.md", "study/study.json"]
    pages, record, wrong = awaited(names, *sound_pages())
    wrong = [f"an honest page may not wait: {told}" for told in [*wrong, *stale_pages(pages, record)]]
    if awaited(names, pages, record)[:2] != (pages, record):
        wrong.append("to wait twice is not to wait once")
    if pages["study.md"] != f"# Study\n\n{notice_of(OLD)}\n\nText; behaviour {OLD}.":
        wrong.append(f"the notice is not put below the title: {pages['study.md']}")
    if updated({"machine": {}, "behaviour": NEW}, {**record, "entries": []}).get("awaiting") != record["awaiting"]:
        wrong.append("an update forgets which pages wait")
    for name in ("new.md", "other.md"):
        if len(awaited([name], *sound_pages())[2]) != 1:
            wrong.append(f"{name} may wait")
    for damage, words in PAGE_DAMAGES:
        broken, its_record = dict(pages), copy.deepcopy(record)
        damage(broken, its_record)
        told = list(stale_pages(broken, its_record))
        if not any(words in sentence for sentence in told):
            wrong.append(f"'{words}' is not said: {told}")
    made_anew = {name: text.replace(OLD, NEW) for name, text in sound_pages()[0].items()}
    if awaited([], made_anew, record)[1] != sound_pages()[1]:
        wrong.append("pages that were made anew stay on the list")
    return wrong


def self_test():
    wrong = test_of_waiting()
    found, record = sound_record()
    if compare(found, record)[0] != 0:
        wrong.append("sound hashes are refused")
    if behaviours(updated(found, record)) != {"e1", "e2"}:
        wrong.append("an update that changes nothing drops an entry")
    for damage, code, words in DAMAGES:
        found, record = sound_record()
        damage(found)
        told = compare(found, record)
        if told[0] != code or not any(words in sentence for sentence in told[1]):
            wrong.append(f"'{words}' is not said: {told}")
        if compare(found, updated(found, record))[0] != 0:
            wrong.append(f"'{words}': an update does not put it right")
    found["behaviour"] = "e9"
    found["machine"] = sound_record()[0]["machine"]
    if behaviours(updated(found, record)) != {"e9"}:
        wrong.append("an entry of another engine outlives an update")
    pages = {"good.md": "; behaviour e1f0e1f0e1f0.", "good.json": '"behaviour": "e1f0e1f0e1f0"', "bad.md": "behaviour e2f0e1f0e1f0",
             "silent.md": "behaviour"}
    told = list(stale_pages(pages, {"entries": [{"behaviour": "e1f0e1f0e1f0"}]}))
    if [sentence.split()[0] for sentence in told] != ["bad.md", "silent.md"]:
        wrong.append(f"stale pages are not found: {told}")
    for sentence in wrong:
        print(f"golden_hashes: {sentence}", file=sys.stderr)
    if not wrong:
        print(f"golden_hashes: sound hashes pass, and each of {len(DAMAGES) + len(PAGE_DAMAGES)} changes is found")
    return 1 if wrong else 0
