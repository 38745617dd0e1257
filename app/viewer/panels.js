// panels.js: the facts of a run as tables and as one line.

/** The members of an object as rows; text is set as text, never as HTML. Lists of objects are left
 *  to those who read run.json. */
function tableOf(object) {
  const table = document.createElement("table");
  const addRows = (members, depth) => {
    for (const [name, x] of Object.entries(members)) {
      const isList = Array.isArray(x);
      if (isList && x.some(e => e !== null && typeof e === "object")) continue;
      const cell = table.insertRow().insertCell();
      cell.textContent = name.replace(/_/g, " ");
      cell.style.paddingLeft = 14 * depth + "px";
      if (x !== null && typeof x === "object" && !isList) {
        cell.colSpan = 2;
        cell.className = "group";
        addRows(x, depth + 1);
      } else {
        cell.parentNode.insertCell().textContent = isList ? x.map(factText).join(", ") : factText(x);
      }
    }
  };
  addRows(object, 0);
  return table;
}

function factText(x) {
  if (x === null) return "\u2013";
  return typeof x === "number" && !Number.isInteger(x) ? shortNumber(x) : String(x);
}

function escaped(text) {
  const span = document.createElement("span");
  span.textContent = text;
  return span.innerHTML;
}

/** How the run ended and its size, as HTML for the head of the page. */
function headline(run, film, begin, end, recorded) {
  const parts = [];
  const fact = (name, text) => { if (run && run[name] !== undefined) parts.push(text(run[name])); };
  fact("state", x => ["finished", "ok", "done"].includes(x) ? escaped(x) : `<span class="bad">${escaped(x)}</span>`);
  parts.push(`<b>${shortNumber(end - begin)}</b> s`);
  fact("steps", x => `<b>${escaped(factText(x))}</b> steps`);
  fact("impacts", x => `<b>${escaped(factText(x))}</b> impacts`);
  fact("wall_s", x => `computed in <b>${escaped(factText(x))}</b> s`);
  if (film.count) parts.push(`${film.count} frames${film.count < recorded ? ` of ${recorded}` : ""}`);
  return parts.join(" \u00b7 ");
}
