// --- what leaves the page ------------------------------------------------------------------------------------------

/** The files of a scene by format, as `chatscene export` writes them; they lie in the page compressed. */
async function filesOf(scene) {
  const bytes = Uint8Array.from(atob(content.files[scene.id]), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

function say(text) { $("said").textContent = text; }

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    say("Copied.");
  } catch {
    say("This browser does not let a page copy; select the text, or download the file.");
  }
}

function save(name, text) {
  const link = document.createElement("a");
  link.setAttribute("href", URL.createObjectURL(new Blob([text])));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.getAttribute("href")), 1000);
  say("Saved " + name + ".");
}

function button(text, title, act) {
  const made = Object.assign(element("button", text), { type: "button", title });
  made.addEventListener("click", act);
  return made;
}

function offerFiles(scene) {
  const offers = [], said = Object.assign(document.createElement("output"), { id: "said" });
  const command = "chatscene export . " + scene.id + " --to openscenario --out FOLDER";
  for (const [format, name] of content.files[scene.id] ? Object.entries(content.formats) : []) {
    const use = (act) => async () => {
      const file = (await filesOf(scene))[format];
      if (file.why) say(file.why);
      else act(file);
    };
    offers.push(button("↓ " + name, "Save this scene as " + name + "; the map is not in it", use((file) => save(file.name, file.text))));
    offers.push(button("copy", "Copy this scene as " + name, use((file) => copy(file.text))));
  }
  offers.push(button("copy export command", command + ", in the folder of this page: writes the map as well", () => copy(command)));
  $("files").replaceChildren(element("span", "This scene:"), ...offers, said);
}

function offerCode() {
  for (const code of document.querySelectorAll("pre.code")) {
    code.before(Object.assign(button("Copy", "Copy this text", () => copy(code.textContent)), { className: "copy" }));
  }
}
