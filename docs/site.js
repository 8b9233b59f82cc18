// What Material leaves out for who uses no mouse or no screen: tables that scroll can be scrolled by key, and each part
// of a menu, the buttons of each block of code, and the search have a name of their own.
document$.subscribe(() => {
  document.querySelector(".md-search[role=dialog]")?.setAttribute("aria-label", "Search");
  document.querySelectorAll(".md-typeset__scrollwrap").forEach((table) => table.setAttribute("tabindex", "0"));
  document.querySelectorAll("nav.md-nav[aria-labelledby], nav.md-code__nav").forEach((part, number) => {
    const label = document.getElementById(part.getAttribute("aria-labelledby"));
    part.removeAttribute("aria-labelledby");
    part.setAttribute("aria-label", `${label ? label.textContent.trim() : "Code"}, ${number + 1}`);
  });
});
