// Where things are on the page.

/// The texts of what is seen and reads like a clock, by the id of its element.
export const clocks = (browser) => browser.run(`Object.fromEntries([...document.querySelectorAll('body *')]
  .filter((e) => [...e.childNodes].some((n) => n.nodeType === Node.TEXT_NODE && /[0-9]:[0-9]{2}([^0-9]|$)/.test(n.data)) && e.getClientRects().length)
  .map((e) => [e.id, e.textContent]))`);

/// Which of the elements that are seen lie over the first one; a part of an element is its own.
export const overlapped = (browser, id, others) => browser.run(`(() => {
  const box = (id) => document.getElementById(id).getBoundingClientRect();
  const a = box('${id}');
  return ${JSON.stringify(others)}.filter((id) => {
    const b = box(id);
    return b.width > 0 && b.left < a.right && a.left < b.right && b.top < a.bottom && a.top < b.bottom;
  });
})()`);

export const resize = (browser, width, height) =>
  browser.call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
