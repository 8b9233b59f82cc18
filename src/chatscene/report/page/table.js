// --- the table of scenes -------------------------------------------------------------------------------------------

const rows = () => [...document.querySelectorAll("#scenes tbody tr")];

/** The value of a cell to sort by: a number where it is one, and what is empty last. */
function valueOf(row, column) {
  const text = row.cells[column].textContent.trim(), number = Number(text);
  return text === "" ? null : Number.isNaN(number) ? text : number;
}

function sortBy(column, down) {
  const sign = down ? -1 : 1, body = document.querySelector("#scenes tbody");
  const order = rows().map((row) => [valueOf(row, column), row]).sort(([a], [b]) => {
    if (a === null || b === null) return (a === null) - (b === null);
    return sign * (typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en"));
  });
  body.append(...order.map(([, row]) => row));
}

function filterRows() {
  const wanted = $("find").value.toLowerCase(), only = $("only").value, all = rows();
  for (const row of all) {
    row.hidden = (only && !row.classList.contains(only)) || !row.textContent.toLowerCase().includes(wanted);
  }
  $("found").textContent = all.filter((row) => !row.hidden).length + " of " + all.length + " scenes";
}

function listenToTable() {
  if (!$("filters")) return;
  $("filters").hidden = false;
  const heads = [...document.querySelectorAll("#scenes thead th")];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "sort";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      sortBy(column, down);
    });
  });
  for (const id of ["find", "only"]) $(id).addEventListener("input", filterRows);
  filterRows();
}
