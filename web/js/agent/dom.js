// An element with its properties, attributes (in `set`) and children.
export function make(tag, properties = {}, ...children) {
  const { set = {}, ...rest } = properties;
  const element = Object.assign(document.createElement(tag), rest);
  for (const [name, value] of Object.entries(set)) element.setAttribute(name, value);
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

const box = document.getElementById('message');
let timer = 0;
// What went wrong, for some seconds.
export function complain(error) {
  box.textContent = error.message ?? error;
  box.hidden = false;
  clearTimeout(timer);
  timer = setTimeout(() => { box.hidden = true; }, 6000);
}
