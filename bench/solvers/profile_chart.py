"""A performance profile as SVG: share of problems over the time ratio, logarithmic."""
import math
from html import escape

WIDTH, HEIGHT = 760, 440
LEFT, RIGHT, TOP, BOTTOM = 58, 196, 44, 54
DECADES = 3  # time ratios up to 1000
DRAWN = 4  # curves with a name for each program; the others are grey
VIRTUAL = "Siconos, best of all"  # for each problem its fastest solver; nobody can choose that well

# Okabe and Ito's colours, told apart with every kind of colour vision; the default comes first.
# Ours are solid, those of others dashed, so that colour is never the only mark.
OURS = ["#0072B2", "#009E73", "#3fa7df", "#4b3b98"]
THEIRS = ["#D55E00", "#b8508c", "#c98a00", "#7a4a1c"]
DASHES = ["7 3", "3 3", "9 3 2 3", "12 4"]


def x_of(ratio):
    return LEFT + (WIDTH - LEFT - RIGHT) * min(math.log10(ratio) / DECADES, 1.0)


def y_of(share):
    return TOP + (HEIGHT - TOP - BOTTOM) * (1.0 - share)


def path_of(ratios, count):
    """The staircase; it ends at the right edge."""
    steps = [f"M{x_of(1):.1f},{y_of(sum(r <= 1 for r in ratios) / count):.1f}"]
    for k, ratio in enumerate(ratios, 1):
        if 1 < ratio <= 10**DECADES:
            steps.append(f"H{x_of(ratio):.1f}V{y_of(k / count):.1f}")
    return "".join(steps) + f"H{x_of(10**DECADES):.1f}"


def area(curve):
    """Mean share over the logarithmic axis: what ranks the curves."""
    ratios, count = curve
    return sum(1.0 - min(math.log10(r) / DECADES, 1.0) for r in ratios) / max(count, 1)


def share_at_end(curve):
    ratios, count = curve
    return sum(r <= 10**DECADES for r in ratios) / max(count, 1)


def spread(labels, gap=16.5):
    """Moves labels (y, …) apart, in order, inside the plot."""
    labels = sorted(labels, key=lambda label: label[0])
    ys = [label[0] for label in labels]
    for k in range(1, len(ys)):
        ys[k] = max(ys[k], ys[k - 1] + gap)
    over = max(0.0, ys[-1] - (HEIGHT - BOTTOM)) if ys else 0.0
    if over:
        ys[-1] -= over
        for k in range(len(ys) - 2, -1, -1):
            ys[k] = min(ys[k], ys[k + 1] - gap)
    return [(y, *label) for y, label in zip(ys, labels)]


def axes(title, problems):
    out = [f'<text x="{LEFT}" y="22" class="title">{escape(title)} '
           f'<tspan class="soft">share of {problems} problems</tspan></text>']
    for k in range(0, 5):
        y = y_of(k / 4)
        out.append(f'<path class="grid" d="M{LEFT},{y:.1f}H{WIDTH - RIGHT}"/>'
                   f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{25 * k} %</text>')
    for k in range(DECADES + 1):
        x = x_of(10**k)
        out.append(f'<path class="grid" d="M{x:.1f},{TOP}V{HEIGHT - BOTTOM}"/>'
                   f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 19}" text-anchor="middle">{10**k}</text>')
    middle = (LEFT + WIDTH - RIGHT) / 2
    out.append(f'<text x="{middle}" y="{HEIGHT - 14}" text-anchor="middle">time divided by that of '
               f'the fastest solver of the problem</text>')
    return out


STYLE = """<style>
text{font:13px system-ui,"Segoe UI",Helvetica,Arial,sans-serif;fill:#222}
.title{font-size:15px;font-weight:600}.soft{fill:#555;font-weight:400;font-size:12px}
.grid{stroke:#dcdcdc;stroke-width:1;fill:none}path{fill:none;stroke-linejoin:round}
</style>"""


def method_of(name):
    """A solver without its settings."""
    return name.split(":")[0]


def best_settings(curves):
    """method -> its best curve's name."""
    best = {}
    for name in sorted(curves, key=lambda n: -area(curves[n])):
        best.setdefault(method_of(name), name)
    return best


def marks_of(charts, default):
    """method -> (colour, dash), the same in all charts: the best of each program over all charts,
    the default always."""
    total = {}
    for curves in charts:
        for method, name in best_settings(curves).items():
            total[method] = total.get(method, 0.0) + area(curves[name])
    ranked = sorted((m for m in total if m != VIRTUAL), key=lambda m: (m != default, -total[m]))
    marks = {VIRTUAL: ("#333333", "1.5 3")}
    for k, method in enumerate([m for m in ranked if not m.startswith("Siconos ")][:DRAWN]):
        marks[method] = (OURS[k], None)
    for k, method in enumerate([m for m in ranked if m.startswith("Siconos ")][:DRAWN]):
        marks[method] = (THEIRS[k], DASHES[k])
    return marks


def chart(curves, title, problems, default, marks_by_method):
    """curves: solver -> (sorted ratios of the problems it solves, number of problems counted)."""
    marks = {name: marks_by_method[method] for method, name in best_settings(curves).items()
             if method in marks_by_method}
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
           f'role="img" aria-label="{escape(title)}">{STYLE}'
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>', *axes(title, problems)]
    for name, (ratios, count) in curves.items():
        if name not in marks and ratios:
            out.append(f'<path d="{path_of(ratios, count)}" stroke="#d0d0d0">'
                       f'<title>{escape(name)}</title></path>')
    for name in reversed(marks):
        colour, dash = marks[name]
        out.append(f'<path d="{path_of(*curves[name])}" stroke="{colour}" '
                   f'stroke-width="{4 if name == default else 2}"'
                   + (f' stroke-dasharray="{dash}"' if dash else "") +
                   f'><title>{escape(name)}</title></path>')
    edge = WIDTH - RIGHT
    labels = [(y_of(share_at_end(curves[n])), n, *marks[n]) for n in marks]
    # Curves that end at the same height are labelled in the order of their areas.
    labels.sort(key=lambda label: (label[0], -area(curves[label[1]])))
    for y, end, name, colour, dash in spread(labels):
        weight = "700" if name == default else "400"
        out.append(f'<path d="M{edge + 1},{end:.1f}L{edge + 10},{y:.1f}H{edge + 30}" '
                   f'stroke="{colour}" stroke-width="{3 if name == default else 1.6}"'
                   + (f' stroke-dasharray="{dash}"' if dash else "") + '/>'
                   f'<text x="{edge + 34}" y="{y + 4:.1f}" style="fill:{colour};'
                   f'font-weight:{weight};font-size:12px">{escape(short(name))}</text>')
    return "\n".join(out) + "\n</svg>\n"


def short(name):
    return name.replace("relaxation=", "").replace("factor=", "× ")
