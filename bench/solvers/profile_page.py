"""The page and the text tables of `profile`."""
from html import escape

EQUAL_US = 5.0
GOAL_MEAN, GOAL_WORST = 1.0 / 3.0, 3.0

CSS = """
:root{--ink:#222;--soft:#555;--line:#ddd;--back:#fff;--lost:#a8430a;--lostback:#fdf0e6;--good:#00664c}
body{font:15px/1.5 system-ui,"Segoe UI",Helvetica,Arial,sans-serif;color:var(--ink);
 background:var(--back);max-width:1280px;margin:2rem auto;padding:0 1.2rem}
h1{font-size:1.6rem;margin-bottom:.2rem}h2{font-size:1.15rem;margin-top:2rem}
p{max-width:75ch}.soft{color:var(--soft)}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(520px,1fr));gap:14px}
.charts svg{width:100%;height:auto;border:1px solid var(--line);border-radius:6px}
.verdict{display:grid;grid-template-columns:repeat(auto-fit,minmax(300px,1fr));gap:14px;margin:1.2rem 0}
.card{border:1px solid var(--line);border-radius:6px;padding:.7rem 1rem}
.card b{font-size:1.5rem;display:block;line-height:1.25}.card h3{margin:0 0 .4rem;font-size:1rem}
.met{color:var(--good)}.missed{color:var(--lost)}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums;width:100%}
th,td{padding:3px 8px;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}
th{position:sticky;top:0;background:var(--back);font-weight:600}
th:first-child,td:first-child,td.name{text-align:left}
tr.level th{text-align:center;border-bottom:0}.first{border-left:2px solid var(--line)}
td.lost{background:var(--lostback);color:var(--lost);font-weight:600}
"""


def level_text(level):
    return f"{level:.0e}".replace("e-0", "e-")


def time_text(us):
    """Microseconds below a millisecond, else milliseconds."""
    if us >= 1e6:
        return f"{us / 1e6:.3g} s"
    return f"{us / 1e3:.3g} ms" if us >= 1e3 else f"{us:.3g} µs"


def row_of(results, problem, level):
    """Default, fastest of Siconos, ratio, fastest of ours; texts, "–" where nothing is solved."""
    ours = results.solved.get((problem.name, "Automatic", level))
    theirs = results.best(problem.name, level, "siconos")
    best = results.best(problem.name, level, "dynamy")
    ratio = results.ratio(problem.name, level)
    asked = any((problem.name, s) in results.meant for s in results.solvers("siconos"))
    return (time_text(ours.time) if ours else "–",
            f"{time_text(theirs[0])} {theirs[1].removeprefix('Siconos ')}" if theirs else "–",
            f"{ratio:.2f}" if ratio is not None else ("only we" if ours and asked else "–"),
            (best[1] if best and (not ours or best[0] < 0.9 * ours.time) else ""),
            (ratio is not None and ratio > 1.0) or (ours is None and theirs is not None))


def cards(verdicts):
    out = ['<div class="verdict">']
    for v in verdicts:
        if v["mean"] is None:
            continue
        worst, name = v["worst"]
        mark = ["missed", "met"]
        out.append(
            f'<div class="card"><h3>residual ≤ {level_text(v["level"])}</h3>'
            f'<b class="{mark[v["mean"] <= GOAL_MEAN]}">{v["mean"]:.2f}</b>'
            f'geometric mean of our time over the best of Siconos (goal ≤ 0.33)'
            f'<b class="{mark[worst <= GOAL_WORST]}">{worst:.2f}</b>'
            f'worst ratio, {escape(name)} (goal ≤ 3)'
            f'<b>{v["ours"]} : {v["theirs"]}</b>solved of {v["problems"]}: Automatic : any of '
            f'Siconos</div>')
    return "\n".join(out) + "</div>"


def table(results, problems):
    heads = "".join(f'<th colspan="4" class="first">{level_text(level)}</th>'
                    for level in results.levels)
    subs = '<th class="first">Automatic</th><th>Siconos</th><th>ratio</th><th>faster of ours</th>'
    out = [f'<div class="scroll"><table><thead><tr class="level"><th></th><th></th><th></th>{heads}'
           f'</tr><tr><th>problem</th><th>dim</th><th>contacts</th>{subs * len(results.levels)}'
           '</tr></thead><tbody>']
    for p in sorted(problems, key=lambda p: (p.contacts, p.name)):
        cells = [f"<td>{escape(p.name)}</td><td>{p.dim}</td><td>{p.contacts}</td>"]
        for level in results.levels:
            ours, theirs, ratio, best, lost = row_of(results, p, level)
            cells.append(f'<td class="first">{ours}</td><td>{escape(theirs)}</td>'
                         f'<td class="{"lost" if lost else ""}">{"▲ " if lost else ""}{ratio}</td>'
                         f'<td class="name soft">{escape(best)}</td>')
        out.append(f"<tr>{''.join(cells)}</tr>")
    return "\n".join(out) + "</tbody></table></div>"


def shares(results, problems):
    """How many problems each solver finishes."""
    heads = "".join(f"<th>{level_text(level)}</th>" for level in results.levels)
    out = [f"<table><thead><tr><th>solver</th>{heads}</tr></thead><tbody>"]
    for solver in results.solvers():
        meant = [p.name for p in problems if (p.name, solver) in results.meant]
        cells = "".join(
            f"<td>{sum((n, solver, level) in results.solved for n in meant)}/{len(meant)}</td>"
            for level in results.levels)
        if meant:
            out.append(f"<tr><td>{escape(solver)}</td>{cells}</tr>")
    return "\n".join(out) + "</tbody></table>"


def page(results, charts, verdicts, friction):
    figures = "\n".join(charts[label, level] for level in results.levels
                        for label in ("all", "large"))
    rest = [p for p in results.problems.values() if p.dim not in (2, 3)]
    return f"""<!doctype html><html lang="en"><meta charset="utf-8">
<meta name="viewport" content="width=device-width,initial-scale=1"><title>Inclusion solvers</title>
<style>{CSS}</style><h1>Inclusion solvers on contact problems</h1>
<p class="soft">Solid lines and plain names: dynamY; dashed and “Siconos”: the solvers of Siconos.
CPU time of a solve from zero, median; times below {EQUAL_US:.0f} µs count as equal; limit
{results.limit:g} s a solve, more for over 700 contacts. Residual: natural map of the exact law over |q|, recomputed.</p>
<h2>Problems with 20 and more contacts</h2>{cards(verdicts)}
<h2>Performance profiles</h2><p class="soft">Share of problems solved within a multiple of the time
of the fastest solver. Further up and further left is better. Grey: the others. “Best of all” takes
for each problem the solver of Siconos that turned out fastest.</p>
<div class="charts">{figures}</div>
<h2>Problem by problem</h2><p class="soft">Ratio: Automatic over the fastest solver of Siconos; ▲ we
lose.</p>{table(results, friction(results, 1))}
<h2>Rolling friction and plain complementarity</h2>{table(results, rest)}
<h2>Problems solved, 20 and more contacts</h2>{shares(results, friction(results, 20))}
</html>
"""


def markdown(results, verdicts, friction):
    """The tables as text, times in the unit that suits."""
    out = ["| level | problems | solved: Automatic | solved: any of Siconos | geometric mean | "
           "worst | lost, all sizes |", "|---|---|---|---|---|---|---|"]
    for v in verdicts:
        if v["mean"] is None:
            continue
        out.append(f'| {level_text(v["level"])} | {v["problems"]} | {v["ours"]} | {v["theirs"]} | '
                   f'{v["mean"]:.2f} | {v["worst"][0]:.2f} ({v["worst"][1]}) | {len(v["lost"])} |')
    out.append("")
    heads = " | ".join(f"{level_text(l)}: Automatic | best of Siconos | ratio"
                       for l in results.levels)
    out += [f"| problem | contacts | {heads} |", "|---" * (2 + 3 * len(results.levels)) + "|"]
    for p in sorted(friction(results, 1), key=lambda p: (p.contacts, p.name)):
        cells = []
        for level in results.levels:
            ours, theirs, ratio, _, lost = row_of(results, p, level)
            cells += [ours, theirs, f"**{ratio}**" if lost else ratio]
        out.append(f"| {p.name} | {p.contacts} | " + " | ".join(cells) + " |")
    out.append("")
    large = friction(results, 20)
    out += ["| solver | " + " | ".join(level_text(l) for l in results.levels) + " |",
            "|---" * (1 + len(results.levels)) + "|"]
    for solver in results.solvers():
        meant = [p.name for p in large if (p.name, solver) in results.meant]
        if meant:
            out.append(f"| {solver} | " + " | ".join(
                f"{sum((n, solver, l) in results.solved for n in meant)}/{len(meant)}"
                for l in results.levels) + " |")
    return "\n".join(out) + "\n"
