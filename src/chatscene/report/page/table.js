// --- the table of scenes -------------------------------------------------------------------------------------------

function filterRows() {
  const wanted = $("find").value.toLowerCase(), only = $("only").value, all = [...$("scenes").tBodies[0].rows];
  for (const row of all) {
    row.hidden = (only && !row.classList.contains(only)) || !row.textContent.toLowerCase().includes(wanted);
  }
  $("found").textContent = all.filter((row) => !row.hidden).length + " of " + all.length + " scenes";
}

function listenToTable() {
  if (!$("filters")) return;
  $("filters").hidden = false;
  makeSortable($("scenes"));
  for (const id of ["find", "only"]) $(id).addEventListener("input", filterRows);
  filterRows();
}
