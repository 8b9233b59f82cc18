// --- tables that sort ----------------------------------------------------------------------------------------------

/** The value of a cell to sort by: what it says of itself, else its text; a number where it is one, null where empty. */
function valueOf(row, column) {
  const cell = row.cells[column], text = (cell.dataset.value ?? cell.textContent).trim(), number = Number(text);
  return text === "" ? null : Number.isNaN(number) ? text : number;
}

function sortBy(body, column, down) {
  const sign = down ? -1 : 1;
  const order = [...body.rows].map((row) => [valueOf(row, column), row]).sort(([a], [b]) => {
    if (a === null || b === null) return (a === null) - (b === null);
    return sign * (typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en"));
  });
  body.append(...order.map(([, row]) => row));
}

/** A button in each head of a table, which sorts it. */
function makeSortable(table) {
  const heads = [...table.tHead.rows[0].cells];
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
      sortBy(table.tBodies[0], column, down);
    });
  });
}
