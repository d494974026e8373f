// The moment that the page shows: of a live agent, its game's clock. This is the place for stepping through a log: a source
// of moments other than the live one shows its bar here and answers the same protocol, so that nothing else changes.
export class Moment {
  constructor({ place, link }) {
    link.watch('representation:FrameInfo.time', '0.2s', (time) => { place.textContent = `live, ${time.toFixed(1)} s`; });
  }
}
