// What the other scripts share: elements, questions to the server, frames for reports. Text becomes text, never markup.

export const $ = (id) => document.getElementById(id);

/** An element with properties, and with children, of which texts are shown as they are. */
export function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== ""));
  return made;
}

/** A button that does something. */
export function button(label, act, properties) {
  const made = element("button", { type: "button", ...properties }, label);
  made.addEventListener("click", act);
  return made;
}

async function answered(response) {
  const content = await response.json();
  if (!response.ok) throw new Error(content.error);
  return content;
}

/** What the server tells; addresses are below the page's own, which has the secret. */
export const ask = async (path) => answered(await fetch(path));

/** Have the server do something. */
export const tell = async (path, content) =>
  answered(await fetch(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(content) }));

/** Say what went wrong, at the top; nothing takes it away again. */
export function trouble(error) {
  $("trouble").hidden = !error;
  $("trouble").textContent = error ? (error instanceof TypeError ? "The server does not answer; is chatscene view still running?" : error.message) : "";
}

/** Do something, and say it if that goes wrong. */
export const trying = (act) => async (...given) => {
  try {
    trouble(null);
    return await act(...given);
  } catch (error) {
    return trouble(error);
  }
};

export const about = await ask("about");

/** Where the report of a run or an evaluation is, or the page of a coverage. */
export const reportOf = (name, file = "report.html") => `../${about.reports}/${name.split("/").map(encodeURIComponent).join("/")}/${file}`;

/** A report in a frame: its script may run in there, and reaches nothing outside. */
export function framed(address, title) {
  const frame = element("iframe", { title, className: "report", ariaBusy: "true" });
  frame.sandbox = "allow-scripts allow-downloads";
  frame.addEventListener("load", () => { frame.ariaBusy = null; });
  frame.src = address;
  return frame;
}

export const plural = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;
