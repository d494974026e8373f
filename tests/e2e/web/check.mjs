// Checks that say what they wanted, and patience: the machine may be slow, a test may not be.
export function check(good, what) {
  if (!good) throw new Error(what);
  console.log(`ok: ${what}`);
}

/// A page that is being left or loaded answers nothing yet: undefined.
async function onPage(condition) {
  try {
    return await condition();
  } catch (error) {
    if (!/navigated or closed|context was destroyed|Cannot find (default )?(execution )?context/i.test(error.message)) throw error;
    return undefined;
  }
}

export async function until(what, condition, seconds = 120) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const value = await onPage(condition);
    if (value) {
      console.log(`ok: ${what}`);
      return value;
    }
    if (Date.now() > end) throw new Error(`waited ${seconds} s in vain: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

export const near = (a, b, tolerance) => Math.hypot(...a.map((v, i) => v - b[i])) <= tolerance;

/// The end of a test that failed: what was wrong, the page's state, its errors and a picture; without a page, the first.
export async function giveUp(browser, error, state, picture) {
  console.error(`FAILED: ${error.message}`);
  if (browser) {
    console.error(JSON.stringify(await state().catch(() => null)), browser.problems.join('\n'));
    await browser.screenshot(picture).catch(() => {});
    await browser.close();
  }
  process.exit(1);
}
