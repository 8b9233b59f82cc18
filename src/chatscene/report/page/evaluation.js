// --- the page of an evaluation -------------------------------------------------------------------------------------

const $ = (id) => document.getElementById(id);
document.querySelectorAll(".sortable").forEach(makeSortable);
listenToTable();
