// Replays of the gallery open on a stage above the cards; without this script their links open them as pages.
document.addEventListener("DOMContentLoaded", () => {
  const gallery = document.querySelector(".gallery");
  if (!gallery) return;
  const links = [...document.querySelectorAll("a.replay")];
  if (!links.length) return;

  const stage = document.createElement("section");
  stage.className = "stage";
  stage.innerHTML = '<iframe title="Replay" loading="lazy" allow="fullscreen"></iframe><p><strong></strong><a>on a page of its own</a></p>';
  gallery.before(stage);
  const [frame, name, alone] = ["iframe", "strong", "a"].map((tag) => stage.querySelector(tag));

  const dark = () => {
    const theme = document.body.dataset.theme;
    return theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  };
  const show = (link, play) => {
    const file = link.getAttribute("href");
    // Another address behind # alone would not load the page again.
    frame.src = `${file}?${dark() ? "dark" : "light"}#${dark() ? "theme=dark" : "theme=light"}${play ? "&play=1" : ""}`;
    name.textContent = file.replace(/^.*\/|\.html$/g, "");
    alone.href = file;
    links.forEach((other) => other.classList.toggle("shown", other === link));
  };
  for (const link of links)
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      show(link, true);
      stage.scrollIntoView({ behavior: "smooth", block: "start" });
    });
  show(links[0], false);
  new MutationObserver(() => show(links.find((link) => link.classList.contains("shown")), false)).observe(document.body, {
    attributeFilter: ["data-theme"],
  });
});
