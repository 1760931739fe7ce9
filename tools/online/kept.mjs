// What a copy of the site keeps in the browser is by its folder, since a host may have several.
export const cacheOf = ({ pathname }, what) => `frame-by-frame ${pathname} ${what}`;
