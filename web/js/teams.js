// The teams' colours, one place for score board, buttons, shirts and labels. Left is blue and right is red, as
// everywhere in this league; teams whose names say the opposite exchange them.
const blue = 0x2f6fe8, red = 0xe0452f;
const says = (name, colour) => new RegExp(`(^|[^a-z])${colour}([^a-z]|$)`, 'i').test(name ?? '');

export const teamColours = { left: blue, right: red, none: 0x8b9499 };

export const cssColour = (colour) => `#${colour.toString(16).padStart(6, '0')}`;

// Whether teams of these names exchange the colours: one has the other's name and none has its own.
export function exchanged(left, right) {
  const against = says(left, 'red') || says(right, 'blue');
  return against && !says(left, 'blue') && !says(right, 'red');
}

// Takes the names; true when the colours are others now.
export function nameTeams(left, right) {
  const [l, r] = exchanged(left, right) ? [red, blue] : [blue, red];
  if (teamColours.left === l) return false;
  Object.assign(teamColours, { left: l, right: r });
  document.documentElement.style.setProperty('--left', cssColour(l));
  document.documentElement.style.setProperty('--right', cssColour(r));
  return true;
}
