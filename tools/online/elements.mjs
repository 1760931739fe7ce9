// An element with these properties, and what is inside.
export function make(name, properties = {}, ...inside) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...inside);
  return element;
}

export const makeButton = (textContent, act, more = {}) => make('button', { type: 'button', textContent, onclick: act, ...more });
